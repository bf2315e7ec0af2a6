#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

// What a run yields, as plain arrays. Right-handed frame, z up, the wearer faces -y, +x is the
// wearer's left; SI units unless a name says otherwise.
namespace loosefit::library {

/// A triangle surface: positions [m]; corners are indices, counter-clockwise seen from outside.
struct Surface {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// One sensor performance map (docs/maps.md).
struct MapArray {
  std::string array;           ///< as in drape.vtp, unit in the name: "distance_mm"
  std::string title;           ///< "Body-garment distance"
  std::string unit;            ///< "mm", "deg", "–"
  std::vector<double> values;  ///< per vertex; NaN where the map is not defined
};

/// One garment as it is worn.
struct Garment {
  Surface surface;
  std::vector<std::array<double, 2>> pattern_uv;  ///< per vertex: weft, warp in its panel [m]
  std::vector<int> panel;                         ///< per vertex: index into panel_names
  std::vector<std::string> panel_names;
  double mass = 0;             ///< with attachments [kg]
  std::vector<MapArray> maps;  ///< none of a sealed drape (Verdict::holds)

  /// The map of that name; null: there is none.
  const MapArray* find_map(const std::string& array) const;
};

/// Whether the drape counts, and why not (docs/theory/solver.md).
struct Verdict {
  bool settled = false, worn = false;
  bool holds = false;                     ///< settled and worn: maps are made without asking
  std::optional<bool> stable;             ///< a minimum of the energy; nothing: not tested
  double residual = 1;                    ///< net force over weight of the cloth [–]
  int intersections_body = -1;            ///< exact test; -1: not tested
  int intersections_self = -1;            ///< the same
  std::string stop_reason;                ///< "converged", "iteration limit", …
  std::vector<std::string> worn_reasons;  ///< why it is not worn
  std::optional<bool> can_be_put_on;      ///< without a fastening; nothing: not judged
  std::vector<std::string> can_be_put_on_reasons;  ///< why not, or why it is not judged
};

/// All of one run.
struct Outcome {
  Verdict verdict;
  std::vector<Garment> garments;  ///< the innermost first; the last one is studied
  Surface body;                   ///< the wearer
  std::string summary_json;       ///< the text of summary.json (docs/outputs.md)
  std::vector<std::string> warnings;

  const Garment& studied() const { return garments.back(); }
};

}  // namespace loosefit::library
