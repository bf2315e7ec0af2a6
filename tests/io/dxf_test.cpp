#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "support/dxf_text.h"

namespace loosefit::io {
namespace {

/// A file of one piece, in millimetres.
std::string one_piece(const std::function<void(DxfText&)>& draw,
                      const std::string& units = "METRIC") {
  DxfText d;
  d.section("BLOCKS").block("P").note("Piece Name: P");
  draw(d);
  d.end_block().end_section().section("ENTITIES").note("Units: " + units);
  return d.end_section().group(0, "EOF").text();
}

pattern::Panel panel_of(const std::function<void(DxfText&)>& draw) {
  return parse_dxf_pattern(one_piece(draw), "p.dxf").pattern.panels.at(0);
}

double area(const pattern::Panel& panel) {
  return pattern::signed_area(pattern::outline_polygon(panel));
}

Vec2 extent(const pattern::Panel& panel) {
  Vec2 low = Vec2::Constant(1e9), high = -low;
  for (const Vec2& p : pattern::outline_polygon(panel))
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  return high - low;
}

std::string refusal(const std::string& text, const PatternWish& wish = {}) {
  try {
    parse_dxf_pattern(text, "x.dxf", wish);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

bool any_has(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& l) { return l.find(words) != std::string::npos; });
}

TEST(Dxf, HalfPieceUnfoldsToTwiceItsAreaWithTheGrainUp) {
  const PatternFile file = parse_dxf_pattern(gerber_like_dxf(), "tee.dxf");
  const pattern::Panel& front = file.pattern.panels.at(0);
  EXPECT_EQ(front.name, "FRONT");
  EXPECT_NEAR(extent(front).x(), 0.500, 1e-9);  // twice the half's width
  EXPECT_NEAR(extent(front).y(), 0.600, 1e-9);  // the grain ran along the file's x
  // Shoelace over the half piece in the file, by hand in the test's own order.
  const std::vector<Vec2> half{{0, 0},     {0, 250},  {400, 250}, {430, 215}, {500, 195},
                               {580, 200}, {600, 80}, {560, 70},  {521, 20},  {520, 0}};
  EXPECT_NEAR(area(front), 2 * std::abs(pattern::signed_area(half)) * 1e-6, 1e-9);
  // Hem and neckline go over the fold: 2 sides, 2 armholes, 2 shoulders, 1 hem, 1 neck.
  ASSERT_EQ(front.edges.size(), 8u);
  std::vector<double> lengths = pattern::edge_lengths(front);
  EXPECT_EQ(std::count_if(lengths.begin(), lengths.end(),
                          [](double l) { return std::abs(l - 0.5) < 1e-9; }),
            1)
      << "the hem";
  EXPECT_EQ(std::count_if(lengths.begin(), lengths.end(),
                          [](double l) { return std::abs(l - 0.4) < 1e-9; }),
            2)
      << "the sides";
  EXPECT_TRUE(any_has(file.unused, "layer 8 (internal lines): 1 LINE"));
  EXPECT_TRUE(any_has(file.unused, "2 pieces of other sizes"));
  EXPECT_TRUE(any_has(file.warnings, "no sew line"));
}

TEST(Dxf, MirroredTwinIsTheOtherHandAndKeepsItsNotch) {
  const PatternFile file = parse_dxf_pattern(gerber_like_dxf(), "tee.dxf");
  ASSERT_EQ(file.pattern.panels.size(), 3u);
  const pattern::Panel &sleeve = file.pattern.panels[1], &twin = file.pattern.panels[2];
  EXPECT_EQ(twin.name, "SLEEVE_mirrored");
  EXPECT_EQ(sleeve.edges.size(), 4u) << "a kink within a line that is one edge is no corner";
  EXPECT_NEAR(area(sleeve), area(twin), 1e-12);
  ASSERT_EQ(file.notches.size(), 2u);
  for (const char* name : {"e1", "e2", "e3", "e4"}) {
    const int a = pattern::find_edge(sleeve, name), b = pattern::find_edge(twin, name);
    const pattern::EdgePath one(sleeve, a), other(twin, b);
    EXPECT_NEAR(one.length(), other.length(), 1e-12) << name;
    const Vec2 p = one.at(0.3), q = other.at(0.7);
    EXPECT_NEAR(p.x(), -q.x(), 1e-12);
    EXPECT_NEAR(p.y(), q.y(), 1e-12);
  }
  for (const pattern::Notch& notch : file.notches) {
    const pattern::Panel& panel = file.pattern.panels[notch.panel];
    const Vec2 at = pattern::EdgePath(panel, notch.edge).at(notch.along);
    EXPECT_NEAR(at.y(), 0.35, 1e-9) << "the top of the cap";
  }
  pattern::check_pattern(file.pattern);
}

TEST(Dxf, SizesAreChosenOrRefused) {
  const std::string text = gerber_like_dxf();
  const auto width = [&](const std::string& size) {
    return extent(parse_dxf_pattern(text, "t", {size, ""}).pattern.panels[0]).x();
  };
  EXPECT_NEAR(width("42") / width("40"), 1.1, 1e-9);
  const std::string message = refusal(text, {"44", ""});
  EXPECT_NE(message.find("x.dxf: size: found \"44\""), std::string::npos) << message;
  std::string no_sample = text;
  no_sample.replace(no_sample.find("Sample Size: 40"), 15, "Sample Size: 99");
  EXPECT_NE(refusal(no_sample).find("2 sizes (40, 42)"), std::string::npos);
  EXPECT_EQ(refusal(no_sample, {"42", ""}), "");
}

TEST(Dxf, UnitsThatLieAreFoundOrAskedFor) {
  const auto square = [](double side) {
    return [side](DxfText& d) {
      d.polyline({{0, 0}, {side, 0}, {side, side / 2}, {0, side / 2}}, true);
      d.line(7, {1, 1}, {1, 2});
    };
  };
  const auto width = [&](double side, const std::string& units, const std::string& asked = "") {
    return extent(parse_dxf_pattern(one_piece(square(side), units), "u", {"", asked})
                      .pattern.panels[0])
        .x();
  };
  EXPECT_NEAR(width(700, "METRIC"), 0.7, 1e-12);
  EXPECT_NEAR(width(27.5, "ENGLISH"), 0.6985, 1e-12);
  EXPECT_NEAR(width(70, "METRIC"), 0.7, 1e-12) << "centimetres under METRIC";
  EXPECT_NEAR(width(118, "ENGLISH"), 1.18, 1e-12) << "3 m in inches: centimetres";
  EXPECT_NEAR(width(40, "", "inch"), 1.016, 1e-12);
  const std::string message = refusal(one_piece(square(40), ""));
  EXPECT_NE(message.find("units: found a largest piece of 40 file units"), std::string::npos)
      << message;
  EXPECT_NE(refusal(one_piece(square(5000))), "") << "5 m, 50 m, 5 km, 127 m";
  EXPECT_NE(refusal(one_piece(square(5)), {"", "ell"}), "");
}

TEST(Dxf, SewLineIsTakenBeforeTheBoundary) {
  const auto draw = [](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
    d.polyline({{10, 10}, {490, 10}, {490, 390}, {10, 390}}, true, 14);
    d.line(7, {50, 50}, {50, 90});
  };
  EXPECT_NEAR(area(panel_of(draw)), 0.48 * 0.38, 1e-12);
  const auto valentina = [](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
    d.polyline({{10, 10}, {490, 10}, {490, 390}, {10, 390}}, true, 8);
  };
  EXPECT_NEAR(area(panel_of(valentina)), 0.48 * 0.38, 1e-12);
  const auto pocket = [](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
    d.polyline({{200, 200}, {300, 200}, {300, 300}, {200, 300}}, true, 8);
  };
  EXPECT_NEAR(area(panel_of(pocket)), 0.5 * 0.4, 1e-12) << "a pocket is no sew line";
}

TEST(Dxf, ClosedPolylineIsCutAtTurnPointsThatAreKinks) {
  // A quarter of a ring: two straight sides, two arcs, with turn points also on the smooth arc.
  std::vector<Vec2> points;
  for (int i = 0; i <= 30; ++i)
    points.push_back(400 * Vec2(std::cos(kPi * i / 60), std::sin(kPi * i / 60)));
  for (int i = 30; i >= 0; --i)
    points.push_back(200 * Vec2(std::cos(kPi * i / 60), std::sin(kPi * i / 60)));
  const pattern::Panel panel = panel_of([&](DxfText& d) {
    d.polyline(points, true);
    for (const int i : {0, 15, 30, 31, 61}) d.point(2, points[i]);
  });
  ASSERT_EQ(panel.edges.size(), 4u);
  std::vector<double> lengths = pattern::edge_lengths(panel);
  std::sort(lengths.begin(), lengths.end());
  EXPECT_NEAR(lengths[0], 0.2, 1e-6);
  EXPECT_NEAR(lengths[3], 0.2 * kPi, 2e-4);
}

TEST(Dxf, ArcsBulgesAndSplinesAreCurves) {
  // A square of 400 mm with a half circle on one side: area a² + π r²/2.
  const double exact = 0.16 + kPi * 0.04 / 2;
  const auto bulge = [](DxfText& d) {
    d.group(0, "LWPOLYLINE").group(8, "1").group(90, "4").group(70, "1");
    d.at({0, 0}).at({400, 0}).number(42, 1).at({400, 400}).at({0, 400});
  };
  EXPECT_NEAR(area(panel_of(bulge)), exact, 5e-5);
  const auto arc = [](DxfText& d) {
    d.line(1, {0, 400}, {0, 0}).line(1, {0, 0}, {400, 0});
    d.group(0, "ARC").group(8, "1").at({400, 200}).number(40, 200).number(50, 270).number(51, 90);
    d.line(1, {400, 400}, {0, 400});
  };
  EXPECT_NEAR(area(panel_of(arc)), exact, 5e-5);
  EXPECT_EQ(panel_of(arc).edges.size(), 2u) << "the half circle leaves the square smoothly";
  // A cubic Bézier curve as a spline.
  const auto spline = [](DxfText& d) {
    d.line(1, {0, 400}, {0, 0}).line(1, {0, 0}, {400, 0});
    d.group(0, "SPLINE").group(8, "1").group(71, "3");
    for (const double k : {0, 0, 0, 0, 1, 1, 1, 1}) d.number(40, k);
    for (const Vec2& c : {Vec2(400, 0), Vec2(600, 0), Vec2(600, 400), Vec2(400, 400)}) d.at(c);
    d.line(1, {400, 400}, {0, 400});
  };
  // x(t) − 400 = 600 t (1 − t), y' = 2400 t (1 − t): ∫ = 600 · 2400 · B(3, 3) = 48 000 mm².
  EXPECT_NEAR(area(panel_of(spline)), 0.16 + 0.048, 3e-5);
}

TEST(Dxf, SpursAndRepeatedPointsGo) {
  const pattern::Panel panel = panel_of([](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}}).polyline({{500, 0}, {500, 0}, {500, 410}});
    d.polyline({{500, 410}, {500, 400}, {0, 400}, {-10, 400}}).polyline({{-10, 400}, {0, 400}});
    d.polyline({{0, 400}, {0, 0}});
  });
  EXPECT_NEAR(area(panel), 0.2, 1e-12);
  EXPECT_NEAR(extent(panel).x(), 0.5, 1e-12);
}

TEST(Dxf, PieceThatIsOpenIsLeftOutAloud) {
  DxfText d;
  d.section("BLOCKS")
      .block("A")
      .note("Piece Name: A")
      .polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
  d.end_block().block("B").note("Piece Name: B").polyline({{0, 0}, {500, 0}, {500, 400}});
  d.end_block()
      .end_section()
      .section("ENTITIES")
      .note("Units: METRIC")
      .end_section()
      .group(0, "EOF");
  const PatternFile file = parse_dxf_pattern(d.text(), "t.dxf");
  EXPECT_EQ(file.pattern.panels.size(), 1u);
  EXPECT_TRUE(any_has(file.warnings, "piece B (block at line")) << file.warnings.size();
  EXPECT_TRUE(any_has(file.warnings, "open by 640.31 mm"));
}

TEST(Dxf, BlocksOfOneNameAreDifferentPieces) {
  DxfText d;
  d.section("BLOCKS");
  for (int i = 0; i < 5; ++i)
    d.block("DETAIL").polyline({{0, 0}, {500, 0}, {500, 400.0 + i}, {0, 400}}, true).end_block();
  d.end_section().group(0, "EOF");
  const PatternFile file = parse_dxf_pattern(d.text(), "v.dxf", {"", "mm"});
  ASSERT_EQ(file.pattern.panels.size(), 5u);
  EXPECT_EQ(file.pattern.panels[4].name, "DETAIL_5");
}

TEST(Dxf, WhatCannotBeReadSaysWhere) {
  const std::string text = gerber_like_dxf();
  const auto line_message = [&](const std::string& damaged, const std::string& words) {
    const std::string message = refusal(damaged);
    EXPECT_EQ(message.rfind("x.dxf:", 0), 0u) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  line_message(text.substr(0, text.size() / 2), "the end of the file");
  std::string number = text;
  number.replace(number.find("250.0000"), 8, "25O.0000");
  line_message(number, "found \"25O.0000\", expected a number");
  std::string code = text;
  code.replace(code.find(" 66\n"), 4, " six\n");
  line_message(code, "expected a group code");
  std::string odd = text;
  odd.erase(odd.find(" 66\n"), 4);
  line_message(odd, "expected a group code");
  std::string comma = text;
  comma.replace(comma.find("250.0000"), 8, "250,0000");
  EXPECT_EQ(refusal(comma), "");
  std::string cr;
  for (const char c : text) cr += c == '\n' ? '\r' : c;
  EXPECT_EQ(refusal(cr), "");
  line_message("  0\nSECTION\n  2\nENTITIES\n  0\nENDSEC\n  0\nEOF\n",
               "none with lines on layer 1");
  line_message("AutoCAD Binary DXF\r\n\x1a", "binary");
}

}  // namespace
}  // namespace loosefit::io
