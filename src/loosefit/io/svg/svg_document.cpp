#include "loosefit/io/svg/svg_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/io/xml_tree.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostShapes = 100'000;
constexpr int kMostUses = 8;             // of uses within each other
constexpr std::size_t kMostWords = 500;  // bytes of a text
constexpr double kInch = 25.4;

/// A length with its unit: value, and millimetres of the unit, none for a plain number and for px,
/// which stand for a unit that nobody named.
struct Length {
  double value = 0;
  std::optional<double> mm;
  bool percent = false;
};

std::optional<Length> parse_length(const std::string& text) {
  Length length;
  const char* begin = text.data();
  const char* end = text.data() + text.size();
  while (begin != end && (*begin == ' ' || *begin == '\t' || *begin == '+')) ++begin;
  const auto [rest, error] = std::from_chars(begin, end, length.value);
  if (error != std::errc() || !std::isfinite(length.value)) return {};
  std::string unit(rest, end);
  while (!unit.empty() && unit.back() == ' ') unit.pop_back();
  while (!unit.empty() && unit.front() == ' ') unit.erase(0, 1);
  if (unit == "mm") length.mm = 1;
  if (unit == "cm") length.mm = 10;
  if (unit == "m") length.mm = 1000;
  if (unit == "in") length.mm = kInch;
  if (unit == "pt") length.mm = kInch / 72;
  if (unit == "pc") length.mm = kInch / 6;
  length.percent = unit == "%";
  if (!length.mm && !length.percent && !unit.empty() && unit != "px") return {};
  return length;
}

/// Value of a property in a style attribute or as an attribute of its own.
std::string property(const XmlElement& element, const std::string& name) {
  const std::string& style = element.attribute("style");
  for (std::size_t at = 0; at < style.size();) {
    const std::size_t end = std::min(style.find(';', at), style.size());
    const std::string one = style.substr(at, end - at);
    const std::size_t colon = one.find(':');
    if (colon != std::string::npos) {
      std::string key = one.substr(0, colon), value = one.substr(colon + 1);
      key.erase(0, key.find_first_not_of(" \t\n"));
      value.erase(0, value.find_first_not_of(" \t\n"));
      if (key == name) return value;
    }
    at = end + 1;
  }
  return element.attribute(name);
}

/// All words in an element, with a blank between those of its parts.
std::string words_in_element(const XmlElement& e) {
  std::string words = e.text;
  for (const XmlElement& child : e.children) words += " " + words_in_element(child);
  return words;
}

bool has_path(const XmlElement& e) {
  return e.name == "textPath" || std::any_of(e.children.begin(), e.children.end(), has_path);
}

/// Title and description of an element.
std::vector<std::string> said_of(const XmlElement& e) {
  std::vector<std::string> said;
  for (const XmlElement& child : e.children)
    if (child.name == "title" || child.name == "desc")
      said.push_back(words_in_element(child).substr(0, kMostWords));
  return said;
}

/// Value of an attribute that counts pieces: quantity, data-quantity, inkscape:cut, …
std::string quantity_of(const XmlElement& e) {
  for (const auto& [name, value] : e.attributes) {
    std::string key = name.substr(name.find(':') == std::string::npos ? 0 : name.find(':') + 1);
    if (key.starts_with("data-")) key.erase(0, 5);
    if (counts_pieces(key)) return value.substr(0, kMostWords);
  }
  return {};
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  SvgDocument read(const XmlElement& root, const std::string& text) {
    if (root.name != "svg")
      throw InvalidInput({file_, root.line, {}},
                         "an XML file whose root is " + printable(root.name), "an SVG drawing");
    document_.freesewing = root.attributes.count("freesewing") > 0;
    document_.points = text.substr(0, 2000).find("Adobe Illustrator") != std::string::npos;
    page(root);
    index(root);
    for (const XmlElement& child : root.children) element(child, SvgAffine::Identity(), {}, 0);
    for (const auto& [kind, count] : left_)
      document_.unused.push_back(fmt::format("{}: {}", kind, count));
    return std::move(document_);
  }

 private:
  void page(const XmlElement& root) {
    const std::optional<Length> width = parse_length(root.attribute("width"));
    const std::optional<Length> height = parse_length(root.attribute("height"));
    const std::string& box = root.attribute("viewBox");
    std::vector<double> view;
    if (!box.empty()) {
      view = parse_svg_numbers(box, file_, root.line, "viewBox");
      if (view.size() != 4 || !(view[2] > 0) || !(view[3] > 0))
        throw InvalidInput({file_, root.line, "viewBox"}, '"' + printable(box) + '"',
                           "four numbers, the last two of them positive");
      document_.low = {view[0], view[1]};
      document_.high = document_.low + Vec2(view[2], view[3]);
    }
    // The drawing is fitted into the page: the smaller scale holds.
    for (int k = 0; k < 2; ++k) {
      const std::optional<Length>& side = k == 0 ? width : height;
      if (!side || side->percent || !(side->value > 0)) continue;
      if (!side->mm) {
        if (!view.empty()) document_.pixel_mm = side->value * kInch / 96 / view[2 + k];
        continue;
      }
      const double unit = view.empty() ? *side->mm : side->value * *side->mm / view[2 + k];
      // Without a viewBox a unit is a pixel whatever the unit of the page.
      const double mm = view.empty() ? kInch / 96 : unit;
      document_.unit_mm = std::min(document_.unit_mm.value_or(mm), mm);
    }
    if (view.empty() && width && height && !width->percent && !height->percent)
      document_.high = {width->value, height->value};
  }

  void index(const XmlElement& element) {
    if (const std::string& id = element.attribute("id"); !id.empty()) by_id_.emplace(id, &element);
    for (const XmlElement& child : element.children) index(child);
  }

  double length(const XmlElement& e, const std::string& key, double fallback = 0) const {
    const std::string& text = e.attribute(key);
    if (text.empty()) return fallback;
    const std::optional<Length> value = parse_length(text);
    if (!value || std::abs(value->value) > 1e7)
      throw InvalidInput({file_, e.line, key}, '"' + printable(text) + '"', "a length");
    if (value->percent) {
      const Vec2 size = document_.high - document_.low;
      const bool along_y = key == "y" || key == "height" || key == "cy";
      return value->value / 100 * (along_y ? size.y() : size.x());
    }
    return value->mm ? value->value * *value->mm * 96 / kInch : value->value;
  }

  void element(const XmlElement& e, const SvgAffine& outside, const std::vector<int>& groups,
               int uses) {
    if (e.name.find(':') != std::string::npos) return;  // of other vocabularies: metadata
    if (property(e, "display") == "none" || property(e, "visibility") == "hidden") {
      if (e.name == "g" || e.name == "path") ++left_["hidden " + e.name];
      return;
    }
    SvgAffine place = outside;
    if (const std::string& t = e.attribute("transform"); !t.empty())
      place = outside * parse_svg_transform(t, file_, e.line);
    if (e.name == "g" || e.name == "a" || e.name == "svg" || e.name == "switch") {
      if (e.name == "svg") place = place * Eigen::Translation2d(length(e, "x"), length(e, "y"));
      std::vector<int> inner = groups;
      inner.push_back(static_cast<int>(document_.groups.size()));
      document_.groups.push_back({e.attribute("id"), e.attribute("inkscape:label"),
                                  e.attribute("inkscape:groupmode") == "layer", place,
                                  quantity_of(e), said_of(e)});
      for (const XmlElement& child : e.children) element(child, place, inner, uses);
      return;
    }
    if (e.name == "use") return use(e, place, groups, uses);
    if (e.name == "text") return text(e, place, groups);
    SvgShape shape;
    if (!draw(e, shape)) return;
    shape.kind = e.name;
    shape.id = e.attribute("id");
    shape.label = e.attribute("inkscape:label");
    shape.classes = e.attribute("class");
    shape.quantity = quantity_of(e);
    shape.said = said_of(e);
    shape.marker = property(e, "marker-start");
    if (shape.marker.empty() || shape.marker == "none") shape.marker = property(e, "marker-end");
    shape.groups = groups;
    shape.line = e.line;
    for (SvgRun& run : shape.runs) {
      run = transformed(std::move(run), place);
      // Transforms within each other may leave what a pattern can be.
      for (const SvgRun::Segment& s : run.segments)
        if (!(s.to.norm() < 1e8 && s.first.norm() < 1e8 && s.second.norm() < 1e8))
          throw InvalidInput({file_, e.line, e.name}, "coordinates beyond 1e8", "usual ones");
    }
    if (document_.shapes.size() >= kMostShapes)
      throw InvalidInput({file_, e.line, {}}, fmt::format("more than {} shapes", kMostShapes),
                         "a pattern");
    document_.shapes.push_back(std::move(shape));
  }

  void text(const XmlElement& e, const SvgAffine& place, const std::vector<int>& groups) {
    SvgText text;
    text.words = words_in_element(e).substr(0, kMostWords);
    if (text.words.find_first_not_of(" \t\r\n") == std::string::npos) return;
    // The first of the elements that says where it stands.
    const XmlElement* first = &e;
    while (first->attribute("x").empty() && !first->children.empty() &&
           first->children[0].name == "tspan")
      first = &first->children[0];
    if (!has_path(e)) {
      const auto start = [&](const char* key) {
        const std::string& list = first->attribute(key);
        return parse_length(list.substr(0, list.find_first_of(" ,"))).value_or(Length{}).value;
      };
      text.at = place * Vec2(start("x"), start("y"));
    }
    text.groups = groups;
    text.line = e.line;
    if (document_.texts.size() < kMostShapes) document_.texts.push_back(std::move(text));
  }

  void use(const XmlElement& e, const SvgAffine& place, const std::vector<int>& groups, int uses) {
    std::string href = e.attribute("href");
    if (href.empty()) href = e.attribute("xlink:href");
    const SvgAffine at = place * Eigen::Translation2d(length(e, "x"), length(e, "y"));
    if (document_.freesewing && href.find("notch") != std::string::npos) {
      SvgShape shape;  // a mark, whatever it looks like
      shape.kind = "notch";
      shape.groups = groups;
      shape.line = e.line;
      shape.runs.push_back({});
      shape.runs[0].start = at * Vec2(0, 0);
      document_.shapes.push_back(std::move(shape));
      return;
    }
    const auto found = href.starts_with("#") ? by_id_.find(href.substr(1)) : by_id_.end();
    if (document_.freesewing || found == by_id_.end() || uses >= kMostUses ||
        found->second->name == "symbol" || ++used_ > 2000) {
      ++left_["use"];
      return;
    }
    element(*found->second, at, groups, uses + 1);
  }

  /// \return false for what is no shape
  bool draw(const XmlElement& e, SvgShape& shape) {
    const auto vec = [&](const char* x, const char* y) { return Vec2(length(e, x), length(e, y)); };
    if (e.name == "path") {
      shape.runs = parse_svg_path(e.attribute("d"), file_, e.line);
    } else if (e.name == "line") {
      SvgRun run;
      run.start = vec("x1", "y1");
      run.line_to(vec("x2", "y2"));
      shape.runs = {run};
    } else if (e.name == "rect") {
      const Vec2 size = vec("width", "height");
      if (!(size.minCoeff() > 0)) return false;
      const double rx = length(e, "rx", -1), ry = length(e, "ry", -1);
      shape.runs = {svg_rectangle(
          vec("x", "y"), size, {std::max(0.0, rx < 0 ? ry : rx), std::max(0.0, ry < 0 ? rx : ry)})};
    } else if (e.name == "circle" || e.name == "ellipse") {
      const Vec2 radii = e.name == "circle" ? Vec2::Constant(length(e, "r")) : vec("rx", "ry");
      if (!(radii.minCoeff() > 0)) return false;
      shape.runs = {svg_ellipse(vec("cx", "cy"), radii)};
    } else if (e.name == "polyline" || e.name == "polygon") {
      const std::vector<double> n =
          parse_svg_numbers(e.attribute("points"), file_, e.line, "points");
      if (n.size() % 2 != 0)
        throw InvalidInput({file_, e.line, "points"}, fmt::format("{} numbers", n.size()), "pairs");
      if (n.size() < 4) return false;
      SvgRun run;
      run.start = {n[0], n[1]};
      for (std::size_t i = 2; i < n.size(); i += 2) run.line_to({n[i], n[i + 1]});
      run.closed = e.name == "polygon";
      shape.runs = {run};
    } else {
      if (e.name == "image" || e.name == "symbol" || e.name == "foreignObject") ++left_[e.name];
      return false;
    }
    return !shape.runs.empty();
  }

  const std::string& file_;
  SvgDocument document_;
  std::map<std::string, const XmlElement*> by_id_;
  std::map<std::string, int> left_;
  int used_ = 0;
};

}  // namespace

SvgDocument parse_svg(const std::string& text, const std::string& file) {
  const XmlElement root = parse_xml(text, file);
  return Reader(file).read(root, text);
}

}  // namespace loosefit::io
