#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/io/config_node.h"
#include "loosefit/io/config_reader.h"

namespace loosefit::study {

/// A sensor shifted from where it is asked for.
struct SiteShift {
  int site = 0;         ///< which [[site]] of the base scenario
  double u = 0, v = 0;  ///< along the cloth, in weft and warp of its panel [m]
};

/// One value of an axis: what it changes in the base scenario.
struct AxisLevel {
  std::string label;            ///< "person 3", "0.16", "denim"
  std::optional<double> value;  ///< where it lies on the axis, if that has an order
  /// Numbers against which results are correlated: "fit", "person.height".
  std::map<std::string, double> inputs;
  io::ConfigNode patch;              ///< table that is merged over the base scenario
  std::optional<double> chest_ease;  ///< garment girth less body girth at the chest [m], which
                                     ///< becomes a BGM once the wearer is known
  std::optional<SiteShift> shift;
};

/// What varies in a study.
struct Axis {
  std::string name;
  std::string kind;  ///< people, fabrics, ease, place, postures, donnings, levels, values, range
  bool sampled = false;           ///< levels are random draws, not values that were chosen
  bool stratified = false;        ///< spread evenly: they cover a population and are no sample
  bool each_case = false;         ///< a draw of its own for every case of the others
  std::vector<std::string> keys;  ///< of the scenario, for ease, values and range
  std::vector<AxisLevel> levels;
  bool is_people() const { return kind == "people"; }
  /// Whether levels differ by chance; histories of putting on do, though they are the same in every
  /// study.
  bool is_drawn() const { return (sampled || kind == "donnings") && levels.size() > 1; }
};

/// Reads one [[axis]] of a study file. \param draws how many draws a sampled axis has when the
/// design says so (Latin hypercube: its samples); 0: as many as the axis says.
/// \throws InvalidInput with file, line and key.
Axis read_axis(io::ConfigReader table, std::uint64_t study_seed, int draws);

/// The levels of an axis that is drawn anew for each of `count` cases: read_axis again with so many
/// draws. `node`: the table of the axis.
Axis read_axis_for_each_case(const io::ConfigNode& node, const std::string& file,
                             std::uint64_t study_seed, int count);

/// Ease at the bust that 70 women chose for garments that fit them best (KAKENHI 12680108): mean
/// and standard deviation [m] by garment.
struct ChosenEase {
  const char* garment;
  double mean, deviation;
};
const std::vector<ChosenEase>& chosen_ease();

}  // namespace loosefit::study
