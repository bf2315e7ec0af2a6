#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/io/scenario_sections.h"

namespace loosefit {
namespace {

const NumberRange kFraction{0, 1, "a fraction"};

const std::vector<std::pair<std::string, Posture>>& named_postures() {
  static const std::vector<std::pair<std::string, Posture>> kTable = {
      {"standing", {radians(25.0), 0, 0}},
      {"a-pose", {radians(40.0), 0, 0}},
      {"sitting", {radians(25.0), 0, 1}},
      {"forward-bend", {radians(25.0), radians(30.0), 0}},
  };
  return kTable;
}

Posture named_posture(ConfigReader& body, const std::string& key) {
  std::vector<std::string> names;
  for (const auto& entry : named_postures()) names.push_back(entry.first);
  const std::string wanted = body.choice(key, "standing", names);
  for (const auto& [name, posture] : named_postures())
    if (name == wanted) return posture;
  return {};
}

// A name, or a table of angles whose missing entries are those of standing.
Posture read_posture(ConfigReader& body, const std::string& key, const Posture& fallback) {
  const ConfigNode* node = body.node(key);
  if (!node) return fallback;
  if (node->kind == ConfigNode::Kind::text) return named_posture(body, key);
  if (node->kind != ConfigNode::Kind::table)
    throw body.error(key, "a posture in quotes or a table of angles");
  ConfigReader table = body.table(key);
  Posture posture;
  posture.arm_abduction = radians(table.number("arm_abduction_deg", 25, {5, 90, "degrees"}));
  posture.forward_bend = radians(table.number("forward_bend_deg", 0, {-20, 90, "degrees"}));
  posture.sitting = table.number("sitting", 0, kFraction);
  table.finish();
  return posture;
}

double read_sex(ConfigReader& body) {
  const ConfigNode* node = body.node("sex");
  const bool is_text = node && node->kind == ConfigNode::Kind::text;
  if (is_text) return body.choice("sex", "", {"female", "male"}) == "male" ? 1 : 0;
  return body.number("sex", 0, {0, 1, "\"female\", \"male\" or a number"});
}

ScenarioBody read_body_file(ConfigReader& table) {
  ScenarioBody body;
  body.file = existing_file(table, "file");
  body.units = table.choice("units", "", {"m", "cm", "mm", "in"});
  body.up = table.choice("up", "", {"z", "y"});
  for (const std::string& key : table.keys())
    if (key != "file" && key != "units" && key != "up")
      throw table.error(key, "only file, units and up for a body file",
                        "a scan brings its own size and posture");
  return body;
}

}  // namespace

ScenarioBody read_body_section(ConfigReader table) {
  if (table.has("file")) return read_body_file(table);
  for (const char* key : {"units", "up"})
    if (table.has(key)) throw table.error(key, std::string(key) + " only beside file");
  ScenarioBody body;
  body.sex = read_sex(table);
  body.age = table.number("age", body.age, {3, 90, "years"});
  body.height = table.number("height", body.height, {0.7, 2.3, "metres"});
  ConfigReader wishes = table.table("measurements");
  if (wishes.has("height")) throw wishes.error("height", "height as a key of [body] itself");
  for (const std::string& name : measure_names())
    if (const auto wish = wishes.optional_number(name, {0.08, 2.0, "metres"}))
      body.measurements[name] = *wish;
  wishes.finish();
  body.muscle = table.number("muscle", body.muscle, kFraction);
  body.proportions = table.number("proportions", body.proportions, kFraction);
  body.cup = table.number("cup", body.cup, kFraction);
  body.firmness = table.number("firmness", body.firmness, kFraction);
  body.posture = read_posture(table, "posture", body.posture);
  body.dress_posture = read_posture(table, "dress_posture", default_dress_posture(body.posture));
  table.finish();
  return body;
}

}  // namespace loosefit
