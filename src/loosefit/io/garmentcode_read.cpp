#include "loosefit/io/garmentcode_read.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/elastic_table.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/garmentcode_cleanup.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/io/garmentcode_merge.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;  // panels stay in the order of the file

constexpr std::size_t kLargestFile = 32u << 20;  // bytes
constexpr std::size_t kMostPanels = 500, kMostEdges = 5000, kMostEdgesInAll = 50'000;
constexpr double kLargestNumber = 1e7;

/// A JSON value with its path, so that every complaint can say where it stands.
struct Node {
  const Json& value;
  std::string path;
  const std::string& file;

  [[noreturn]] void fail(const std::string& found, const std::string& expected,
                         const std::string& hint = {}) const {
    throw InvalidInput(InputPlace{file, 0, path}, found, expected, hint);
  }
  std::string describe() const {
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    return printable(value.dump(-1, ' ', true, Json::error_handler_t::replace), 40);
  }
  const Node& object() const {
    if (!value.is_object()) fail(describe(), "an object");
    return *this;
  }
  const Node& array(std::size_t low, std::size_t high) const {
    if (!value.is_array() || value.size() < low || value.size() > high)
      fail(describe(), low == high ? fmt::format("an array of {}", low)
                                   : fmt::format("an array of {} to {}", low, high));
    return *this;
  }
  bool has(const std::string& key) const {
    return value.is_object() && value.contains(key) && !value.at(key).is_null();
  }
  Node at(const std::string& key) const {
    object();
    const auto it = value.find(key);
    if (it == value.end())
      throw InvalidInput(InputPlace{file, 0, path.empty() ? key : path + "." + key}, "nothing",
                         "this key");
    return {*it, path.empty() ? key : path + "." + key, file};
  }
  Node item(std::size_t i) const { return {value[i], fmt::format("{}[{}]", path, i), file}; }
  double number() const {
    if (!value.is_number()) fail(describe(), "a number");
    const double x = value.get<double>();
    if (!std::isfinite(x) || std::abs(x) > kLargestNumber)
      fail(describe(), fmt::format("a number of at most {:g}", kLargestNumber));
    return x;
  }
  double within(double low, double high) const {
    const double x = number();
    if (!(x >= low && x <= high)) fail(describe(), fmt::format("{:g} to {:g}", low, high));
    return x;
  }
  int index(int count, const std::string& of) const {
    const double x = value.is_number() ? value.get<double>() : std::nan("");
    if (!(x >= 0 && x < count && x == std::floor(x)))
      fail(describe(), fmt::format("an index of {} from 0 to {}", of, count - 1));
    return static_cast<int>(x);
  }
  bool flag() const {
    if (value.is_boolean()) return value.get<bool>();
    const double x = number();
    if (x != 0 && x != 1) fail(describe(), "0 or 1");
    return x == 1;
  }
  std::string text() const {
    if (!value.is_string()) fail(describe(), "a text");
    const std::string s = value.get<std::string>();
    if (s.size() > 200) fail(fmt::format("a text of {} bytes", s.size()), "at most 200");
    return s;
  }
  std::string optional_text(const std::string& key) const {
    return has(key) ? at(key).text() : std::string();
  }
  Vec2 pair() const {
    array(2, 2);
    return {item(0).number(), item(1).number()};
  }
  Vec3 triple() const {
    array(3, 3);
    return {item(0).number(), item(1).number(), item(2).number()};
  }
};

/// Units and conventions of one file.
struct FileRules {
  double metre = 0.01;  // file unit in metres
  bool absolute_curves = false;
};

pattern::EdgeCurve read_curve(const Node& node, const Vec2& a, const Vec2& b,
                              const FileRules& rules) {
  pattern::EdgeCurve curve;
  const Vec2 chord = b - a, left(-chord.y(), chord.x());
  const auto relative = [&](const Vec2& uv) -> Vec2 { return a + uv.x() * chord + uv.y() * left; };
  if (node.value.is_array()) {  // old files
    const Vec2 control = node.pair();
    curve.kind = pattern::EdgeCurve::Kind::quadratic;
    curve.control = {rules.absolute_curves ? Vec2(control * rules.metre) : relative(control)};
    return curve;
  }
  const Node type = node.object().at("type"), params = node.at("params");
  const std::string kind = type.text();
  if (kind == "quadratic") {
    curve.kind = pattern::EdgeCurve::Kind::quadratic;
    params.array(1, 1);
  } else if (kind == "cubic") {
    curve.kind = pattern::EdgeCurve::Kind::cubic;
    params.array(2, 2);
  } else if (kind == "circle") {
    curve.kind = pattern::EdgeCurve::Kind::circle;
    params.array(3, 3);
    curve.radius = params.item(0).number() * rules.metre;
    if (!(curve.radius > 0)) params.item(0).fail(params.item(0).describe(), "a positive radius");
    curve.large_arc = params.item(1).flag();
    curve.sweep = params.item(2).flag();
    return curve;
  } else {
    type.fail('"' + printable(kind) + '"', "quadratic, cubic or circle",
              did_you_mean(kind, {"quadratic", "cubic", "circle"}));
  }
  for (std::size_t i = 0; i < params.value.size(); ++i)
    curve.control.push_back(relative(params.item(i).pair()));
  return curve;
}

pattern::EdgeElastic read_elastic(const Node& node, const FileRules& rules) {
  const auto within = [&](const char* key, const NumberRange& range, double unit) {
    return node.at(key).within(range.low / unit, range.high / unit) * unit;
  };
  pattern::EdgeElastic elastic;
  elastic.ratio = within("ratio", kElasticRatio, 1);
  elastic.stiffness = within("stiffness", kElasticStiffness, 1);
  elastic.width = within("width", kElasticWidth, rules.metre);
  if (node.has("linear_density"))  // absent in early files
    elastic.linear_density = within("linear_density", kElasticDensity, 1);
  return elastic;
}

pattern::Panel read_panel(const std::string& name, const Node& node, const FileRules& rules,
                          std::vector<std::string>& warnings) {
  pattern::Panel panel;
  panel.name = name;
  node.object();
  panel.label = node.optional_text("label");
  if (node.has(kClothKey)) {
    const Node cloth = node.at(kClothKey).object();
    panel.cloth = {cloth.at("mass").within(0.01, 100), cloth.at("membrane").within(0.01, 1e4),
                   cloth.at("bending").within(1, 1e4)};
  }
  if (node.has(kHolesKey)) {
    const Node holes = node.at(kHolesKey).array(0, kMostEdges);
    for (std::size_t i = 0; i < holes.value.size(); ++i) {
      const Node hole = holes.item(i).object();
      const Node points = hole.at("points").array(3, kMostEdges);
      panel.holes.push_back({pattern::free_hole_name(hole.optional_text("name"), panel.holes), {}});
      for (std::size_t k = 0; k < points.value.size(); ++k)
        panel.holes.back().points.push_back(points.item(k).pair() * rules.metre);
    }
  }
  const Node vertices = node.at("vertices").array(2, 2 * kMostEdges);
  for (std::size_t i = 0; i < vertices.value.size(); ++i)
    panel.vertices.push_back(vertices.item(i).pair() * rules.metre);
  const Node edges = node.at("edges").array(2, kMostEdges);
  for (std::size_t i = 0; i < edges.value.size(); ++i) {
    const Node item = edges.item(i);
    const Node ends = item.object().at("endpoints").array(2, 2);
    pattern::PanelEdge edge;
    const int count = static_cast<int>(panel.vertices.size());
    edge.start = ends.item(0).index(count, "a vertex");
    edge.end = ends.item(1).index(count, "a vertex");
    edge.name = item.optional_text("name");
    edge.label = item.optional_text("label");
    if (item.has(kFinishKey))
      edge.finish = item.at(kFinishKey).within(0, 0.1 / rules.metre) * rules.metre;
    if (item.has(kElasticKey)) edge.elastic = read_elastic(item.at(kElasticKey), rules);
    if (item.has("curvature"))
      edge.curves = {read_curve(item.at("curvature"), panel.vertices[edge.start],
                                panel.vertices[edge.end], rules)};
    panel.edges.push_back(edge);
  }
  const auto pose = [&](const char* key) -> Vec3 {
    if (node.has(key)) return node.at(key).triple();
    warnings.push_back(fmt::format("{}.{}{}", node.path, key, kMissingPose));
    return Vec3::Zero();
  };
  panel.translation = frame_from_y_up() * pose("translation") * rules.metre;
  panel.rotation = frame_from_y_up() * rotation_from_euler_deg(pose("rotation"));
  return panel;
}

pattern::Stitch read_stitch(const Node& node, const pattern::Pattern& pattern) {
  node.array(2, 3);
  pattern::Stitch stitch;
  for (int side = 0; side < 2; ++side) {
    const Node item = node.item(side).object();
    pattern::Stitch::Side& target = side == 0 ? stitch.first : stitch.second;
    const Node panel = item.at("panel");
    target.panel = pattern.find_panel(panel.text());
    if (target.panel < 0) {
      std::vector<std::string> names;
      for (const pattern::Panel& p : pattern.panels) names.push_back(p.name);
      panel.fail(panel.describe(), "the name of a panel", did_you_mean(panel.text(), names));
    }
    const int edges = static_cast<int>(pattern.panels[target.panel].edges.size());
    target.edge = item.at("edge").index(edges, "an edge");
    if (side == 0) stitch.name = item.optional_text("name");
  }
  if (node.value.size() == 3) {
    const Node third = node.item(2);
    if (third.text() != "right_wrong") third.fail(third.describe(), "\"right_wrong\"");
    stitch.right_wrong = true;
  }
  return stitch;
}

FileRules read_rules(const Node& root, std::vector<std::string>& warnings) {
  FileRules rules;
  if (!root.has("properties")) {
    warnings.push_back(
        "properties: missing, units taken as centimetres, curve coordinates as relative");
    return rules;
  }
  const Node properties = root.at("properties").object();
  if (properties.has("units_in_meter")) {
    const Node units = properties.at("units_in_meter");
    const double per_metre = units.number();
    if (!(per_metre >= 1e-3 && per_metre <= 1e6))
      units.fail(units.describe(), "units in a metre, 0.001 to 1e6");
    rules.metre = 1 / per_metre;
  } else {
    warnings.push_back("properties.units_in_meter: missing, taken as 100 (centimetres)");
  }
  if (properties.has("curvature_coords")) {
    const Node coords = properties.at("curvature_coords");
    if (coords.text() != "relative" && coords.text() != "absolute")
      coords.fail(coords.describe(), "\"relative\" or \"absolute\"");
    rules.absolute_curves = coords.text() == "absolute";
  } else {
    warnings.push_back("properties.curvature_coords: missing, taken as relative");
  }
  return rules;
}

std::vector<std::string> read_panel_order(const Node& pattern, const pattern::Pattern& panels,
                                          std::vector<std::string>& warnings) {
  std::vector<std::string> order;
  if (!pattern.has("panel_order")) return order;
  const Node names = pattern.at("panel_order").array(0, kMostPanels);
  for (std::size_t i = 0; i < names.value.size(); ++i) {
    const Node name = names.item(i);
    if (panels.find_panel(name.text()) >= 0)
      order.push_back(name.text());
    else
      warnings.push_back(fmt::format("{}: no panel {}, left out", name.path, name.describe()));
  }
  return order;
}

constexpr const char* kExpected = "GarmentCode JSON (NAME_specification.json)";

constexpr const char* kPatterns =
    "patterns are read from GarmentCode JSON, DXF-AAMA, SVG, FreeSewing JSON and .val of "
    "Valentina; "
    "`loosefit pattern -o DIR` writes GarmentCode JSON";

/// Files that hold garments in other forms are told by their kind instead of their first bad
/// letter.
void refuse_no_pattern(const std::string& text, const std::string& file) {
  const FileKind kind = recognise_file(text);
  if (kind.name.find("mesh") != std::string::npos)
    throw InvalidInput({file, 0, {}}, kind.name, kExpected,
                       "a mesh has no flat pieces; a scanned body is read by body.file");
  // Models of CAD and of other programs come as meshes at best.
  if (kind.advice.starts_with("convert it to OBJ"))
    throw InvalidInput({file, 0, {}}, kind.name, kExpected,
                       "it has no flat pieces; a scanned body is read by body.file, as OBJ, PLY or "
                       "STL; " +
                           std::string(kPatterns));
  refuse_other_kinds(text, file, kExpected, {}, kPatterns);
}

/// JSON of a program that nobody here knows, told by its keys.
void refuse_other_json(const Json& json, const std::string& file) {
  if (!json.is_object() || json.contains("pattern")) return;
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items())
    if (keys.size() < 6) keys.push_back('"' + printable(key, 30) + '"');
  throw InvalidInput({file, 0, {}},
                     keys.empty() ? std::string("a JSON object without keys")
                                  : "JSON of another program (keys " + join(keys) + ")",
                     kExpected, kPatterns);
}

/// Keys that are neither read nor known to mean nothing here, each once for the whole file.
class UnreadKeys {
 public:
  void note(const Node& node, std::initializer_list<const char*> known) {
    if (!node.value.is_object()) return;
    for (const auto& [key, value] : node.value.items())
      if (std::none_of(known.begin(), known.end(), [&](const char* k) { return key == k; }))
        if (keys_.insert(key).second) shown_.push_back(printable(key));
  }
  void warn(std::vector<std::string>& warnings) const {
    constexpr std::size_t kMost = 12;
    if (shown_.empty()) return;
    std::vector<std::string> first(shown_.begin(), shown_.begin() + std::min(kMost, shown_.size()));
    warnings.push_back("keys not read: " + join(first) +
                       (shown_.size() > kMost ? fmt::format(" and {} more", shown_.size() - kMost)
                                              : std::string()));
  }

 private:
  std::set<std::string> keys_;
  std::vector<std::string> shown_;
};

void warn_of_unread_keys(const Node& root, std::vector<std::string>& warnings) {
  UnreadKeys unread;
  unread.note(root, {"pattern", "properties"});
  if (root.has("properties"))
    unread.note(root.at("properties"), {"curvature_coords", "normalize_panel_translation",
                                        "normalized_edge_loops", "units_in_meter", kDraftKey});
  const Node pattern = root.at("pattern"), panels = pattern.at("panels");
  unread.note(pattern, {"panels", "stitches", "panel_order"});
  for (const auto& [name, value] : panels.value.items()) {
    const Node panel{value, panels.path, panels.file};
    unread.note(panel,
                {"label", "translation", "rotation", "vertices", "edges", kClothKey, kHolesKey});
    const Node edges = panel.at("edges");
    for (std::size_t i = 0; i < edges.value.size(); ++i)
      unread.note(edges.item(i),
                  {"endpoints", "curvature", "label", "name", kFinishKey, kElasticKey});
  }
  unread.warn(warnings);
}

/// Which draft of ours made the pattern.
void note_draft(const Node& root, PatternFile& file) {
  std::string mark;
  if (root.has("properties")) mark = root.at("properties").optional_text(kDraftKey);
  const kinds::Recognised found = kinds::recognise_kind(file.pattern, mark);
  if (found == kinds::Recognised::unknown_draft)
    file.warnings.push_back(
        fmt::format("properties.{}: \"{}\" is of another version; the garment "
                    "is put on as its panels are placed",
                    kDraftKey, printable(mark)));
  if (found == kinds::Recognised::sewn_otherwise)
    file.warnings.push_back(
        fmt::format("properties.{}: the pattern is sewn in another way than "
                    "this draft; it is put on as its panels are placed",
                    kDraftKey));
}

/// Text that does not even begin as JSON is another thing, told by how it begins.
void refuse_other_text(const std::string& text, const std::string& file) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || text[start] == '{' || text[start] == '[') return;
  const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
  const std::string advice = advice_by_name(file);
  throw InvalidInput({file, 0, {}},
                     "a file of no known kind that begins with \"" +
                         printable(text.substr(start, std::min<std::size_t>(end - start, 40))) +
                         '"',
                     kExpected, advice + (advice.empty() ? "" : "; ") + kPatterns);
}

Json parse_json(const std::string& text, const std::string& file) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    refuse_other_text(text, file);
    const std::size_t at = std::min(e.byte, text.size());
    const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + at, '\n'));
    std::string what = e.what();  // "[json.exception.…] parse error at line …: syntax error …"
    const std::size_t detail = what.find("syntax error");
    what = detail == std::string::npos ? "text that is not JSON" : what.substr(detail);
    throw InvalidInput(InputPlace{file, line, {}}, printable(what, 160), "JSON", kPatterns);
  } catch (const Json::exception&) {
    throw InvalidInput(InputPlace{file, 0, {}}, "a number that is out of range", "JSON");
  }
}

}  // namespace

PatternFile parse_garmentcode(const std::string& text, const std::string& file) {
  PatternFile result;
  refuse_no_pattern(text, file);
  const Json json = parse_json(text, file);
  refuse_other_json(json, file);
  const Node root{json, "", file};
  const FileRules rules = read_rules(root.object(), result.warnings);
  const Node pattern = root.at("pattern"), panels = pattern.object().at("panels").object();
  if (panels.value.empty() || panels.value.size() > kMostPanels)
    panels.fail(fmt::format("{} panels", panels.value.size()), fmt::format("1 to {}", kMostPanels));
  std::size_t edges = 0;
  for (const auto& [name, value] : panels.value.items()) {
    const std::string safe = printable(name, 200);
    if (result.pattern.find_panel(name) >= 0)
      panels.fail("panel " + safe + " twice", "different names");
    result.pattern.panels.push_back(
        read_panel(name, {value, panels.path + "." + safe, file}, rules, result.warnings));
    edges += result.pattern.panels.back().edges.size();
    if (edges > kMostEdgesInAll)
      panels.fail("more edges", fmt::format("at most {} in all", kMostEdgesInAll));
  }
  if (pattern.has("stitches")) {
    const Node stitches = pattern.at("stitches").array(0, kMostEdgesInAll);
    for (std::size_t i = 0; i < stitches.value.size(); ++i)
      result.pattern.stitches.push_back(read_stitch(stitches.item(i), result.pattern));
  } else {
    result.warnings.push_back("pattern.stitches: missing, nothing is sewn");
  }
  const auto order = read_panel_order(pattern, result.pattern, result.warnings);
  try {
    close_loops(result.pattern);
    for (pattern::Panel& panel : result.pattern.panels) make_counter_clockwise(panel);
    merge_named_edges(result.pattern);
    pattern::check_pattern(result.pattern);
  } catch (const GeometryError& e) {
    throw GeometryError(file + ": " + e.what(), e.hint());
  }
  set_panel_order(result.pattern, order);
  std::set<int> sewn;
  for (const pattern::Stitch& stitch : result.pattern.stitches)
    sewn.insert({stitch.first.panel, stitch.second.panel});
  for (std::size_t p = 0; p < result.pattern.panels.size(); ++p) {
    const pattern::Panel& panel = result.pattern.panels[p];
    std::string line = "panel " + printable(panel.name) + ": its outline";
    if (!sewn.empty() && sewn.count(static_cast<int>(p)) == 0) {
      line += ", sewn to nothing";
      result.warnings.push_back("panel " + printable(panel.name) +
                                ": no stitch sews it to anything, it is taken all the same");
    }
    for (const pattern::PanelHole& hole : panel.holes)
      line += ", hole \"" + printable(hole.name) + "\" cut";
    result.used.push_back(std::move(line));
  }
  note_draft(root, result);
  warn_of_unread_keys(root, result.warnings);
  return result;
}

PatternFile read_garmentcode(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InvalidInput({path.string(), 0, {}}, "a folder", kExpected);
  PatternFile result =
      parse_garmentcode(read_plain_text(path.string(), kLargestFile), path.string());
  result.pattern.name = path.stem().string();
  const std::string suffix = "_specification";
  if (result.pattern.name.ends_with(suffix))
    result.pattern.name.resize(result.pattern.name.size() - suffix.size());
  return result;
}

}  // namespace loosefit::io
