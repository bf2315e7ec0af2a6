#include "loosefit/io/dxf/dxf_document.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "loosefit/base/text.h"
#include "loosefit/io/dxf/dxf_curves.h"
#include "loosefit/io/dxf/dxf_groups.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostPoints = 2'000'000, kMostEntities = 1'000'000, kMostText = 1000;
constexpr double kSmallestScale = 1e-9;

bool is_utf8(std::string_view s) {
  for (std::size_t i = 0; i < s.size();) {
    const unsigned char c = s[i];
    const int more = c < 0x80 ? 0 : c >> 5 == 6 ? 1 : c >> 4 == 14 ? 2 : c >> 3 == 30 ? 3 : -1;
    if (more < 0 || (more == 1 && c < 0xc2) || i + more >= s.size() + (more == 0)) return false;
    for (int k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(s[i + k]) >> 6) != 2) return false;
    const unsigned char second = more > 0 ? s[i + 1] : 0;
    if ((c == 0xe0 && second < 0xa0) || (c == 0xed && second > 0x9f) ||
        (c == 0xf0 && second < 0x90) || (c == 0xf4 && second > 0x8f) || c > 0xf4)
      return false;
    i += 1 + more;
  }
  return true;
}

/// Texts are 7-bit or in some code page of the maker.
std::string utf8(std::string_view s) {
  s = s.substr(0, kMostText);
  std::string out;
  const bool as_is = is_utf8(s);
  for (const char c : s) {
    const unsigned char u = c;
    if (u < 0x20 || u == 0x7f) continue;
    if (u < 0x80 || as_is) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | (u >> 6));
      out += static_cast<char>(0x80 | (u & 0x3f));
    }
  }
  return out;
}

int layer_number(std::string_view name) {
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() && number >= 0 ? number : -1;
}

/// Points with their bulges, as POLYLINE and LWPOLYLINE have them.
struct Vertices {
  std::vector<Vec2> points;
  std::vector<double> bulges;
};

std::vector<Vec2> with_bulges(const Vertices& v, bool closed) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < v.points.size(); ++i) {
    if (i == 0) points.push_back(v.points[0]);
    const bool last = i + 1 == v.points.size();
    if (last && !closed) break;
    for (const Vec2& p : bulge_points(v.points[i], v.points[last ? 0 : i + 1], v.bulges[i]))
      points.push_back(p);
  }
  if (closed && points.size() > 1) points.pop_back();  // the first one again
  return points;
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& file) : records_(text, file) {}

  DxfDocument read() {
    bool any = false, ended = false;
    while (!ended && records_.next(record_)) {
      if (record_.kind == "EOF") break;
      if (record_.kind != "SECTION")
        fail(quoted(record_.kind), "SECTION or EOF", "the sections of the file are damaged");
      any = true;
      section();
    }
    if (!any) records_.fail(0, "", "no section", "a DXF file with sections BLOCKS and ENTITIES");
    return std::move(document_);
  }

 private:
  static std::string quoted(std::string_view s) {
    return '"' + printable(std::string(s.substr(0, 60))) + '"';
  }
  [[noreturn]] void fail(const std::string& found, const std::string& expected,
                         const std::string& hint = {}) const {
    records_.fail(record_.line, where(), found, expected, hint);
  }
  std::string where() const {
    const std::string kind = printable(std::string(record_.kind), 20);
    return block_ ? "block " + printable(block_->name, 40) + " " + kind : kind;
  }
  double number(int code, double fallback) const {
    const DxfGroup* group = record_.find(code);
    return group ? records_.number(*group) : fallback;
  }
  double needed(int code) const {
    const DxfGroup* group = record_.find(code);
    if (!group) fail("no group code " + std::to_string(code), "a number of this code");
    return records_.number(*group);
  }
  Vec2 point(int x_code) const { return {needed(x_code), needed(x_code + 10)}; }
  int integer(int code, int fallback) const {
    const DxfGroup* group = record_.find(code);
    return group ? records_.integer(*group) : fallback;
  }

  void section() {
    const std::string name = record_.text(2);
    if (name == "HEADER") header();
    DxfBlock block;
    while (true) {
      if (!records_.next(record_))
        records_.fail(records_.line(), "section " + printable(name), "the end of the file",
                      "ENDSEC", "the file is cut off");
      if (record_.kind == "ENDSEC") break;
      if (name == "TABLES" && record_.kind == "LAYER") layer();
      if (name != "BLOCKS" && name != "ENTITIES") continue;
      if (record_.kind == "BLOCK" && name == "BLOCKS") {
        if (block_) fail("a block within a block", "ENDBLK");
        block = {utf8(record_.text(2)), record_.line, {}, {}};
        block_ = &block;
      } else if (record_.kind == "ENDBLK" && block_) {
        document_.blocks.push_back(std::move(block));
        block_ = nullptr;
      } else if (block_ || name == "ENTITIES") {
        entity(block_ ? block.entities : document_.entities, block_ ? &block.hidden : nullptr);
      } else {
        fail(quoted(record_.kind), "BLOCK or ENDSEC");
      }
    }
    if (block_) fail("the end of the section", "ENDBLK before it");
  }

  void header() {
    std::string_view variable;
    for (const DxfGroup& group : record_.groups) {
      if (group.code == 9) variable = group.value;
      if (group.code != 70) continue;
      if (variable == "$INSUNITS") document_.insunits = records_.integer(group);
      if (variable == "$MEASUREMENT") document_.metric = records_.integer(group) != 0;
    }
  }

  /// Layers that are off have a negative colour, frozen ones the first bit of their flags.
  void layer() {
    const std::string name = utf8(record_.text(2));
    if (integer(70, 0) & 1) hidden_layers_[name] = "its layer is frozen";
    if (integer(62, 7) < 0) hidden_layers_[name] = "its layer is off";
  }

  std::string hidden_by() const {
    if (integer(60, 0) == 1) return "it is invisible, code 60";
    const auto layer = hidden_layers_.find(utf8(record_.text(8)));
    return layer == hidden_layers_.end() ? std::string() : layer->second;
  }

  static bool is_mark(const DxfEntity& e) {
    return e.kind == "TEXT" || e.kind == "MTEXT" || e.kind == "POINT" ||
           (e.layer >= 2 && e.layer <= 7) || (e.layer >= 80 && e.layer <= 83);
  }

  /// \param unseen  takes what is hidden and may be cloth; null: that is kept as well
  void entity(std::vector<DxfEntity>& into, std::vector<DxfEntity>* unseen) {
    DxfEntity e;
    e.kind = std::string(record_.kind.substr(0, 40));
    e.line = record_.line;
    e.layer = layer_number(record_.text(8));
    e.hidden = hidden_by();
    const int flags = integer(70, 0);
    if (e.kind == "LINE") {
      e.points = {point(10), point(11)};
    } else if (e.kind == "POINT" || e.kind == "TEXT" || e.kind == "MTEXT") {
      e.points = {point(10)};
      for (const DxfGroup& g : record_.groups)
        if (g.code == 1 || (g.code == 3 && e.kind == "MTEXT")) e.text += utf8(g.value);
    } else if (e.kind == "POLYLINE") {
      e.closed = flags & 1;
      polyline(e, (flags & 0x58) != 0);  // 3-D curves and meshes
    } else if (e.kind == "LWPOLYLINE") {
      e.closed = flags & 1;
      from_below();
      e.points = with_bulges(light_vertices(), e.closed);
    } else if (e.kind == "ARC" || e.kind == "CIRCLE") {
      arc(e);
    } else if (e.kind == "ELLIPSE") {
      ellipse(e);
    } else if (e.kind == "SPLINE") {
      spline(e);
    } else if (e.kind == "INSERT") {
      insert(e);
    }
    points_ += e.points.size();
    if (points_ > kMostPoints || ++entities_ > kMostEntities)
      records_.fail(e.line, e.kind, "more points or entities",
                    fmt::format("at most {} points and {} entities", kMostPoints, kMostEntities));
    const bool leave = unseen && !e.hidden.empty() && !is_mark(e);
    (leave ? *unseen : into).push_back(std::move(e));
  }

  /// Programs that mirror a drawing may turn it over in space instead: x would be negated.
  void from_below() const {
    if (number(230, 1) < 0)
      fail("a drawing seen from below (code 230 is negative)", "one in the plane, seen from above",
           "explode or flatten it in the program that wrote it");
  }

  void polyline(DxfEntity& e, bool spatial) {
    from_below();
    const std::string start = where();
    const int line = record_.line;
    Vertices vertices;
    while (true) {
      if (!records_.next(record_) || (record_.kind != "VERTEX" && record_.kind != "SEQEND"))
        records_.fail(line, start, "a polyline without SEQEND", "VERTEX and SEQEND after it");
      if (record_.kind == "SEQEND") break;
      if (integer(70, 0) & 16) continue;  // frame of a fitted curve, not on it
      vertices.points.push_back(point(10));
      vertices.bulges.push_back(number(42, 0));
      if (points_ + vertices.points.size() > kMostPoints) break;
    }
    if (spatial)
      e.kind += " (mesh)";
    else
      e.points = with_bulges(vertices, e.closed);
  }

  Vertices light_vertices() const {
    Vertices v;
    double x = 0;
    bool has_x = false;
    for (const DxfGroup& g : record_.groups) {
      if (g.code == 10) x = records_.number(g), has_x = true;
      if (g.code == 20 && has_x) {
        v.points.push_back({x, records_.number(g)});
        v.bulges.push_back(0);
        has_x = false;
      }
      if (g.code == 42 && !v.bulges.empty()) v.bulges.back() = records_.number(g);
    }
    if (has_x) fail("a vertex without y", "codes 10 and 20 in turn");
    return v;
  }

  void arc(DxfEntity& e) {
    from_below();
    const double radius = needed(40);
    if (!(radius > 0)) fail(fmt::format("radius {:g}", radius), "a positive radius");
    if (e.kind == "CIRCLE") {
      e.points = arc_points(point(10), radius, 0, 2 * std::numbers::pi);
      e.points.pop_back();
      e.closed = true;
      return;
    }
    const double from = needed(50);
    double sweep = std::fmod(needed(51) - from, 360);
    if (sweep <= 0) sweep += 360;
    e.points = arc_points(point(10), radius, radians(from), radians(sweep));
  }

  /// From parameter to parameter, counted from the long half axis.
  void ellipse(DxfEntity& e) {
    from_below();
    const Vec2 middle = point(10), axis = point(11);
    const double ratio = needed(40), from = number(41, 0);
    double sweep = number(42, 2 * std::numbers::pi) - from;
    if (!(axis.norm() > 0) || !(ratio > 0 && ratio <= 1 + 1e-9))
      fail(fmt::format("an ellipse of half axis {:g} and ratio {:g}", axis.norm(), ratio),
           "a half axis that is longer than 0 and a ratio up to 1");
    if (!(sweep > 0)) sweep += 2 * std::numbers::pi;
    if (!(sweep > 0 && sweep < 7)) fail("parameters further apart than once round", "0 to 2 pi");
    for (const Vec2& p : arc_points(Vec2::Zero(), 1, from, sweep))
      e.points.push_back(middle + p.x() * axis + ratio * p.y() * Vec2(-axis.y(), axis.x()));
    if (sweep > 2 * std::numbers::pi - 1e-6) {
      e.points.pop_back();
      e.closed = true;
    }
  }

  void spline(DxfEntity& e) {
    DxfSpline s;
    s.degree = integer(71, 3);
    double x = 0;
    for (const DxfGroup& g : record_.groups) {
      if (g.code == 40) s.knots.push_back(records_.number(g));
      if (g.code == 41) s.weights.push_back(records_.number(g));
      if (g.code == 10) x = records_.number(g);
      if (g.code == 20) s.control.push_back({x, records_.number(g)});
    }
    if (const std::string fault = s.fault(); !fault.empty())
      fail("a spline with " + fault, "degree, knots and control points that fit");
    if (s.control.size() * 64 > kMostPoints)
      fail(fmt::format("{} control points", s.control.size()), "fewer");
    e.points = spline_points(s);
    if (e.points.size() > 2 && (e.points.front() - e.points.back()).norm() < kSmallestScale) {
      e.points.pop_back();
      e.closed = true;
    }
  }

  void insert(DxfEntity& e) {
    e.text = utf8(record_.text(2));
    for (const int code : {41, 42})
      if (std::abs(number(code, 1) - 1) > 1e-6)
        fail(fmt::format("a block scaled by {:g}", number(code, 1)), "blocks at their size",
             "export the pieces unscaled and not mirrored");
  }

  DxfRecords records_;
  DxfRecord record_;
  DxfDocument document_;
  std::map<std::string, std::string> hidden_layers_;  ///< name and why
  const DxfBlock* block_ = nullptr;                   ///< that is being read
  std::size_t points_ = 0, entities_ = 0;
};

}  // namespace

DxfDocument parse_dxf(const std::string& text, const std::string& file) {
  return Reader(text, file).read();
}

}  // namespace loosefit::io
