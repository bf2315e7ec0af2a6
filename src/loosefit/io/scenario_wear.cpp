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
  std::vector<std::string> list = table.choices("list", {}, body::posture_names());
  if (list.empty()) {
    for (const char* key : {"list", "reference"})
      if (table.has(key))
        throw table.error(key,
                          "an array of at least one posture from " + join(body::posture_names()));
    table.finish();
    return list;
  }
  if (body.has("file"))
    throw table.error("list", "postures of a scanned body", "a parametric person",
                      "a scan keeps the posture it was taken in");
  const std::string reference = table.choice("reference", list.front(), list);
  std::rotate(list.begin(), std::find(list.begin(), list.end(), reference), list.end());
  table.finish();
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
      static_cast<int>(table.integer("repeats", given && !movements_alone ? kUsual : 1, 1, 100));
  d.movements = table.choices("movements", d.movements,
                              {scenario::kMovementNames.begin(), scenario::kMovementNames.end()});
  d.movement_spread = table.number("movement_spread", d.movement_spread, {0, 0.5, "a fraction"});
  d.shift = table.number("shift", d.shift, {0, 0.05, "metres"});
  d.twist = radians(table.number("twist_deg", 10, {0, 30, "degrees"}));
  d.friction_spread = table.number("friction_spread", d.friction_spread, {0, 0.5, "a fraction"});
  d.seed = static_cast<std::uint64_t>(
      table.integer("seed", static_cast<long long>(simulation.seed), 0, 1LL << 53));
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
