#include "loosefit/io/freesewing_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/freesewing_piece.h"
#include "loosefit/io/pieces/piece_collector.h"
#include "loosefit/io/svg/svg_path.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLargestFile = 64u << 20;  // bytes
constexpr std::size_t kMostParts = 200, kMostOps = 5000;
constexpr double kMm = 1e-3, kTolerance = 0.02;  // [m], [mm]

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  /// \param name of the part
  FreesewingPart part(const Json& j, const std::string& name, const std::string& at) {
    FreesewingPart part;
    part.name = name.substr(0, 100);
    part.place = "part " + printable(part.name);
    part.middle = {Vec2(0, 0), Vec2(0, 1)};
    const Json& paths = object(j, "paths", at);
    for (const auto& [path_name, path] : paths.items()) {
      const std::string here = at + ".paths." + printable(path_name, 40);
      if (!path.is_object()) fail(here, "no object", "a path");
      if (flag(path, "hidden")) {
        left_.count("hidden paths", path_name);
        continue;
      }
      add_text(path, part.texts);
      const std::string marker = attribute(path, "marker-start") + attribute(path, "marker-end");
      const bool fold = marker.find("cutonfold") != std::string::npos;
      const bool grain = marker.find("grainline") != std::string::npos;
      const std::string classes = " " + attribute(path, "class") + " ";
      const auto has = [&](const char* word) { return classes.find(word) != std::string::npos; };
      const bool fabric = has(" fabric ") && !has(" sa ") && !has(" help ") && !has(" hidden ") &&
                          !has(" dashed ") && !has(" lashed ") && !has(" dotted ");
      const bool plain = classes.find_first_not_of(' ') == std::string::npos;
      const bool other_cloth = has(" lining ") || has(" interfacing ") || has(" canvas ");
      const bool seam = path_name == "seam" && (fabric || !other_cloth);
      const bool sewn = seam || fabric || plain;
      if (!fold && !grain && !sewn) {
        left_.count(has(" sa ") ? std::string("seam allowances")
                                : "paths of class \"" + trimmed(classes) + '"',
                    path_name);
        if (has(" sa ") || !path.contains("ops")) continue;
        for (const SvgRun& run : read_ops(path, here))
          if (SampledRun line = line_of(run); line.closed && line.points.size() > 2)
            part.others.push_back({std::move(line.points), trimmed(classes), here});
        continue;
      }
      for (const SvgRun& run : read_ops(path, here)) {
        SampledRun line = line_of(run);
        if (fold || grain) {
          const Axis axis(line.points.front(), line.points.back());
          if (fold && line.nodes.size() > 1)
            part.folds.push_back(line.nodes);
          else if (!fold && (axis.second - axis.first).norm() > kSamePoint)
            part.grain = axis;
          marked_ = true;
          continue;
        }
        part.lines.push_back({{std::move(line.points), line.closed, true},
                              std::move(line.nodes),
                              path_name,
                              seam || fabric,
                              here});
      }
    }
    if (const auto points = j.find("points"); points != j.end() && points->is_object())
      for (const auto& [point_name, point] : points->items()) add_text(point, part.texts);
    if (const auto snippets = j.find("snippets"); snippets != j.end() && snippets->is_object())
      for (const auto& [snippet_name, snippet] : snippets->items())
        if (snippet.is_object() && snippet.contains("def") && snippet["def"].is_string() &&
            snippet["def"].get<std::string>().find("notch") != std::string::npos)
          part.notches.push_back(
              point(snippet, "anchor", at + ".snippets." + printable(snippet_name, 40))
                  .cwiseProduct(Vec2(kMm, -kMm)));
    return part;
  }

  bool marked() const { return marked_; }
  LeftOut& left() { return left_; }

  [[noreturn]] void fail(const std::string& at, const std::string& found,
                         const std::string& expected, const std::string& hint = {}) const {
    throw InvalidInput({file_, 0, at}, found, expected, hint);
  }

  const Json& object(const Json& in, const std::string& key, const std::string& at) const {
    const auto found = in.is_object() ? in.find(key) : in.end();
    if (found == in.end() || !found->is_object())
      fail(at.empty() ? key : at + "." + key, "no object", "an object");
    return *found;
  }

  static bool flag(const Json& in, const char* key) {
    const auto found = in.find(key);
    return found != in.end() && found->is_boolean() && found->get<bool>();
  }

 private:
  static std::string trimmed(const std::string& text) {
    const std::size_t a = text.find_first_not_of(' '), b = text.find_last_not_of(' ');
    return a == std::string::npos ? std::string() : printable(text.substr(a, b - a + 1), 60);
  }

  /// [m], y up
  static SampledRun line_of(const SvgRun& run) {
    SampledRun line = sampled(run, kTolerance);
    for (std::vector<Vec2>* points : {&line.points, &line.nodes})
      for (Vec2& p : *points) p = Vec2(kMm * p.x(), -kMm * p.y());
    return line;
  }

  /// What FreeSewing writes at a path or a point.
  static void add_text(const Json& of, std::vector<std::string>& texts) {
    if (!of.is_object()) return;
    const std::string text = trimmed(attribute(of, "data-text"));
    if (!text.empty()) texts.push_back(text);
  }

  /// attributes.list.KEY, a list of words.
  static std::string attribute(const Json& path, const std::string& key) {
    std::string words;
    const auto attributes = path.find("attributes");
    if (attributes == path.end() || !attributes->is_object()) return words;
    const auto list = attributes->find("list");
    if (list == attributes->end() || !list->is_object()) return words;
    const auto values = list->find(key);
    if (values == list->end() || !values->is_array()) return words;
    for (const Json& value : *values)
      if (value.is_string()) words += value.get<std::string>().substr(0, 200) + " ";
    return words;
  }

  Vec2 point(const Json& in, const char* key, const std::string& at) const {
    const Json& p = object(in, key, at);
    Vec2 point;
    for (int k = 0; k < 2; ++k) {
      const char* axis = k == 0 ? "x" : "y";
      const auto number = p.find(axis);
      const std::string here = at + "." + key + "." + axis;
      if (number == p.end() || !number->is_number()) fail(here, "no number", "a number [mm]");
      point[k] = number->get<double>();
      if (!(std::abs(point[k]) <= 1e5))
        fail(here, fmt::format("{:g}", point[k]), "at most 100 000 mm");
    }
    return point;
  }

  std::vector<SvgRun> read_ops(const Json& path, const std::string& at) const {
    const auto ops = path.find("ops");
    if (ops == path.end() || !ops->is_array()) fail(at + ".ops", "no list", "a list of operations");
    if (ops->size() > kMostOps)
      fail(at + ".ops", fmt::format("{} operations", ops->size()),
           fmt::format("at most {}", kMostOps));
    std::vector<SvgRun> runs;
    for (std::size_t i = 0; i < ops->size(); ++i) {
      const Json& op = (*ops)[i];
      const std::string here = fmt::format("{}.ops[{}]", at, i);
      const auto type = op.is_object() ? op.find("type") : op.end();
      if (!op.is_object() || type == op.end() || !type->is_string())
        fail(here, "no type", "move, line, curve or close");
      const std::string kind = type->get<std::string>();
      if (kind == "noop") {
        continue;
      } else if (kind == "move") {
        runs.push_back({point(op, "to", here), {}, false});
      } else if (kind != "close" && runs.empty()) {
        fail(here, '"' + printable(kind, 20) + '"', "move first");
      } else if (kind == "close") {
        if (!runs.empty()) runs.back().closed = true;
      } else if (kind == "line") {
        runs.back().line_to(point(op, "to", here));
      } else if (kind == "curve") {
        const Vec2 a = point(op, "cp1", here), b = point(op, "cp2", here);
        runs.back().curve_to(a, b, point(op, "to", here));
      } else {
        fail(here, '"' + printable(kind, 20) + '"', "move, line, curve or close");
      }
    }
    std::erase_if(runs, [](const SvgRun& run) { return run.segments.empty(); });
    return runs;
  }

  const std::string& file_;
  bool marked_ = false;
  LeftOut left_;
};

}  // namespace

PatternFile parse_freesewing_json(const std::string& text, const std::string& file,
                                  const PatternWish& wish) {
  for (const auto& [key, value] : {std::pair{"size", wish.size}, std::pair{"units", wish.units}})
    if (!value.empty())
      throw InvalidInput({file, 0, key}, '"' + printable(value) + '"',
                         "none: FreeSewing drafts one size, in millimetres");
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto line =
        1 +
        std::count(text.begin(),
                   text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size())),
                   '\n');
    throw InvalidInput({file, static_cast<int>(line), {}}, "text that is no JSON", "JSON");
  } catch (const Json::exception&) {
    throw InvalidInput({file, 0, {}}, "a number that is too large for any", "usual numbers");
  }
  Reader reader(file);
  std::vector<FreesewingPart> parts;
  const auto add = [&](const std::string& name, const Json& part, const std::string& at) {
    if (!part.is_object()) reader.fail(at, "no object", "a part");
    if (Reader::flag(part, "hidden")) {
      reader.left().count("hidden parts", name);
      return;
    }
    if (parts.size() >= kMostParts)
      reader.fail(at, fmt::format("more than {} parts", kMostParts), "a design");
    parts.push_back(reader.part(part, name, at));
  };
  const auto add_all = [&](const Json& list, const std::string& at) {
    for (const auto& [name, part] : list.items()) add(name, part, at + "." + printable(name, 40));
  };
  if (!root.is_object()) reader.fail("", "no object", "a drafted FreeSewing design");
  if (root.contains("stacks") && root["stacks"].is_object()) {
    for (const auto& [name, stack] : root["stacks"].items()) {
      const std::string at = "stacks." + printable(name, 40);
      if (!stack.is_object() || !stack.contains("parts") || !stack["parts"].is_array())
        reader.fail(at + ".parts", "no list", "a list of parts");
      for (std::size_t i = 0; i < stack["parts"].size(); ++i)
        add(name, stack["parts"][i], fmt::format("{}.parts[{}]", at, i));
    }
  } else if (root.contains("parts") && root["parts"].is_array()) {
    for (std::size_t i = 0; i < root["parts"].size(); ++i) {
      const std::string at = fmt::format("parts[{}]", i);
      if (!root["parts"][i].is_object()) reader.fail(at, "no object", "parts by name");
      add_all(root["parts"][i], at);
    }
  } else if (root.contains("parts") && root["parts"].is_object()) {
    add_all(root["parts"], "parts");
  } else {
    reader.fail("parts", "settings without a draft", "parts or stacks with their paths",
                "export the drafted pattern as SVG, or write getRenderProps() of it as JSON");
  }
  PatternFile result;
  result.placed = false;
  result.about.push_back("FreeSewing JSON, in millimetres");
  std::set<std::string> names;
  for (const FreesewingPart& part : parts)
    if (part.has_outline()) names.insert(part.name);
  LeftOut& left = reader.left();
  std::vector<CountedPiece> drawn;
  for (const FreesewingPart& part : parts) {
    for (CountedPiece& one : drawn_freesewing(part, reader.marked(), names, left))
      drawn.push_back(std::move(one));
  }
  std::vector<DrawnPiece*> pieces;
  for (CountedPiece& one : drawn) pieces.push_back(&one.piece);
  point_grains_up(pieces);
  PieceCollector collector(result);
  for (CountedPiece& one : drawn) collector.add(std::move(one.piece), one.count, one.place);
  collector.finish(file, "sew line");
  left.sum_up();
  result.unused.insert(result.unused.end(), left.unused.begin(), left.unused.end());
  result.warnings.insert(result.warnings.end(), left.warnings.begin(), left.warnings.end());
  return result;
}

PatternFile read_freesewing_json(const std::filesystem::path& path, const PatternWish& wish) {
  PatternFile result =
      parse_freesewing_json(read_plain_text(path.string(), kLargestFile), path.string(), wish);
  result.pattern.name = path.stem().string();
  return result;
}

}  // namespace loosefit::io
