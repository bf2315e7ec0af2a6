#include "loosefit/io/scenario_body.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/body/plausible_measures.h"
#include "loosefit/io/existing_file.h"
#include "loosefit/io/scenario_wear.h"

namespace loosefit::io {
namespace {

const NumberRange kFraction{0, 1, "a fraction"};

// A name, or a table of angles whose missing entries are those of standing.
body::Posture read_posture(ConfigReader& body, const std::string& key,
                           const body::Posture& fallback) {
  const ConfigNode* node = body.node(key);
  if (!node) return fallback;
  if (node->kind == ConfigNode::Kind::text)
    return posture_by_name(body.matching(key, posture_pattern(), ""), body, key);
  if (node->kind != ConfigNode::Kind::table)
    throw body.error(key, "a posture in quotes or a table of angles");
  ConfigReader table = body.table(key);
  body::Posture posture = body::kStanding;
  if (const auto aside =
          table.optional_number("arm_abduction_deg", {5, 90, "degrees"}, "upper arms aside",
                                std::round(degrees(posture.arm_abduction))))
    posture.arm_abduction = radians(*aside);
  posture.forward_bend =
      radians(table.number("forward_bend_deg", 0, {-20, 90, "degrees"}, "lean of the back"));
  posture.sitting = table.number("sitting", 0, kFraction, "0 standing, 1 sitting");
  posture.arm_flexion =
      radians(table.number("arm_flexion_deg", 0, {-40, 180, "degrees"},
                           "the arms, so far aside, raised forward against the trunk"));
  // A flexed elbow is told from a straight arm.
  const bool flexed = table.has("elbow_flexion_deg");
  posture.elbow_extension =
      table.number("elbow_extension", flexed ? 1 : posture.elbow_extension, kFraction,
                   "share of the body's bent elbow that is straightened");
  posture.slouch = table.number("slouch", 0, kFraction, "0 upright, 1 slumped");
  posture.relaxed_arms =
      table.number("relaxed_arms", posture.relaxed_arms, kFraction,
                   "0: arms turned as the body model has them, at the angle asked for; 1: relaxed, "
                   "and no closer than they have room");
  const auto turned = [&](const char* joint, double low, double high, const char* about) {
    return radians(table.number(joint, 0, {low, high, "degrees"}, about));
  };
  posture.elbow_flexion = turned("elbow_flexion_deg", 0, 130,
                                 "beyond what elbow_extension leaves, which is 1 beside it");
  posture.wrist_flexion = turned("wrist_flexion_deg", -70, 80, "hand to the palm");
  posture.hip_flexion = turned("hip_flexion_deg", -15, 100, "thighs forward");
  posture.knee_flexion = turned("knee_flexion_deg", 0, 120, "heels back");
  posture.left_hip_flexion =
      turned("left_hip_flexion_deg", -15, 100, "the left thigh, beyond both");
  posture.right_hip_flexion =
      turned("right_hip_flexion_deg", -15, 100, "the right thigh, beyond both");
  posture.left_knee_flexion =
      turned("left_knee_flexion_deg", 0, 120, "the left heel back, beyond both");
  posture.right_knee_flexion =
      turned("right_knee_flexion_deg", 0, 120, "the right heel back, beyond both");
  posture.trunk_rotation = turned("trunk_rotation_deg", -45, 45, "shoulders to the wearer's left");
  posture.side_bend = turned("side_bend_deg", -35, 35, "to the wearer's left");
  table.finish();
  return posture;
}

double read_sex(ConfigReader& body) {
  body.declare("sex", "0 female, 1 male; 0.4 for children before puberty", "female");
  const ConfigNode* node = body.node("sex");
  const bool is_text = node && node->kind == ConfigNode::Kind::text;
  if (is_text) return body.choice("sex", "", {"female", "male"}) == "male" ? 1 : 0;
  return body.optional_number("sex", {0, 1, "\"female\", \"male\" or a number"}).value_or(0);
}

/// posture and dress_posture; `postures`: of [postures], the first of which is that of the maps.
void read_stance(ConfigReader& table, const std::vector<std::string>& postures,
                 scenario::ScenarioBody& body) {
  const body::Posture listed =
      postures.empty() ? body.posture : body::named_posture(postures.front());
  table.declare("posture",
                "in which the maps are made: a name or a table of angles; of a file its own where "
                "absent",
                "standing");
  body.posture = read_posture(table, "posture", listed);
  if (!postures.empty() && !(body.posture == listed))
    throw table.error("posture", "another posture than that of [postures]",
                      "\"" + postures.front() + "\", the reference of [postures]",
                      "leave it out: the reference posture is that of the maps");
  table.declare("dress_posture", "in which the garment is put on: a name or a table of angles");
  body.dress_posture =
      read_posture(table, "dress_posture", body::default_dress_posture(body.posture));
}

scenario::ScenarioBody read_body_file(ConfigReader& table,
                                      const std::vector<std::string>& postures) {
  scenario::ScenarioBody body;
  body.file = existing_file(table, "file", "scanned surface of one person: OBJ, PLY or STL");
  table.require("file", "a file");
  body.units = table.choice("units", "", {"m", "cm", "mm", "in"},
                            "of the file; inferred, with a warning, where absent");
  body.up = table.choice("up", "", {"z", "y"},
                         "axis of the file; inferred, with a warning, where absent");
  constexpr const char* kKnown[] = {"file", "units", "up", "posture", "dress_posture"};
  for (const std::string& key : table.keys())
    if (std::ranges::find(kKnown, key) == std::end(kKnown))
      throw table.error(key, "only file, units, up, posture and dress_posture for a body file",
                        "a scan brings its own size");
  body.as_scanned = postures.empty() && !table.has("posture");
  if (body.as_scanned && table.has("dress_posture"))
    throw table.error("dress_posture", "it beside posture",
                      "a scan without a posture keeps that in which it was taken");
  if (!body.as_scanned) read_stance(table, postures, body);
  table.finish();
  return body;
}

}  // namespace

NumberRange age_range() { return {3, 90, "years"}; }

NumberRange measure_range(const std::string& name) {
  const body::PlausibleMeasure& range = body::plausible_measure(name);
  return {range.low, range.high, "metres"};
}

scenario::ScenarioBody read_body_section(ConfigReader table,
                                         const std::vector<std::string>& postures) {
  if (table.has("file")) return read_body_file(table, postures);
  for (const char* key : {"units", "up"})
    if (table.has(key)) throw table.error(key, std::string(key) + " only beside file");
  scenario::ScenarioBody body;
  body.sex = read_sex(table);
  body.age = table.number("age", body.age, age_range(), "age of the person");
  body.height = table.number("height", body.height, measure_range("height"), "stature");
  ConfigReader wishes =
      table.table("measurements", "wished tape measures; the body is fitted to any subset");
  if (wishes.has("height")) throw wishes.error("height", "height as a key of [body] itself");
  for (const std::string& name : body::measure_names())
    if (name == "height")
      continue;
    else if (const auto wish =
                 wishes.optional_number(name, measure_range(name), "tape measure: " + name))
      body.measurements[name] = *wish;
  wishes.finish();
  body.muscle = table.number("muscle", body.muscle, kFraction, "shape that no tape measure fixes");
  body.proportions =
      table.number("proportions", body.proportions, kFraction, "shape that no tape measure fixes");
  body.cup = table.number("cup", body.cup, kFraction, "shape that no tape measure fixes");
  body.firmness =
      table.number("firmness", body.firmness, kFraction, "shape that no tape measure fixes");
  read_stance(table, postures, body);
  table.finish();
  return body;
}

}  // namespace loosefit::io
