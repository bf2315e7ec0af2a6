#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/hole.h"
#include "support/dxf_text.h"

namespace loosefit::io {
namespace {

bool tells(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

std::vector<Vec2> rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// One of three ways in which a program hides a line of a layer.
enum class Hide { not_at_all, invisible, frozen, off };

void closed_line(DxfText& d, int layer, const std::vector<Vec2>& points, Hide hide) {
  d.group(0, "LWPOLYLINE").group(8, std::to_string(layer)).group(70, "1");
  if (hide == Hide::invisible) d.group(60, "1");
  for (const Vec2& p : points) d.at(p);
}

void layer_table(DxfText& d, int layer, Hide hide) {
  d.section("TABLES").group(0, "TABLE").group(2, "LAYER").group(70, "2");
  for (const int number : {1, 8, 11, 14})
    d.group(0, "LAYER")
        .group(2, std::to_string(number))
        .group(70, number == layer && hide == Hide::frozen ? "1" : "0")
        .group(62, number == layer && hide == Hide::off ? "-7" : "7");
  d.group(0, "ENDTAB").end_section();
}

/// A front of 500 x 700 mm with a sew line and a hole, and a back; the line on `layer` of the front
/// is hidden.
PatternFile with_hidden(int layer, Hide hide) {
  DxfText d;
  layer_table(d, layer, hide);
  const auto way = [&](int of) { return of == layer ? hide : Hide::not_at_all; };
  d.section("BLOCKS").block("F").note("Piece Name: FRONT");
  closed_line(d, 1, rectangle(0, 0, 500, 700), way(1));
  closed_line(d, 14, rectangle(10, 10, 480, 680), way(14));
  closed_line(d, 11, rectangle(200, 300, 100, 100), way(11));
  d.end_block().block("B").note("Piece Name: BACK");
  d.polyline(rectangle(0, 0, 400, 600), true, 84);
  d.end_block().end_section().section("ENTITIES").note("Units: METRIC").end_section();
  return parse_dxf_pattern(d.text() + "0\nEOF\n", "h.dxf");
}

TEST(UnseenLines, HiddenClothOfADxfIsNotSewnAndIsNamed) {
  for (const Hide hide : {Hide::invisible, Hide::frozen, Hide::off}) {
    const char* const why = hide == Hide::invisible ? "invisible"
                            : hide == Hide::frozen  ? "layer is frozen"
                                                    : "layer is off";
    SCOPED_TRACE(why);
    const PatternFile no_piece = with_hidden(1, hide);
    ASSERT_EQ(no_piece.pattern.panels.size(), 1u);
    EXPECT_EQ(no_piece.pattern.panels[0].name, "BACK");
    EXPECT_TRUE(tells(no_piece.warnings, "block \"F\""));
    EXPECT_TRUE(tells(no_piece.unused, why));

    const PatternFile cut = with_hidden(14, hide);
    ASSERT_EQ(cut.pattern.panels.size(), 2u);
    EXPECT_NEAR(pattern::cloth_area(cut.pattern.panels[0]), 0.5 * 0.7 - 0.01, 1e-6);
    EXPECT_TRUE(tells(cut.unused, "layer 14"));
    EXPECT_TRUE(tells(cut.warnings, why));

    const PatternFile no_hole = with_hidden(11, hide);
    EXPECT_NEAR(pattern::cloth_area(no_hole.pattern.panels[0]), 0.48 * 0.68, 1e-6);
    EXPECT_TRUE(tells(no_hole.unused, why));
  }
  const PatternFile all = with_hidden(0, Hide::not_at_all);
  EXPECT_NEAR(pattern::cloth_area(all.pattern.panels[0]), 0.48 * 0.68 - 0.01, 1e-6);
  EXPECT_FALSE(tells(all.unused, "hidden"));
}

TEST(UnseenLines, NothingThatCanBeSeenIsRefusedWithTheReason) {
  DxfText d;
  layer_table(d, 1, Hide::off);
  d.section("BLOCKS").block("F").note("Piece Name: FRONT");
  closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::off);
  d.end_block().end_section();
  try {
    parse_dxf_pattern(d.text() + "0\nEOF\n", "h.dxf");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("its layer is off"), std::string::npos)
        << error.what();
  }
}

TEST(UnseenLines, BlocksOfHiddenInsertsAreLeftOut) {
  for (const bool hidden : {false, true}) {
    DxfText d;
    d.section("BLOCKS");
    for (const char* name : {"F", "B"}) {
      d.block(name).note(std::string("Piece Name: ") + name);
      closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::not_at_all);
      d.end_block();
    }
    d.end_section().section("ENTITIES").note("Units: METRIC");
    d.group(0, "INSERT").group(8, "1").group(2, "F").at({0, 0});
    d.group(0, "INSERT").group(8, "1");
    if (hidden) d.group(60, "1");
    d.group(2, "B").at({0, 0}).end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "i.dxf");
    EXPECT_EQ(file.pattern.panels.size(), hidden ? 1u : 2u);
    EXPECT_EQ(tells(file.unused, "piece B: left out, its block is hidden"), hidden);
  }
}

TEST(UnseenLines, EllipsesAreOutlinesAndHoles) {
  std::mt19937 draw(62);
  std::uniform_real_distribution<double> half(250, 500), ratio(0.3, 1), turn(0, 3);
  for (int k = 0; k < 8; ++k) {
    const double a = half(draw), b = ratio(draw), angle = turn(draw);
    const Vec2 axis(a * std::cos(angle), a * std::sin(angle));
    DxfText d;
    d.section("BLOCKS").block("F").note("Piece Name: RING");
    for (const auto& [layer, share] : {std::pair{1, 1.0}, std::pair{11, 0.2}}) {
      d.group(0, "ELLIPSE").group(8, std::to_string(layer)).at({100, 50}).at(share * axis, 11);
      d.number(40, b).number(41, 0).group(42, "6.283185307179586");
    }
    d.end_block().end_section().section("ENTITIES").note("Units: METRIC").end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "e.dxf");
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    const double exact = 1e-6 * M_PI * a * a * b * (1 - 0.04);
    EXPECT_NEAR(pattern::cloth_area(file.pattern.panels[0]), exact, 2e-3 * exact);
  }
}

TEST(UnseenLines, CirclesOnTheLayersOfGrainAndMirrorTurnAndFoldNothing) {
  std::mt19937 draw(63);
  std::uniform_real_distribution<double> place(100, 300), radius(15, 60);
  for (const int layer : {6, 7, 14}) {
    DxfText d;
    d.section("BLOCKS").block("F").note("Piece Name: FRONT");
    closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::not_at_all);
    d.group(0, "CIRCLE").group(8, std::to_string(layer)).at({place(draw), place(draw)});
    d.number(40, radius(draw)).end_block().end_section();
    d.section("ENTITIES").note("Units: METRIC").end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "c.dxf");
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    double width = 0;
    for (const Vec2& v : file.pattern.panels[0].vertices)
      width = std::max(width, 2 * std::abs(v.x()));
    EXPECT_NEAR(width, 0.5, 1e-9) << layer;
    EXPECT_TRUE(tells(file.warnings, layer == 14 ? "less than half of the boundary"
                                                 : "circles or closed curves on layers 6 and 7"))
        << layer;
  }
}

std::string svg(const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1200mm\" height=\"900mm\" "
         "viewBox=\"0 0 1200 900\">" +
         body + "</svg>";
}

std::string path(const std::string& attributes, double x, double y, double width, double height) {
  return fmt::format("<path {} d=\"M{} {} h{} v{} h{} z\"/>", attributes, x, y, width, height,
                     -width);
}

const std::string kFront = path("id=\"front\"", 50, 50, 300, 400);

TEST(UnseenLines, WhatAViewerDoesNotShowIsSewnWithAWarning) {
  for (const char* style :
       {"fill:none;stroke:none", "opacity:0", "fill:none", "fill-opacity:0",
        "fill:transparent;stroke:none", "fill:none;stroke:red;stroke-width:0"}) {
    const PatternFile file = parse_svg_pattern(
        svg(kFront + path(fmt::format("id=\"back\" style=\"{}\"", style), 400, 50, 300, 400)),
        "u.svg");
    EXPECT_EQ(file.pattern.panels.size(), 2u);
    EXPECT_TRUE(tells(file.warnings, "piece back: its line is not to be seen")) << style;
    EXPECT_FALSE(tells(file.warnings, "piece front: its line is not"));
  }
  const PatternFile seen = parse_svg_pattern(svg(kFront + "<g style=\"fill:none;stroke:black\">" +
                                                 path("id=\"back\"", 400, 50, 300, 400) + "</g>"),
                                             "u.svg");
  EXPECT_FALSE(tells(seen.warnings, "not to be seen"));
}

TEST(UnseenLines, PiecesBesideThePageAreTold) {
  const PatternFile file =
      parse_svg_pattern(svg(kFront + path("id=\"back\"", 1300, 50, 300, 400)), "p.svg");
  EXPECT_EQ(file.pattern.panels.size(), 2u);
  EXPECT_TRUE(tells(file.warnings, "piece back: it stands outside of the page"));
  EXPECT_FALSE(tells(file.warnings, "piece front: it stands outside"));
}

TEST(UnseenLines, ClosedLinesOfElementsThatDrawNothingAreInTheAccount) {
  for (const char* element : {"clipPath", "mask", "marker", "pattern", "widget"})
    for (const bool defined : {false, true}) {
      if (defined && std::string(element) == "widget") continue;
      const std::string inner = fmt::format("<{0} id=\"lost\">", element) +
                                path("id=\"inside\"", 400, 50, 300, 400) +
                                fmt::format("</{}>", element);
      const PatternFile file = parse_svg_pattern(
          svg(kFront + (defined ? "<defs>" + inner + "</defs>" : inner)), "n.svg");
      EXPECT_EQ(file.pattern.panels.size(), 1u);
      EXPECT_TRUE(tells(file.unused, "\"lost\"")) << element << defined;
    }
  const PatternFile file =
      parse_svg_pattern(svg(kFront + "<foreignObject><p>cut 2</p></foreignObject>"), "n.svg");
  EXPECT_TRUE(tells(file.unused, "cut 2"));
}

TEST(UnseenLines, TestSquaresAndBordersAreNoPanelsAndAreNamed) {
  std::mt19937 draw(64);
  std::uniform_real_distribution<double> place(720, 1000);
  for (const double side : {25.4, 30.0, 40.0, 50.0, 50.8, 100.0, 101.6}) {
    const PatternFile file =
        parse_svg_pattern(svg(path("id=\"path1\"", 5, 5, 1190, 890) + kFront +
                              path("", place(draw), place(draw) - 300, side, side)),
                          "s.svg");
    EXPECT_EQ(file.pattern.panels.size(), 1u) << side;
    EXPECT_TRUE(tells(file.warnings, fmt::format("of {:.4g} x {:.4g} mm: left out", side, side)))
        << side;
    EXPECT_TRUE(tells(file.warnings, "of 1190 x 890 mm: left out"));
    EXPECT_TRUE(tells(file.unused, "frames, legends and test squares: 2"));
  }
  // With a name, a count or another size it is a piece; with words of a test it is none.
  const auto pieces = [](const std::string& more) {
    return parse_svg_pattern(svg(kFront + more), "s.svg").pattern.panels.size();
  };
  EXPECT_EQ(pieces(path("id=\"gusset\"", 800, 300, 100, 100)), 2u);
  EXPECT_EQ(pieces(path("data-quantity=\"2\"", 800, 300, 100, 100)), 3u);
  EXPECT_EQ(pieces(path("", 800, 300, 87, 87)), 2u);
  EXPECT_EQ(pieces(path("", 800, 300, 100, 120)), 2u);
  EXPECT_EQ(pieces(path("", 800, 300, 87, 87) + "<text x=\"820\" y=\"330\">test square</text>"),
            1u);
}

TEST(UnseenLines, LinesThatNearlyCloseAreNamedThoughTheyHaveNoName) {
  for (const double gap : {3.0, 10.0, 40.0}) {
    const PatternFile file = parse_svg_pattern(
        svg(kFront + fmt::format("<path d=\"M500 50 h300 v400 h-300 V{}\"/>", 50 + gap)), "o.svg");
    EXPECT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_TRUE(tells(file.warnings, fmt::format("its ends are {:g} mm apart", gap)));
  }
}

TEST(UnseenLines, ClosedLinesOfOtherClothsOfFreeSewingAreNamed) {
  for (const char* other :
       {"various", "canvas", "lining", "interfacing", "contrast", "mark help"}) {
    const std::string line = path(fmt::format("class=\"{}\"", other), 400, 60, 280, 380);
    const PatternFile file = parse_svg_pattern(
        "<svg freesewing=\"3\" xmlns=\"http://www.w3.org/2000/svg\" width=\"1200mm\" "
        "height=\"900mm\" viewBox=\"0 0 1200 900\"><g id=\"fs-part-front\">" +
            path("class=\"fabric\"", 50, 50, 300, 400) + "</g><g id=\"fs-part-inner\">" + line +
            "</g></svg>",
        "f.svg");
    EXPECT_TRUE(tells(file.warnings, fmt::format("is left out, it is of class \"{}\"", other)));
    EXPECT_TRUE(tells(file.unused, "part inner"));
  }
}

TEST(UnseenLines, FacingsOfANecklineAreNoHoles) {
  for (const char* name : {"neckline facing", "neck hole binding", "Halsloch Beleg"}) {
    const PatternFile file = parse_svg_pattern(
        svg(kFront + path(fmt::format("id=\"{}\"", name), 100, 60, 150, 40)), "n.svg");
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_TRUE(file.pattern.panels[0].holes.empty()) << name;
    EXPECT_TRUE(tells(file.warnings, name));
  }
}

TEST(UnseenLines, CopiesBeyondAPairAreNamedAsLeftOut) {
  for (int n = 3; n <= 8; ++n) {
    const PatternFile file = parse_svg_pattern(
        svg(path(fmt::format("id=\"gore\" data-quantity=\"{}\"", n), 50, 50, 300, 400)), "g.svg");
    const bool pairs = n % 2 == 0;
    EXPECT_EQ(file.pattern.panels.size(), pairs ? 2u : 1u);
    const std::string words =
        fmt::format("it is cut {} times (\"{}\"); gore{} taken, {} more", n, n,
                    pairs ? " and gore_mirrored are" : " is", n - (pairs ? 2 : 1));
    EXPECT_TRUE(tells(file.warnings, words)) << words;
    EXPECT_TRUE(tells(file.unused, words));
  }
}

TEST(UnseenLines, TextsThatAreNotReadAreInTheAccount) {
  const PatternFile file = parse_svg_pattern(
      svg(kFront + "<text x=\"100\" y=\"200\">N 7</text><text x=\"1100\" y=\"800\">cut 2</text>"
                   "<text x=\"100\" y=\"300\">cut both left</text>"),
      "t.svg");
  EXPECT_TRUE(tells(file.unused, "\"N 7\""));
  EXPECT_TRUE(tells(file.warnings, "text \"cut 2\" at line 1: it stands in no piece"));
  EXPECT_TRUE(tells(file.warnings, "its text \"cut both left\" may say how often"));
}

TEST(UnseenLines, ClosedLinesOfADxfThatLieInNoOutlineAreNamed) {
  for (const int layer : {11, 84}) {
    DxfText d;
    d.section("BLOCKS").block("F").note("Piece Name: FRONT");
    closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::not_at_all);
    closed_line(d, layer, rectangle(700, 100, 90, 80), Hide::not_at_all);
    d.end_block().end_section().section("ENTITIES").note("Units: METRIC").end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "c.dxf");
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_TRUE(file.pattern.panels[0].holes.empty());
    EXPECT_TRUE(tells(file.warnings, fmt::format("on layer {}", layer))) << layer;
  }
}

TEST(UnseenLines, CountsOutsideOfTheBlocksOfADxfAreNamed) {
  for (const char* text : {"CUT 2", "Quantity: 2", "2 x sleeve", "1 pair"}) {
    DxfText d;
    d.section("BLOCKS").block("F").note("Piece Name: SLEEVE");
    closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::not_at_all);
    d.end_block().end_section().section("ENTITIES").note("Units: METRIC").note(text).end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "t.dxf");
    EXPECT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_TRUE(tells(file.warnings, fmt::format("text \"{}\" at line", text))) << text;
  }
}

TEST(UnseenLines, TestSquaresAndTitlesOfADxfAreNoPieces) {
  for (const char* name :
       {"TEST SQUARE", "Testquadrat Test Square", "Title block", "SCALE 10cm", "Page frame"}) {
    DxfText d;
    d.section("BLOCKS");
    for (const char* called : {"FRONT", name}) {
      d.block(called).note(std::string("Piece Name: ") + called);
      closed_line(d, 1, rectangle(0, 0, 500, 700), Hide::not_at_all);
      d.end_block();
    }
    d.end_section().section("ENTITIES").note("Units: METRIC").end_section();
    const PatternFile file = parse_dxf_pattern(d.text() + "0\nEOF\n", "s.dxf");
    EXPECT_EQ(file.pattern.panels.size(), 1u) << name;
    EXPECT_TRUE(tells(file.unused, std::string("piece ") + name + ": left out")) << name;
    EXPECT_TRUE(tells(file.warnings, std::string("piece ") + name + ": left out")) << name;
  }
}

TEST(UnseenLines, PagesOfTwoScalesAreRefusedWhereTheyDistort) {
  const auto read = [](const char* how, double height) {
    return parse_svg_pattern(
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1200mm\" height=\"{}mm\" "
                    "viewBox=\"0 0 1200 900\" preserveAspectRatio=\"{}\">",
                    height, how) +
            kFront + "</svg>",
        "d.svg");
  };
  EXPECT_NO_THROW(read("none", 900));
  EXPECT_NO_THROW(read("xMidYMid", 500));
  for (const double height : {450.0, 880.0, 1000.0})
    EXPECT_THROW(read("none", height), InvalidInput);
}

TEST(UnseenLines, PanelsOfAGarmentCodeFileThatNothingSewsAreNamed) {
  const auto panel = [](int k) {
    return fmt::format(
        "\"p{}\": {{\"vertices\": [[0,0],[30,0],[30,40],[0,40]], \"edges\": [{{\"endpoints\": "
        "[0,1]}},{{\"endpoints\": [1,2]}},{{\"endpoints\": [2,3]}},{{\"endpoints\": [3,0]}}], "
        "\"translation\": [0,100,{}], \"rotation\": [0,0,0]}}",
        k, 20 * k);
  };
  for (int loose = 0; loose < 3; ++loose) {
    const int a = loose == 0 ? 1 : 0, b = loose == 2 ? 1 : 2;
    const PatternFile file = parse_garmentcode(
        "{\"pattern\": {\"panels\": {" + panel(0) + ", " + panel(1) + ", " + panel(2) +
            fmt::format("}}, \"stitches\": [[{{\"panel\": \"p{}\", \"edge\": 1}}, {{\"panel\": "
                        "\"p{}\", \"edge\": 3}}]]}}, \"properties\": {{\"curvature_coords\": "
                        "\"relative\", \"units_in_meter\": 100}}}}",
                        a, b),
        "g.json");
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(tells(file.warnings, fmt::format("panel p{}: no stitch", k)), k == loose);
      EXPECT_EQ(tells(file.used, fmt::format("panel p{}: its outline, sewn to nothing", k)),
                k == loose);
    }
  }
}

}  // namespace
}  // namespace loosefit::io
