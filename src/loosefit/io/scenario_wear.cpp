#include "loosefit/io/scenario_wear.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/io/degrees_text.h"

// [postures] and [donning]: how the garment is worn.
namespace loosefit::io {

std::vector<std::string> read_postures_section(ConfigReader table, ConfigReader body) {
  table.only({"list", "reference"});
  std::vector<std::string> list =
      table.choices("list", {}, body::posture_names(), "postures that the garment follows", 1);
  if (table.lacks("reference", "list"))
    throw table.error("reference",
                      "an array of at least one posture from " + join(body::posture_names()));
  const std::string reference = table.choice(
      "reference", list.empty() ? "" : list.front(), list.empty() ? body::posture_names() : list,
      "posture of the maps, in which sensors are calibrated; the first where absent");
  table.finish();
  if (list.empty()) return list;
  if (body.has("file"))
    throw table.error("list", "postures of a scanned body", "a parametric person",
                      "a scan keeps the posture it was taken in");
  std::rotate(list.begin(), std::find(list.begin(), list.end(), reference), list.end());
  return list;
}

scenario::ScenarioDonning read_donning_section(ConfigReader table, bool given,
                                               const scenario::ScenarioSimulation& simulation) {
  constexpr int kUsual = 4;
  scenario::ScenarioDonning d;
  // A section that tells of movements alone asks for no repeats.
  bool repeated = false;
  for (const char* key : {"shift", "twist_deg", "friction_spread", "movement_spread", "seed"})
    repeated = repeated || table.has(key);
  const bool movements_alone = table.has("movements") && !repeated;
  d.repeats =
      static_cast<int>(table.integer("repeats", given && !movements_alone ? kUsual : 1, 1, 100,
                                     "times the garment is put on; 1 beside movements alone"));
  d.movements = table.choices("movements", d.movements,
                              {scenario::kMovementNames.begin(), scenario::kMovementNames.end()},
                              "what the wearer does once the garment is on, in this order");
  d.movement_spread = table.number("movement_spread", d.movement_spread, {0, 0.5, "a fraction"},
                                   "standard deviation of the logarithm of their sizes");
  d.shift = table.number("shift", d.shift, {0, 0.05, "metres"},
                         "of the garment along each axis, to either side");
  d.twist = radians(table.number("twist_deg", 10, {0, 30, "degrees"},
                                 "of the garment on the trunk, to either side"));
  d.friction_spread = table.number("friction_spread", d.friction_spread, {0, 0.5, "a fraction"},
                                   "standard deviation of the logarithm of friction");
  d.seed = static_cast<std::uint64_t>(
      table.integer("seed", static_cast<long long>(simulation.seed), 0, 1LL << 53,
                    "of all that is random here; that of [simulation] where absent"));
  if (d.repeats > 1 && simulation.repeats > 1)
    throw table.error("repeats", fmt::format("{} beside simulation.repeats", d.repeats),
                      "repeats in one of the two",
                      "donnings are repeats of drape and postures with larger disturbances");
  table.finish();
  return d;
}

std::string wear_toml(const scenario::Scenario& scenario) {
  std::string text;
  if (!scenario.postures.empty()) {
    std::vector<std::string> names;
    for (const std::string& name : scenario.postures) names.push_back(toml_quoted(name));
    text += fmt::format("\n[postures]\nlist = [{}]\nreference = {}\n", join(names), names.front());
  }
  const scenario::ScenarioDonning& d = scenario.donning;
  std::vector<std::string> movements;
  for (const std::string& name : d.movements) movements.push_back(toml_quoted(name));
  text += fmt::format("\n[donning]\nmovements = [{}]\nrepeats = {}\n", join(movements), d.repeats);
  if (d.repeats > 1)
    text += fmt::format(
        "movement_spread = {}\nshift = {}\ntwist_deg = {}\nfriction_spread = {}\nseed = {}\n",
        shortest(d.movement_spread), shortest(d.shift), degrees_text(d.twist),
        shortest(d.friction_spread), d.seed);
  return text;
}

}  // namespace loosefit::io
