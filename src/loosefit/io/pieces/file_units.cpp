#include "loosefit/io/pieces/file_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr double kMostInches = 50;  // of a piece that is as long as one in centimetres
constexpr double kShortest = 0.25, kLongest = 1.7;  // longest side of a garment's largest piece [m]

struct Unit {
  const char *name, *title;
  double metre;
  bool metric;
};
constexpr std::array<Unit, 4> kUnits{{{"mm", "millimetres", 0.001, true},
                                      {"cm", "centimetres", 0.01, true},
                                      {"m", "metres", 1, true},
                                      {"inch", "inches", 0.0254, false}}};

bool plausible(const Unit& unit, double extent) {
  return unit.metre * extent >= kShortest && unit.metre * extent <= kLongest;
}

std::string size_in(const Unit& unit, double extent) {
  return fmt::format("{:.3g} m in {}", unit.metre * extent, unit.title);
}

std::string sizes_in_all(double extent) {
  std::vector<std::string> sizes;
  for (const Unit& unit : kUnits) sizes.push_back(size_in(unit, extent));
  return join(sizes);
}

const Unit* claimed_unit(std::string claimed, std::optional<int> insunits) {
  std::transform(claimed.begin(), claimed.end(), claimed.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (claimed == "METRIC" || claimed == "MM") return &kUnits[0];
  if (claimed == "ENGLISH" || claimed == "INCH") return &kUnits[3];
  if (claimed == "CM") return &kUnits[1];
  if (!claimed.empty() || !insunits) return nullptr;
  return *insunits == 1   ? &kUnits[3]
         : *insunits == 4 ? &kUnits[0]
         : *insunits == 5 ? &kUnits[1]
         : *insunits == 6 ? &kUnits[2]
                          : nullptr;
}

/// CLO and Marvelous Designer export centimetres under ENGLISH.
bool written_in_centimetres(const std::string& maker) {
  for (const char* name : {"CLO ", "CLO3D", "Marvelous"})
    if ((maker + " ").find(name) != std::string::npos) return true;
  return false;
}

}  // namespace

const char* const kUnitNames = "mm, cm, m or inch";

FileUnits choose_units(const std::string& asked, const SaidUnits& says, double extent,
                       const std::string& file) {
  if (!asked.empty()) {
    for (const Unit& unit : kUnits)
      if (asked == unit.name) return {unit.metre, unit.title, {}};
    throw InvalidInput({{}, 0, "units"}, '"' + printable(asked) + '"', kUnitNames);
  }
  const std::string& claimed = says.claimed;
  const Unit* said = claimed_unit(claimed, says.insunits);
  const std::string words = claimed.empty() ? said ? "the header says " + std::string(said->title)
                                                   : std::string("the file does not name its units")
                                            : "the file says Units: " + printable(claimed);
  const auto refuse = [&](const std::string& expected) {
    throw InvalidInput(
        {file, 0, "units"},
        fmt::format("a largest piece of {:.6g} file units, {}", extent, sizes_in_all(extent)),
        expected,
        words + "; name the unit: --units " + kUnitNames + ", in a scenario garment.units");
  };
  const auto taken_as = [&](const Unit& unit, const std::string& why) -> FileUnits {
    return {
        unit.metre, unit.title,
        fmt::format("units: {}{}; taken as {}, in which it is {:.3g} m (--units says otherwise)",
                    words, why, unit.title, unit.metre * extent)};
  };
  const Unit& cm = kUnits[1];
  if (said && plausible(*said, extent)) {
    if (said->metric) return {said->metre, said->title, {}};
    if (written_in_centimetres(says.maker)) {
      const std::string maker =
          "the program that wrote it, " + printable(says.maker, 60) + ", writes centimetres";
      if (plausible(cm, extent)) return taken_as(cm, ", under which " + maker);
      refuse(fmt::format("{:g} to {:g} m in centimetres: under what the file says {}", kShortest,
                         kLongest, maker));
    }
    if (!plausible(cm, extent)) return {said->metre, said->title, {}};
    if (extent > kMostInches)
      refuse(fmt::format("no more than {:g} inches where centimetres make a garment as well",
                         kMostInches));
    return taken_as(*said,
                    ", under which some programs write centimetres, which would make the "
                    "largest piece " +
                        size_in(cm, extent));
  }
  // The same system first: a file in centimetres says METRIC.
  std::vector<const Unit*> fitting;
  for (const bool same : {true, false}) {
    if (!fitting.empty()) break;
    for (const Unit& unit : kUnits)
      if ((!same || (said && unit.metric == said->metric)) && plausible(unit, extent))
        fitting.push_back(&unit);
  }
  if (fitting.size() != 1)
    refuse(fmt::format("{:g} to {:g} m in one of them", kShortest, kLongest));
  return taken_as(*fitting[0], said ? ", in which the largest piece would be " +
                                          fmt::format("{:.3g} m", said->metre * extent)
                                    : "");
}

}  // namespace loosefit::io
