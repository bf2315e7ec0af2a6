#include "loosefit/io/scenario_wear.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/body/joint_postures.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/io/degrees_text.h"

// [postures] and [donning]: how the garment is worn.
namespace loosefit::io {

namespace {

constexpr double kLeastStep = 4;  ///< of a sweep [deg]: every angle is a drape

/// "elbow-flexion-0" … of one joint, evenly spaced; the last step may be shorter.
std::vector<std::string> read_sweep(ConfigReader table) {
  std::vector<std::string> joints;
  for (const body::JointMotion& motion : body::joint_motions()) joints.push_back(motion.name);
  table.only({"joint", "from", "to", "step"});
  table.require("joint", "a joint");
  const std::string joint = table.choice("joint", "", joints, "joint that is turned by itself");
  const body::JointMotion& motion =
      *std::ranges::find(body::joint_motions(), joint, &body::JointMotion::name);
  table.only_for("joint", {joint});
  const auto angle = [&](const char* key, const char* about) {
    table.require(key, "an angle");
    return *table.optional_number(key, {motion.low, motion.high, "degrees"}, about);
  };
  const double from = angle("from", "first angle"), to = angle("to", "last angle");
  table.require("step", "an angle");
  const double step =
      *table.optional_number("step", {kLeastStep, 180, "degrees"}, "between two angles");
  table.finish();
  const double span = std::abs(to - from);
  const int steps = static_cast<int>(std::ceil(span / step - 1e-9));
  std::vector<std::string> names;
  for (int i = 0; i <= steps; ++i) {
    const double turned = std::min(i * step, span);
    names.push_back(
        body::joint_posture_name({{joint, to >= from ? from + turned : from - turned}}));
  }
  return names;
}

}  // namespace

body::Posture posture_by_name(const std::string& name, const ConfigReader& table,
                              const std::string& key) {
  const std::vector<std::string> known = body::posture_names();
  const bool named = std::ranges::any_of(known, [&](const std::string& one) {
    return name == one || name.starts_with(one + "+");  // with joints turned besides
  });
  try {
    if (named || body::joint_angles(name)) return body::named_posture(name);
  } catch (const InvalidInput& error) {
    throw table.error(key, error.found(), error.expected(), error.hint());
  }
  throw table.error(
      key, toml_quoted(name),
      "texts from " + join(known) +
          ", or joints as in elbow-flexion-90, or both as in sitting+elbow-flexion-90",
      closest_match(name, known).empty() ? "" : did_you_mean(name, known));
}

std::string posture_pattern() {
  const std::string joints = body::joint_posture_pattern();
  return "^((" + join(body::posture_names(), "|") + ")(\\+" + joints + ")?|" + joints + ")$";
}

std::vector<std::string> read_postures_section(ConfigReader table) {
  table.only({"list", "sweep", "reference"});
  std::vector<std::string> list =
      table.texts("list", posture_pattern(), "postures that the garment follows", 1);
  for (const std::string& name : list) posture_by_name(name, table, "list");
  if (const auto sweep = table.optional_table("sweep", "angles of one joint, behind the list"))
    for (const std::string& name : read_sweep(*sweep))
      if (std::ranges::find(list, name) == list.end()) list.push_back(name);
  if (list.empty() && table.has("reference"))
    throw table.error("reference", "a list or a sweep beside it");
  const std::string reference = table.matching(
      "reference", posture_pattern(),
      "posture of the maps, in which sensors are calibrated; the first where absent");
  if (!reference.empty() && std::ranges::find(list, reference) == list.end())
    throw table.error("reference", "one of " + join(list),
                      closest_match(reference, list).empty() ? "" : did_you_mean(reference, list));
  table.finish();
  if (list.empty()) return list;
  if (!reference.empty())
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
  d.first_drawn = table.choice("first", "undisturbed", {"undisturbed", "drawn"},
                               "whether the first donning is drawn as the others are") == "drawn";
  d.repeats = static_cast<int>(
      table.integer("repeats", given && !movements_alone && !d.first_drawn ? kUsual : 1, 1,
                    scenario::kMostDonnings,
                    "times the garment is put on; 1 beside movements alone or a drawn first"));
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
  if (d.first_drawn && simulation.repeats > 1)
    throw table.error("first", "\"drawn\" beside simulation.repeats", "\"undisturbed\"",
                      "the repeats of [simulation] start near an undisturbed first drape");
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
  // Left out where it is as usual: what names the cases of studies stays as it was.
  if (d.first_drawn) text += "first = \"drawn\"\n";
  if (d.repeats > 1 || d.first_drawn)
    text += fmt::format(
        "movement_spread = {}\nshift = {}\ntwist_deg = {}\nfriction_spread = {}\nseed = {}\n",
        shortest(d.movement_spread), shortest(d.shift), degrees_text(d.twist),
        shortest(d.friction_spread), d.seed);
  return text;
}

}  // namespace loosefit::io
