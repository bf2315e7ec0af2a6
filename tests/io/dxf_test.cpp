#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

TEST(Dxf, KeysAreReadInTheLanguagesOfMakers) {
  const std::string english = gerber_like_dxf();
  const auto with = [&](std::vector<std::pair<std::string, std::string>> words) {
    std::string text = english;
    for (const auto& [from, to] : words)
      for (std::size_t at = 0; (at = text.find("\n" + from + ":", at)) != std::string::npos;
           at += to.size())
        text.replace(at + 1, from.size(), to);
    return text;
  };
  const PatternFile read = parse_dxf_pattern(english, "t");
  for (const auto& [sample, size, units] : {std::array{"Basisgröße", "Größe", "Einheiten"},
                                            {"BASISGRÖSSE", "GRÖSSE", "EINHEIT"},
                                            {"Grundgroesse", "Groesse", "Masseinheit"},
                                            {"Taille de base", "Taille", "Unités"},
                                            {"TALLA BASE", "TALLA", "UNIDADES"},
                                            {"Taglia base", "Taglia", "Unità"},
                                            {"Tamanho base", "Tamanho", "Unidades"},
                                            {"Basismaat", "Maat", "Eenheden"},
                                            {"SAMPLE SIZE", "SIZE", "UNITS"},
                                            {"Base Size", "size", "Unit"}}) {
    SCOPED_TRACE(size);
    const PatternFile same =
        parse_dxf_pattern(with({{"Sample Size", sample}, {"Size", size}, {"Units", units}}), "t");
    EXPECT_EQ(same.about, read.about);
    EXPECT_EQ(same.unused, read.unused);
    ASSERT_EQ(same.pattern.panels.size(), read.pattern.panels.size());
    for (std::size_t p = 0; p < read.pattern.panels.size(); ++p)
      EXPECT_EQ(extent(same.pattern.panels[p]), extent(read.pattern.panels[p]));
  }
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
  EXPECT_NEAR(width(230, "METRIC"), 0.23, 1e-12) << "a sock";
  EXPECT_NEAR(width(70, "METRIC"), 0.07, 1e-12) << "what the file states, however small";
  EXPECT_NEAR(width(118, "ENGLISH"), 118 * 0.0254, 1e-12) << "and however large";
  EXPECT_NEAR(width(40, "", "inch"), 1.016, 1e-12);
  const auto warnings = [&](double side, const std::string& units) {
    return parse_dxf_pattern(one_piece(square(side), units), "u").warnings;
  };
  EXPECT_FALSE(any_has(warnings(20, "ENGLISH"), "units")) << "0.2 m would be no garment";
  EXPECT_TRUE(any_has(warnings(70, "METRIC"), "it would be 0.7 m in centimetres"));
  EXPECT_TRUE(any_has(warnings(118, "ENGLISH"), "it would be 1.18 m in centimetres"));
  EXPECT_TRUE(any_has(warnings(40, "ENGLISH"), "largest piece 0.4 m in centimetres"));
  EXPECT_NEAR(width(40, "ENGLISH"), 1.016, 1e-12);
  EXPECT_TRUE(any_has(warnings(62, "ENGLISH"), "taken as inches"));
  EXPECT_TRUE(any_has(warnings(62, "ENGLISH"), "0.62 m in centimetres"));
  try {
    parse_dxf_pattern(one_piece(square(62), ""), "u");
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.hint().find("--units mm, cm, m or inch, in a scenario garment.units"),
              std::string::npos)
        << error.hint();
  }
  EXPECT_NEAR(width(62, "ENGLISH", "inch"), 1.5748, 1e-12);
  std::string of_clo = one_piece(square(62), "ENGLISH");
  of_clo.replace(of_clo.find("Units: "), 7,
                 "Author: CLO Virtual Fashion Inc.\n  0\nTEXT\n  8\n1\n"
                 " 10\n0\n 20\n0\n  1\nUnits: ");
  const PatternFile clo = parse_dxf_pattern(of_clo, "u");
  EXPECT_NEAR(extent(clo.pattern.panels[0]).x(), 0.62, 1e-12);
  EXPECT_TRUE(any_has(clo.warnings, "CLO Virtual Fashion Inc., writes centimetres"));
  const std::string message = refusal(one_piece(square(40), ""));
  EXPECT_NE(message.find("units: found a largest piece of 40 file units"), std::string::npos)
      << message;
  EXPECT_NE(refusal(one_piece(square(5000), "")), "") << "5 m, 50 m, 5 km, 127 m";
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

/// Pieces by name, of which some are drawn by `draw`.
std::string pieces_of(
    const std::vector<std::pair<std::string, std::function<void(DxfText&)>>>& all) {
  DxfText d;
  d.section("BLOCKS");
  for (const auto& [name, draw] : all) {
    d.block(name).note("Piece Name: " + name);
    draw(d);
    d.end_block();
  }
  d.end_section().section("ENTITIES").note("Units: METRIC");
  return d.end_section().group(0, "EOF").text();
}

/// Width at the lower end.
double width_below(const pattern::Panel& panel) {
  double low = 0, high = 0;
  for (const Vec2& p : pattern::outline_polygon(panel))
    if (p.y() < 1e-9) low = std::min(low, p.x()), high = std::max(high, p.x());
  return high - low;
}

TEST(Dxf, WhichEndOfTheGrainLineIsDrawnFirstDoesNotMatter) {
  // 500 wide below, 300 above, leaning by 10 degrees in one of them.
  const auto upright = [](const Vec2& from, const Vec2& to) {
    return [from, to](DxfText& d) {
      d.polyline({{0, 0}, {500, 0}, {400, 600}, {100, 600}}, true).line(7, from, to);
    };
  };
  for (const bool down : {false, true}) {
    const Vec2 low(250, 100), high(250, 500);
    const pattern::Panel panel = panel_of(down ? upright(high, low) : upright(low, high));
    EXPECT_NEAR(width_below(panel), 0.5, 1e-9) << down;
  }
  const Vec2 lean = 100 * Vec2(std::sin(radians(50)), std::cos(radians(50)));
  for (const double sign : {-1.0, 1.0}) {
    const pattern::Panel bias = panel_of(upright({0, 0}, sign * lean));
    EXPECT_LT(bias.vertices[bias.edges[0].start].y(), 0.4) << "turned by 50 degrees, not by 130";
  }
  // Sideways all go the way that most point to.
  const auto sideways = [](double to) {
    return [to](DxfText& d) {
      d.polyline({{0, 0}, {600, 100}, {600, 400}, {0, 500}}, true);
      d.line(7, {300, 250}, {300 + to, 250 + to / 20});
    };
  };
  const PatternFile right = parse_dxf_pattern(
      pieces_of({{"a", sideways(90)}, {"b", sideways(-90)}, {"c", sideways(90)}}), "p.dxf");
  for (const pattern::Panel& panel : right.pattern.panels) {
    const double top = extent(panel).y();
    EXPECT_GT(panel.vertices[panel.edges[1].start].y(), top / 2) << panel.name;
  }
  const PatternFile left = parse_dxf_pattern(
      pieces_of({{"a", sideways(-90)}, {"b", sideways(-90)}, {"c", sideways(90)}}), "p.dxf");
  for (const pattern::Panel& panel : left.pattern.panels)
    EXPECT_LT(panel.vertices[panel.edges[1].start].y(), extent(panel).y() / 2) << panel.name;
}

TEST(Dxf, LinesBesideTheOutlineArePiecesOrTold) {
  const auto square = [](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
  };
  const PatternFile second = parse_dxf_pattern(one_piece([&](DxfText& d) {
                                                 square(d);
                                                 d.polyline({{600, 0}, {900, 0}, {900, 200}}, true);
                                                 d.polyline({{0, 500}, {100, 500}, {100, 600}});
                                               }),
                                               "p.dxf");
  ASSERT_EQ(second.pattern.panels.size(), 2u);
  EXPECT_NEAR(area(second.pattern.panels[0]), 0.2, 1e-12);
  EXPECT_NEAR(area(second.pattern.panels[1]), 0.03, 1e-12);
  EXPECT_TRUE(any_has(second.warnings, "piece P: 1 open lines on layer 1 beside its outline"));
  // The same outline once more is no other one.
  const PatternFile twice = parse_dxf_pattern(one_piece([&](DxfText& d) {
                                                square(d);
                                                square(d);
                                              }),
                                              "p.dxf");
  EXPECT_FALSE(any_has(twice.warnings, "beside the largest one"));
  // A boundary with a gap and a hole that closes: the hole is not the piece.
  const std::string message = refusal(one_piece([](DxfText& d) {
    d.polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}, {0, 3}});
    d.polyline({{100, 100}, {200, 100}, {200, 200}}, true);
  }));
  EXPECT_NE(message.find("open by 3.00 mm"), std::string::npos) << message;
}

TEST(Dxf, SewLineHasItsOwnCornersWhereTurnPointsAreThoseOfTheBoundary) {
  for (const int layer : {8, 14})
    for (const bool hem_in_common : {false, true}) {
      SCOPED_TRACE(layer);
      const double hem = hem_in_common ? 0 : 10;
      const pattern::Panel panel = panel_of([&](DxfText& d) {
        const std::vector<Vec2> cut{{0, 0}, {500, 0}, {500, 400}, {0, 400}};
        d.polyline(cut, true);
        for (const Vec2& p : cut) d.point(2, p);
        if (hem_in_common) d.point(2, {10, 0});
        d.polyline({{10, hem}, {490, hem}, {490, 390}, {250, 380}, {10, 390}}, true, layer);
      });
      EXPECT_EQ(panel.edges.size(), 4u);
    }
}

TEST(Dxf, PiecesOfAnotherClothAreLeftOut) {
  const auto of = [](const std::string& text) {
    return [text](DxfText& d) {
      d.note(text).polyline({{0, 0}, {500, 0}, {500, 400}, {0, 400}}, true);
    };
  };
  const PatternFile file =
      parse_dxf_pattern(pieces_of({{"A", of("Fabric: SELF")},
                                   {"B", of("Fabric: Interlining 2")},
                                   {"C", of("Category: FUTTER")},
                                   {"D", of("Annotation: Cut 2 Fusible")},
                                   {"E", of("Material: Entretela")},
                                   {"F", of("Annotation: fusible tape at the neck")},
                                   {"G", of("Fabric: Self, Lining")}}),
                        "p.dxf");
  std::string kept;
  for (const pattern::Panel& panel : file.pattern.panels) kept += panel.name;
  EXPECT_EQ(kept, "AFG");
  EXPECT_TRUE(any_has(file.warnings, "piece B: left out"));
  EXPECT_TRUE(any_has(file.warnings, "Category \"FUTTER\""));
  EXPECT_FALSE(any_has(file.unused, "other sizes"));
  const PatternFile lining = parse_dxf_pattern(
      pieces_of({{"A", of("Fabric: LINING")}, {"B", of("Fabric: LINING")}}), "p.dxf");
  EXPECT_EQ(lining.pattern.panels.size(), 2u) << "somebody wears a lining alone";
}

TEST(Dxf, NotchesMayBeDrawnAsLinesOfAnyKind) {
  const auto along = [](const std::function<void(DxfText&)>& notch) {
    const PatternFile file = parse_dxf_pattern(
        one_piece([&](DxfText& d) {
          d.polyline({{0, 0}, {500, 0}}).polyline({{500, 0}, {500, 400}, {0, 400}, {0, 0}});
          notch(d);
        }),
        "p.dxf");
    return file.notches.size() == 1 && file.notches[0].edge == 0 ? file.notches[0].along : -1;
  };
  EXPECT_NEAR(along([](DxfText& d) { d.point(4, {200, 0}); }), 0.4, 1e-9);
  EXPECT_NEAR(along([](DxfText& d) { d.polyline({{200, 0}, {200, 6}}, false, 4); }), 0.4, 1e-9);
  EXPECT_NEAR(along([](DxfText& d) {
                d.polyline({{198, 0}, {200, 6}, {202, 0}}, false, 80);
              }),
              0.4, 1e-9);
  EXPECT_NEAR(along([](DxfText& d) {
                d.polyline({{198, 0}, {202, 0}, {202, 6}, {198, 6}}, true, 4);
              }),
              0.4, 1e-9);
}

}  // namespace
}  // namespace loosefit::io
