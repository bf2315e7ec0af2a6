#pragma once
#include <fmt/format.h>

#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit {

/// Writes DXF text the way apparel programs do, for tests of readers.
class DxfText {
 public:
  DxfText& group(int code, const std::string& value) {
    text_ += fmt::format("{:>3}\n{}\n", code, value);
    return *this;
  }
  DxfText& number(int code, double value) { return group(code, fmt::format("{:.4f}", value)); }
  DxfText& at(const Vec2& p, int x_code = 10) {
    return number(x_code, p.x()).number(x_code + 10, p.y());
  }
  DxfText& section(const std::string& name) { return group(0, "SECTION").group(2, name); }
  DxfText& end_section() { return group(0, "ENDSEC"); }
  DxfText& block(const std::string& name) {
    return group(0, "BLOCK").group(8, "0").group(2, name).group(70, "64").at({0, 0});
  }
  DxfText& end_block() { return group(0, "ENDBLK"); }
  DxfText& note(const std::string& words) {
    return group(0, "TEXT").group(8, "1").at({1, 1}).group(40, "0.25").group(1, words);
  }
  DxfText& polyline(const std::vector<Vec2>& points, bool closed = false, int layer = 1) {
    group(0, "POLYLINE")
        .group(8, std::to_string(layer))
        .group(66, "1")
        .group(70, closed ? "1" : "0");
    for (const Vec2& p : points) group(0, "VERTEX").group(8, std::to_string(layer)).at(p);
    return group(0, "SEQEND").group(8, std::to_string(layer));
  }
  DxfText& line(int layer, const Vec2& a, const Vec2& b) {
    return group(0, "LINE").group(8, std::to_string(layer)).at(a).at(b, 11);
  }
  DxfText& point(int layer, const Vec2& p) {
    return group(0, "POINT").group(8, std::to_string(layer)).at(p);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A garment of Gerber's manner: open polylines from turn point to turn point, pieces sideways. In
/// two sizes, the sample size 40: a half front with its mirror line at y = 0 (600 long, 250 wide;
/// in size 42 1.1 times that), and a sleeve cut twice with a notch in the middle of its cap. [mm]
inline std::string gerber_like_dxf(const std::string& units = "METRIC") {
  DxfText d;
  d.section("HEADER").end_section().section("BLOCKS");
  for (const auto& [size, k] : {std::pair{"40", 1.0}, std::pair{"42", 1.1}}) {
    d.block(fmt::format("FRONT_{}", size))
        .note("Piece Name: FRONT")
        .note(fmt::format("SIZE: {}", size));
    d.note("Quantity: 1").note("Category: FRONT");
    const Vec2 hem(0, 0), hem_side(0, 250 * k), arm(400 * k, 250 * k), shoulder(580 * k, 200 * k),
        neck(600 * k, 80 * k), middle(520 * k, 0);
    d.polyline({hem, hem_side}).polyline({hem_side, arm});
    d.polyline({arm, Vec2(430 * k, 215 * k), Vec2(500 * k, 195 * k), shoulder});
    d.polyline({shoulder, neck});
    d.polyline({neck, Vec2(560 * k, 70 * k), Vec2(521 * k, 20 * k), middle});
    d.polyline({middle, hem});
    d.line(6, middle, hem).line(7, {100, 100}, {400, 100}).line(8, {200, 10}, {200, 50});
    d.end_block();
    d.block(fmt::format("SLEEVE_{}", size))
        .note("PIECE NAME: SLEEVE")
        .note(fmt::format("Size: {}", size));
    d.note("Quantity: 1,1");
    d.polyline({{0, 0}, {0, 300 * k}});
    d.polyline({{0, 300 * k}, {200 * k, 400 * k}});
    d.polyline({{200 * k, 400 * k}, {350 * k, 180 * k}, {200 * k, -60 * k}});
    d.polyline({{200 * k, -60 * k}, {0, 0}});
    d.point(4, {350 * k, 180 * k}).line(7, {20, 150}, {200, 150});
    d.end_block();
  }
  d.end_section().section("ENTITIES");
  d.note("Style Name: tee").note("Sample Size: 40").note("Units: " + units);
  d.end_section().group(0, "EOF");
  return d.text();
}

}  // namespace loosefit
