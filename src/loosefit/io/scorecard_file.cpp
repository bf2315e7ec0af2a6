#include "loosefit/io/scorecard_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/body/regions.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/placement/derived_metrics.h"

namespace loosefit::io {
namespace {

const NumberRange kLimits{-1e6, 1e6, "a number"};

std::string required_text(ConfigReader& table, const std::string& key, const char* expected) {
  const std::string text = table.text(key, "");
  if (text.empty()) throw table.error(key, expected);
  return text;
}

double required(ConfigReader& table, const std::string& key, const NumberRange& range) {
  const auto value = table.optional_number(key, range);
  if (!value)
    throw table.error(key, fmt::format("{} from {:g} to {:g}", range.what, range.low, range.high));
  return *value;
}

placement::FootprintShape read_footprint(ConfigReader& table) {
  using Kind = placement::FootprintShape::Kind;
  static const std::vector<std::pair<std::string, Kind>> kShapes = {{"disc", Kind::disc},
                                                                    {"rectangle", Kind::rectangle},
                                                                    {"line", Kind::line},
                                                                    {"girth", Kind::girth}};
  std::vector<std::string> names;
  for (const auto& shape : kShapes) names.push_back(shape.first);
  const std::string shape = table.choice("shape", "disc", names);
  placement::FootprintShape footprint;
  for (const auto& [name, kind] : kShapes)
    if (name == shape) footprint.kind = kind;
  table.only({"shape", "radius", "width", "length", "axis"});
  const NumberRange half{5e-4, 0.2, "metres"}, whole{1e-3, 1, "metres"};
  if (footprint.kind == Kind::disc) footprint.radius = required(table, "radius", half);
  if (footprint.kind == Kind::line) footprint.length = required(table, "length", whole);
  if (footprint.kind == Kind::rectangle)
    footprint.size = {required(table, "width", whole), required(table, "length", whole)};
  table.finish();
  return footprint;
}

std::map<std::string, double> read_parameters(ConfigReader table) {
  std::map<std::string, double> values;
  for (const placement::SensorParameter& p : placement::sensor_parameters())
    if (const auto value = table.optional_number(p.name, {p.low, p.high, p.unit}))
      values[p.name] = *value;
  table.finish();
  return values;
}

/// One number, or [low, high] of a range.
std::vector<double> limits(ConfigReader& table, const std::string& key) {
  const ConfigNode* node = table.node(key);
  if (!node) throw table.error(key, "a number, or [low, high] of a range");
  if (node->kind != ConfigNode::Kind::array) return {table.number(key, 0, kLimits)};
  const std::vector<double> pair = table.numbers(key, kLimits);
  if (pair.size() != 2) throw table.error(key, "a number, or [low, high] of a range");
  return pair;
}

void read_ramps(ConfigReader& table, placement::Criterion& criterion) {
  const std::vector<double> good = limits(table, "good"), fail = limits(table, "fail");
  if (good.size() != fail.size())
    throw table.error("fail", good.size() == 1 ? "a number, as good is" : "[low, high], as good is",
                      "a range needs four limits: fail below, good, good, fail above");
  if (good.size() == 1) {
    if (good[0] == fail[0])
      throw table.error("fail", "another number than good",
                        "more is better when good is above fail, less is better when below");
    criterion.limit = {good[0], fail[0]};
    return;
  }
  if (good[0] > good[1])
    throw table.error("good", "[low, high], the lower one first",
                      "more or less is better alone: give a number each for good and fail");
  if (!(fail[0] < good[0] && good[1] < fail[1]))
    throw table.error("fail", fmt::format("[below {:g}, above {:g}]", good[0], good[1]),
                      "fail below < good from <= good to < fail above");
  criterion.limit = {good[0], fail[0]};
  criterion.upper = placement::Ramp{good[1], fail[1]};
}

placement::Criterion read_criterion(ConfigReader& table, bool of_lines,
                                    const std::map<std::string, double>& parameters) {
  table.only({"metric", "unit", "good", "fail", "reason", "reason_above", "source"});
  placement::Criterion criterion;
  criterion.metric = required_text(table, "metric", "the name of a metric");
  const placement::MetricName* metric = placement::find_metric(criterion.metric);
  std::vector<std::string> names;
  for (const placement::MetricName& m :
       of_lines ? placement::line_vocabulary() : placement::metric_vocabulary())
    names.push_back(m.name);
  if (std::find(names.begin(), names.end(), criterion.metric) == names.end())
    throw table.error("metric", "the name of a metric", did_you_mean(criterion.metric, names));
  if (required_text(table, "unit", "the unit of the limits in quotes") != metric->unit)
    throw table.error("unit", "\"" + metric->unit + "\"",
                      "limits stand in the unit of the metric: " + metric->words);
  for (const std::string& parameter : placement::parameters_of(criterion.metric))
    if (!parameters.count(parameter))
      throw table.error("metric", "sensor." + parameter + " beside it",
                        criterion.metric + " is computed with it: [sensor] " + parameter + " = …");
  read_ramps(table, criterion);
  criterion.reason = required_text(table, "reason", "what is wrong when this limits");
  if (criterion.upper)
    criterion.reason_above = required_text(table, "reason_above", "what is wrong above the range");
  criterion.source = required_text(table, "source", "where the numbers come from");
  table.finish();
  return criterion;
}

std::filesystem::path scorecard_folder(bool of_lines) {
  const std::filesystem::path all = data_directory() / "scorecards";
  return of_lines ? all / "lines" : all;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::vector<std::string> scorecard_names() { return names_in(scorecard_folder(false)); }

std::vector<std::string> line_scorecard_names() { return names_in(scorecard_folder(true)); }

placement::Scorecard load_scorecard(const std::string& name_or_path, bool of_lines) {
  if (std::filesystem::path(name_or_path).extension() == ".toml") {
    const placement::Scorecard card = read_scorecard_file(name_or_path);
    if (card.of_lines != of_lines)
      throw InvalidInput({name_or_path, 0, "judges"}, card.of_lines ? "lines" : "places",
                         of_lines ? "lines" : "places",
                         "places and lines have scorecards of their own (docs/scorecards.md)");
    return card;
  }
  const std::vector<std::string> names = names_in(scorecard_folder(of_lines));
  if (names.empty())
    throw IoError((data_directory() / "scorecards").string() + ": found no scorecards",
                  looked_in() + "; set LOOSEFIT_DATA to the folder that holds scorecards/");
  if (std::find(names.begin(), names.end(), name_or_path) == names.end())
    throw InvalidInput({"", 0, "modality"}, "\"" + printable(name_or_path) + "\"",
                       "the name of a scorecard, or the path of a .toml file",
                       did_you_mean(name_or_path, names));
  return read_scorecard_file(scorecard_folder(of_lines) / (name_or_path + ".toml"));
}

placement::Scorecard read_scorecard_file(const std::filesystem::path& path) {
  return parse_scorecard(read_toml_text(path.string()), path.string());
}

placement::Scorecard parse_scorecard(const std::string& text, const std::string& file) {
  const ConfigNode root = parse_toml(text, file);
  ConfigReader table(root, file);
  table.only({"title", "about", "judges", "pass", "regions", "footprint", "sensor", "criterion"});
  placement::Scorecard card;
  card.name = std::filesystem::path(file).stem().string();
  card.title = required_text(table, "title", "what the sensor is");
  card.about = required_text(table, "about", "what is judged, and what is not");
  card.pass = table.number("pass", card.pass, {0.01, 1, "a score"});
  card.of_lines = table.choice("judges", "places", {"places", "lines"}) == "lines";
  if (!card.of_lines && !table.has("footprint"))
    throw table.error("footprint", "what the sensor covers",
                      "[footprint] shape = \"disc\", radius = 0.012");
  if (card.of_lines)
    for (const char* key : {"footprint", "regions", "sensor"})
      if (table.has(key))
        throw table.error(key, "no such key beside judges = \"lines\"",
                          "a line says itself where it runs");
  for (const std::string& region : table.choices("regions", {}, body::region_names()))
    card.regions.push_back(*body::find_region(region));
  if (!card.of_lines) {
    ConfigReader footprint = table.table("footprint");
    card.around = footprint.choice("axis", "along", {"along", "around"}) == "around";
    card.footprint = read_footprint(footprint);
    card.parameters = read_parameters(table.table("sensor"));
  }
  for (ConfigReader& criterion : table.tables("criterion"))
    card.criteria.push_back(read_criterion(criterion, card.of_lines, card.parameters));
  if (card.criteria.empty()) throw table.error("criterion", "at least one [[criterion]]");
  table.finish();
  return card;
}

}  // namespace loosefit::io
