#include "loosefit/io/svg/svg_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/io/svg/svg_style.h"
#include "loosefit/io/xml_tree.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostShapes = 100'000;
constexpr int kMostUses = 8, kMostUsed = 2000;  // of uses within each other, and of all
constexpr std::size_t kMostWords = 500;         // bytes of a text

std::string in_quotes(const std::string& name) { return '"' + printable(name) + '"'; }

/// Kinds of elements that are drawn.
bool is_shape(const std::string& name) {
  for (const char* known :
       {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "use"})
    if (name == known) return true;
  return false;
}

/// Kinds of elements that change how others are drawn.
bool is_effect(const std::string& name) {
  for (const char* known : {"clipPath", "mask", "marker", "pattern"})
    if (name == known) return true;
  return false;
}

int shapes_in(const XmlElement& e) {
  int count = is_shape(e.name);
  for (const XmlElement& child : e.children) count += shapes_in(child);
  return count;
}

/// What an element is called in messages.
std::string called(const XmlElement& e) {
  const std::string& label = e.attribute("inkscape:label");
  const std::string& name = label.empty() ? e.attribute("id") : label;
  std::string text =
      name.empty() ? fmt::format("{} at line {}", printable(e.name), e.line) : in_quotes(name);
  if (const int count = shapes_in(e); count > 0 && !is_shape(e.name))
    text += fmt::format(" ({} {})", count, count == 1 ? "shape" : "shapes");
  return text;
}

/// All words in an element, with a blank between those of its parts.
std::string words_in_element(const XmlElement& e) {
  std::string words = e.text;
  for (const XmlElement& child : e.children) words += " " + words_in_element(child);
  return words;
}

std::string trimmed(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
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
  Reader(const std::string& file, const XmlElement& root) : file_(file), styles_(root) {}

  SvgDocument read(const XmlElement& root, const std::string& text) {
    if (root.name != "svg")
      throw InvalidInput({file_, root.line, {}},
                         "an XML file whose root is " + printable(root.name), "an SVG drawing");
    document_.freesewing = root.attributes.count("freesewing") > 0;
    static_cast<SvgPage&>(document_) = page_of(root, text, file_);
    index(root);
    Inherited outside;
    outside.visibility = styles_.property(root, "visibility");
    paint(root, outside);
    for (const XmlElement& child : root.children)
      element(child, SvgAffine::Identity(), {}, outside, false);
    if (!document_.freesewing) note_definitions(root, false);
    tell_unused();
    return std::move(document_);
  }

 private:
  /// What the elements round one leave it.
  struct Inherited {
    SvgStyles::Value visibility;
    int uses = 0;                ///< within each other
    std::string fill = "black";  ///< as W3C SVG 1.1, 11.3 and 11.4, begin
    std::string stroke = "none";
    std::string faded;  ///< "opacity: 0"; empty: nothing round it says so
  };

  /// What an element passes on of its paint.
  void paint(const XmlElement& e, Inherited& inherited) const {
    for (const auto& [name, text] :
         {std::pair{"fill", &inherited.fill}, {"stroke", &inherited.stroke}})
      if (const SvgStyles::Value own = styles_.property(e, name);
          !own.text.empty() && !is(own.text, "inherit"))
        *text = own.text;
    const auto is_nothing = [&](const char* name) {
      const SvgStyles::Value own = styles_.property(e, name);
      char* end = nullptr;
      return !own.text.empty() && std::strtod(own.text.c_str(), &end) == 0 &&
             end != own.text.c_str();
    };
    if (is_nothing("opacity")) inherited.faded = "opacity: 0";
    if (is_nothing("fill-opacity")) inherited.fill = "none";
    if (is_nothing("stroke-opacity") || is_nothing("stroke-width")) inherited.stroke = "none";
  }

  static std::string unseen_by(const Inherited& inherited) {
    if (!inherited.faded.empty()) return inherited.faded;
    const auto nothing = [](const std::string& paint) {
      return is(paint, "none") || is(paint, "transparent");
    };
    return nothing(inherited.fill) && nothing(inherited.stroke) ? "no fill and no stroke" : "";
  }

  /// Where people may need to know of a thing that it was left out, and why.
  void leave(const std::string& reason, const XmlElement& e) { left_[reason].push_back(called(e)); }

  void tell_unused() {
    constexpr std::size_t kNamed = 12;
    for (const auto& [reason, names] : left_) {
      const std::vector<std::string> first(names.begin(),
                                           names.begin() + std::min(names.size(), kNamed));
      document_.unused.push_back(
          fmt::format("{}: {}{}", reason, join(first),
                      names.size() > kNamed ? fmt::format(" and {} more", names.size() - kNamed)
                                            : std::string()));
    }
    for (const std::string& what : styles_.unread())
      document_.unused.push_back(what + ": not applied, it may hide something");
  }

  void index(const XmlElement& element) {
    if (const std::string& id = element.attribute("id"); !id.empty()) by_id_.emplace(id, &element);
    for (const XmlElement& child : element.children) index(child);
  }

  /// Definitions and symbols that no "use" shows.
  void note_definitions(const XmlElement& e, bool defined) {
    const bool symbol = e.name == "symbol";
    if (!defined && !symbol && e.name != "defs") {
      for (const XmlElement& child : e.children) note_definitions(child, false);
      return;
    }
    if (shown_.count(&e)) return;
    if (e.name == "defs") {
      for (const XmlElement& child : e.children) note_definitions(child, true);
    } else if (symbol || e.name == "g" || is_shape(e.name) || is_effect(e.name)) {
      const bool used = std::any_of(e.children.begin(), e.children.end(),
                                    [&](const XmlElement& child) { return shown_.count(&child); });
      if (shapes_in(e) > 0 && !used)
        leave(symbol              ? "symbols that nothing uses"
              : is_effect(e.name) ? "clip paths, masks, markers and patterns, which draw no piece"
                                  : "definitions that nothing uses",
              e);
    }
  }

  double length(const XmlElement& e, const std::string& key, double fallback = 0) const {
    return document_.length(e, key, file_, fallback);
  }

  void element(const XmlElement& e, const SvgAffine& outside, const std::vector<int>& groups,
               Inherited inherited, bool by_use) {
    if (e.name.find(':') != std::string::npos) return;  // of other vocabularies: metadata
    if (e.name == "symbol" && !by_use) return;
    const bool container = e.name == "g" || e.name == "a" || e.name == "svg" ||
                           e.name == "switch" || e.name == "symbol";
    const bool drawn = container || is_shape(e.name) || e.name == "text";
    if (by_use) shown_.insert(&e);
    if (drawn) {
      if (const SvgStyles::Value display = styles_.property(e, "display");
          is(display.text, "none")) {
        if (shapes_in(e) > 0) leave("hidden by " + display.from + " (display: none)", e);
        return;
      }
      if (const SvgStyles::Value own = styles_.property(e, "visibility");
          !own.text.empty() && !is(own.text, "inherit"))
        inherited.visibility = own;
      if (const SvgStyles::Value own = styles_.property(e, "transform");
          own.from != "its attribute" && !own.text.empty() && !is(own.text, "none"))
        leave("transform in a style, not applied: the place or size is another", e);
      paint(e, inherited);
    }
    const bool hidden =
        is(inherited.visibility.text, "hidden") || is(inherited.visibility.text, "collapse");
    if (hidden && e.name == "text") return;
    if (hidden && is_shape(e.name) && e.name != "use")
      return leave("hidden by " + inherited.visibility.from +
                       " (visibility: " + printable(inherited.visibility.text, 20) + ")",
                   e);
    SvgAffine place = outside;
    if (const std::string& t = e.attribute("transform"); !t.empty())
      place = outside * parse_svg_transform(t, file_, e.line);
    if (container) {
      if (e.name == "svg") place = place * Eigen::Translation2d(length(e, "x"), length(e, "y"));
      if (e.name == "svg" || e.name == "symbol") place = place * fitted(e, e);
      std::vector<int> inner = groups;
      inner.push_back(static_cast<int>(document_.groups.size()));
      document_.groups.push_back({e.attribute("id"), e.attribute("inkscape:label"),
                                  e.attribute("inkscape:groupmode") == "layer", place,
                                  quantity_of(e), said_of(e)});
      for (const XmlElement& child : e.children) element(child, place, inner, inherited, false);
      return;
    }
    if (e.name == "use") return use(e, place, groups, inherited);
    if (e.name == "text") return text(e, place, groups);
    SvgShape shape;
    if (!draw(e, shape)) return;
    shape.kind = e.name;
    shape.id = e.attribute("id");
    shape.label = e.attribute("inkscape:label");
    shape.classes = e.attribute("class");
    shape.quantity = quantity_of(e);
    shape.said = said_of(e);
    shape.unseen = unseen_by(inherited);
    shape.marker = styles_.property(e, "marker-start").text;
    if (shape.marker.empty() || shape.marker == "none")
      shape.marker = styles_.property(e, "marker-end").text;
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

  static bool is(std::string text, const char* word) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text == word;
  }

  /// How the viewBox of a symbol or an inner drawing is fitted into the width and height that
  /// `sized` gives it (W3C SVG 1.1, 7.8).
  SvgAffine fitted(const XmlElement& e, const XmlElement& sized) const {
    const std::string& box = e.attribute("viewBox");
    SvgAffine fit = SvgAffine::Identity();
    if (box.empty()) return fit;
    const std::vector<double> view = parse_svg_numbers(box, file_, e.line, "viewBox");
    if (view.size() != 4 || !(view[2] > 0) || !(view[3] > 0))
      throw InvalidInput({file_, e.line, "viewBox"}, in_quotes(box),
                         "four numbers, the last two of them positive");
    const Vec2 page = document_.high - document_.low;
    Vec2 size;
    for (int k = 0; k < 2; ++k) {
      const char* const key = k == 0 ? "width" : "height";
      const XmlElement& from = sized.attribute(key).empty() ? e : sized;
      size[k] = length(from, key, page[k]);
    }
    Vec2 scale(size.x() / view[2], size.y() / view[3]);
    if (!(scale.minCoeff() > 0)) return fit;  // no page to fit it into
    std::string how = e.attribute("preserveAspectRatio");
    Vec2 shift = Vec2::Zero();
    if (how.find("none") == std::string::npos) {
      if (how.empty()) how = "xMidYMid";
      const double both =
          how.find("slice") != std::string::npos ? scale.maxCoeff() : scale.minCoeff();
      for (int k = 0; k < 2; ++k) {
        const std::string axis = k == 0 ? "x" : "Y";
        const double free = size[k] - both * view[2 + k];
        shift[k] = how.find(axis + "Min") != std::string::npos   ? 0
                   : how.find(axis + "Max") != std::string::npos ? free
                                                                 : free / 2;
      }
      scale = Vec2::Constant(both);
    }
    fit.translate(shift).scale(scale).translate(Vec2(-view[0], -view[1]));
    return fit;
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
        XmlElement one = *first;
        std::string& list = one.attributes[key];
        list.resize(std::min(list.find_first_of(" ,"), list.size()));
        return length(one, key);
      };
      text.at = place * Vec2(start("x"), start("y"));
    }
    text.groups = groups;
    text.line = e.line;
    if (document_.texts.size() < kMostShapes) document_.texts.push_back(std::move(text));
  }

  void use(const XmlElement& e, const SvgAffine& place, const std::vector<int>& groups,
           Inherited inherited) {
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
    if (found == by_id_.end())
      return leave("uses of " + in_quotes(href) + ", which is not in the file", e);
    if (document_.freesewing) return leave("uses of snippets, which are marks", e);
    if (inherited.uses >= kMostUses || ++used_ > kMostUsed)
      return leave("uses within each other, or more than the reader follows", e);
    ++inherited.uses;
    const XmlElement& shown = *found->second;
    // A symbol takes its size from the use; its own step does the rest.
    const SvgAffine sized =
        shown.name == "symbol" && !e.attribute("width").empty() && !e.attribute("height").empty()
            ? fitted(shown, e) * fitted(shown, shown).inverse()
            : SvgAffine::Identity();
    element(shown, at * sized, groups, inherited, true);
  }

  /// What stands in an element that draws nothing by itself, or that is not read.
  void undrawn(const XmlElement& e) {
    if (e.name == "image") {
      leave("pictures, not read", e);
    } else if (e.name == "foreignObject") {
      const std::string words = trimmed(words_in_element(e));
      left_["foreignObject, not read"].push_back(words.empty() ? called(e)
                                                               : in_quotes(words.substr(0, 60)));
    } else if (shapes_in(e) > 0 && e.name != "defs") {
      leave("in a " + printable(e.name, 40) + ", which draws nothing by itself", e);
    }
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
      undrawn(e);
      return false;
    }
    return !shape.runs.empty();
  }

  const std::string& file_;
  SvgDocument document_;
  SvgStyles styles_;
  std::map<std::string, const XmlElement*> by_id_;
  std::set<const XmlElement*> shown_;                     ///< by a use
  std::map<std::string, std::vector<std::string>> left_;  ///< names by reasons
  int used_ = 0;
};

}  // namespace

SvgDocument parse_svg(const std::string& text, const std::string& file) {
  const XmlElement root = parse_xml(text, file);
  return Reader(file, root).read(root, text);
}

}  // namespace loosefit::io
