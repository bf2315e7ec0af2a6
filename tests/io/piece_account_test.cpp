#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/io/freesewing_json.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/known_garment.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "support/pattern_design.h"

namespace loosefit::io {
namespace {

using namespace testing_support;

bool tells(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

std::string all(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Area in mm², holes and lengths of edges in mm of a piece, for comparison.
struct Cut {
  double area = 0;
  std::size_t holes = 0;
  std::vector<double> edges;
};

std::vector<Cut> cuts_of(const pattern::Pattern& pattern) {
  pattern::check_pattern(pattern);
  std::vector<Cut> cuts;
  for (const pattern::Panel& panel : pattern.panels) {
    Cut cut{1e6 * pattern::cloth_area(panel), panel.holes.size(), {}};
    for (const double length : pattern::edge_lengths(panel)) cut.edges.push_back(1e3 * length);
    std::sort(cut.edges.begin(), cut.edges.end());
    cuts.push_back(cut);
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.area < b.area; });
  return cuts;
}

void expect_same(const std::vector<Cut>& a, const std::vector<Cut>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].area, b[i].area, 1e-3 * b[i].area / 100 + 1);
    EXPECT_EQ(a[i].holes, b[i].holes);
    ASSERT_EQ(a[i].edges.size(), b[i].edges.size());
    for (std::size_t e = 0; e < a[i].edges.size(); ++e)
      EXPECT_NEAR(a[i].edges[e], b[i].edges[e], 0.05);
  }
}

std::vector<Cut> expected(const Design& design) {
  std::vector<Cut> cuts;
  for (const DesignPart& part : design)
    for (std::size_t k = 0; k < part.areas.size(); ++k)
      cuts.push_back({part.areas[k], static_cast<std::size_t>(part.hole_count[k]), {}});
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.area < b.area; });
  return cuts;
}

using Dialects = std::map<std::string, PatternFile>;

Dialects read_all(const Design& design) {
  Dialects files;
  files["FreeSewing SVG"] = parse_svg_pattern(as_freesewing_svg(design), "d.svg");
  files["FreeSewing JSON"] = parse_freesewing_json(as_freesewing_json(design), "d.json");
  for (const int how : {0, 1}) {
    files["Inkscape " + std::to_string(how)] =
        parse_svg_pattern(as_inkscape_svg(design, how), "d.svg");
    files["DXF " + std::to_string(how)] = parse_dxf_pattern(as_dxf(design, how), "d.dxf");
  }
  return files;
}

TEST(PatternAccount, EveryDialectOfADesignIsTheSamePieces) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Design design = drawn_design(seed);
    const std::vector<Cut> wanted = expected(design);
    std::vector<Cut> first;
    for (const auto& [dialect, file] : read_all(design)) {
      SCOPED_TRACE(dialect + ", seed " + std::to_string(seed) + "\n" + all(file.warnings));
      const std::vector<Cut> cuts = cuts_of(file.pattern);
      ASSERT_EQ(cuts.size(), wanted.size());
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        EXPECT_NEAR(cuts[i].area, wanted[i].area, 1e-4 * wanted[i].area);
        EXPECT_EQ(cuts[i].holes, wanted[i].holes);
      }
      if (first.empty()) first = cuts;
      expect_same(cuts, first);
      EXPECT_EQ(file.used.size(), 7u) << all(file.used);  // twins stand in one line
      EXPECT_TRUE(tells(file.used, "unfolded at 2 fold lines")) << all(file.used);
      EXPECT_TRUE(tells(file.used, "once as drawn, once mirrored")) << all(file.used);
      EXPECT_FALSE(tells(file.warnings, "not cut"));
      EXPECT_FALSE(tells(file.warnings, "not used"));
    }
  }
}

/// Lengths of both sides of every seam of a garment that is known, in mm.
std::vector<double> seam_lengths(const pattern::Pattern& pattern, const std::string& kind) {
  const pattern::KnownGarment known = pattern::know_garment(pattern);
  EXPECT_EQ(known.kind, kind);
  EXPECT_TRUE(known.certain()) << all(known.doubts);
  std::vector<double> lengths;
  for (const pattern::ChainSeam& seam : known.seams)
    for (const auto* run : {&seam.first, &seam.second}) {
      double length = 0;
      for (const pattern::Stitch::Side& side : *run)
        length += 1e3 * pattern::EdgePath(pattern.panels[side.panel], side.edge).length();
      lengths.push_back(length);
    }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(PatternAccount, EveryDialectOfASkirtIsSewnAlike) {
  for (const double flare : {60.0, 110.0, 170.0}) {
    Design skirt;
    for (const char* name : {"skirtFront", "skirtBack"}) {
      DesignPart half{name, {{{0, 0}, {200 + flare, 0}, {200, 600}, {0, 600}}}, {}, {}, "", {}, {}};
      half.folds = {{{0, 100}, {0, 500}}};
      half.holes = {moved(arc(40, 0, 350, 35), {100, 300})};
      skirt.push_back(half);
    }
    const double side = std::hypot(flare, 600);
    for (const auto& [dialect, file] : read_all(skirt)) {
      SCOPED_TRACE(dialect);
      const std::vector<double> lengths = seam_lengths(file.pattern, "skirt");
      ASSERT_EQ(lengths.size(), 4u);
      for (const double length : lengths) EXPECT_NEAR(length, side, 0.01);
    }
  }
}

TEST(PatternAccount, NamesOfHolesOutliveTheirShapesAndTheirTwins) {
  for (const double width : {60.0, 15.0}) {
    // A hole that bends round its middle, with a twin of the same name beside it.
    pattern::Pattern tunic;
    pattern::Panel& panel = tunic.panels.emplace_back();
    panel.name = "tunic";
    panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int e = 0; e < 4; ++e) {
      pattern::PanelEdge edge;
      edge.start = e, edge.end = (e + 1) % 4;
      panel.edges.push_back(edge);
    }
    for (const double x : {0.25, 0.75}) {
      pattern::PanelHole bent{"neck hole", {}};
      for (int i = 0; i <= 24; ++i) {
        const double turn = radians(10 * i);
        bent.points.push_back(Vec2(x, 0.5) + 0.1 * Vec2(std::cos(turn), std::sin(turn)));
      }
      for (int i = 24; i >= 0; --i) {
        const double turn = radians(10 * i);
        bent.points.push_back(Vec2(x, 0.5) +
                              (0.1 - 1e-3 * width) * Vec2(std::cos(turn), std::sin(turn)));
      }
      panel.holes.push_back(bent);
    }
    const std::vector<std::string> wanted = {"neck hole", "neck hole 2"};
    for (const PatternFile& file : {parse_garmentcode(garmentcode_text(tunic), "again.json"),
                                    parse_dxf_pattern(dxf_text(tunic, {}, {}), "again.dxf")}) {
      ASSERT_EQ(file.pattern.panels.size(), 1u);
      std::vector<std::string> names;
      for (const pattern::PanelHole& hole : file.pattern.panels[0].holes)
        names.push_back(hole.name);
      EXPECT_EQ(names, wanted);
    }
  }
}

TEST(PatternAccount, HolesOutliveEveryFileThatIsWritten) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const PatternFile file = parse_svg_pattern(as_inkscape_svg(drawn_design(seed), 0), "d.svg");
    const std::vector<Cut> cuts = cuts_of(file.pattern);
    std::vector<std::string> names;
    for (const pattern::Panel& panel : file.pattern.panels)
      for (const pattern::PanelHole& hole : panel.holes) names.push_back(hole.name);
    ASSERT_EQ(names.size(), 6u);
    const auto check = [&](const pattern::Pattern& again) {
      expect_same(cuts_of(again), cuts);
      std::size_t found = 0;
      for (const pattern::Panel& panel : again.panels)
        for (const pattern::PanelHole& hole : panel.holes)
          found += std::count(names.begin(), names.end(), hole.name) > 0;
      EXPECT_EQ(found, 6u);
    };
    const std::string json = garmentcode_text(file.pattern);
    const PatternFile again = parse_garmentcode(json, "again.json");
    check(again.pattern);
    EXPECT_FALSE(tells(again.warnings, "keys not read")) << all(again.warnings);
    EXPECT_EQ(garmentcode_text(again.pattern), json);
    check(parse_svg_pattern(pattern_svg(file.pattern), "again.svg").pattern);
    check(parse_dxf_pattern(dxf_text(file.pattern, file.notches, {}), "again.dxf").pattern);
  }
}

std::string tunic(const std::string& more, const std::string& name = "tunic") {
  return svg_page("", "<g><path inkscape:label=\"" + name +
                          "\" d=\"M 50,50 H 650 V 900 H 50 z\"/>\n" + more + "</g>");
}
const char* const kCircle = "M 250,500 A 100,90 0 1 0 450,500 A 100,90 0 1 0 250,500 z";
double circle_area() { return kPi * 100 * 90; }

double area_mm2(const PatternFile& file) {
  return 1e6 * pattern::cloth_area(file.pattern.panels[0]);
}

TEST(PatternAccount, LineCalledAHoleByItsNameOrATextInItIsCut) {
  for (const char* called : {"neck hole", "Hole", "cutout", "Halsloch", "Aussparung", "keyhole"}) {
    const PatternFile file = parse_svg_pattern(
        tunic("<path inkscape:label=\"" + std::string(called) + "\" d=\"" + kCircle + "\"/>"), "t");
    ASSERT_EQ(file.pattern.panels.size(), 1u) << called;
    EXPECT_NEAR(area_mm2(file), 600 * 850 - circle_area(), 50) << called;
    EXPECT_TRUE(tells(file.used, called)) << all(file.used);
  }
  const PatternFile by_group =
      parse_svg_pattern(tunic("<g inkscape:label=\"holes\"><path d=\"" + std::string(kCircle) +
                              "\"/><circle cx=\"300\" cy=\"150\" r=\"30\"/></g>"),
                        "t");
  EXPECT_NEAR(area_mm2(by_group), 600 * 850 - circle_area() - kPi * 900, 60);
  const PatternFile by_text =
      parse_svg_pattern(tunic("<path d=\"" + std::string(kCircle) +
                              "\"/><text x=\"330\" y=\"500\"><tspan>neck\n hole</tspan></text>"),
                        "t");
  EXPECT_NEAR(area_mm2(by_text), 600 * 850 - circle_area(), 50);
  EXPECT_TRUE(tells(by_text.used, "\"neck hole\""));
}

TEST(PatternAccount, HoleOfAPieceOfOpenLinesIsCutAndOneInNoPieceIsTold) {
  const std::string sides =
      "<path d=\"M 50,50 H 650\"/><path d=\"M 650,50 V 900\"/><path d=\"M 650,900 H 50\"/>"
      "<path d=\"M 50,900 V 50\"/>";
  const std::string hole =
      "<path inkscape:label=\"neck hole\" d=\"" + std::string(kCircle) + "\"/>";
  const PatternFile open =
      parse_svg_pattern(svg_page("", "<g inkscape:label=\"tunic\">" + sides + hole + "</g>"), "t");
  ASSERT_EQ(open.pattern.panels.size(), 1u);
  EXPECT_NEAR(area_mm2(open), 600 * 850 - circle_area(), 50);
  const PatternFile lone = parse_svg_pattern(
      svg_page("", "<g inkscape:label=\"tunic\">" + sides +
                       "</g><circle id=\"neck-hole\" cx=\"2000\" cy=\"0\" r=\"90\"/>"),
      "t");
  ASSERT_EQ(lone.pattern.panels.size(), 1u);
  EXPECT_TRUE(tells(lone.warnings, "\"neck-hole\"")) << all(lone.warnings);
}

TEST(PatternAccount, LineThatIsNotCutIsNamedInAWarning) {
  for (const char* called : {"pocket place", "badge", "buttonhole"}) {
    const PatternFile file = parse_svg_pattern(
        tunic("<path inkscape:label=\"" + std::string(called) + "\" d=\"" + kCircle + "\"/>"), "t");
    EXPECT_NEAR(area_mm2(file), 600 * 850, 1e-3);
    EXPECT_TRUE(tells(file.warnings, '"' + std::string(called) + '"')) << all(file.warnings);
    EXPECT_TRUE(tells(file.unused, called)) << all(file.unused);
  }
  const PatternFile small = parse_svg_pattern(
      tunic("<circle inkscape:label=\"thumb hole\" cx=\"300\" cy=\"300\" r=\"8\"/>"), "t");
  EXPECT_TRUE(tells(small.warnings, "thumb hole")) << all(small.warnings);
  const PatternFile text =
      parse_svg_pattern(tunic("<text x=\"330\" y=\"500\">neck hole</text>"), "t");
  EXPECT_TRUE(tells(text.warnings, "\"neck hole\"")) << all(text.warnings);
}

TEST(PatternAccount, HoleThatTouchesTheOutlineIsRefusedByName) {
  for (const double x : {149.9, 150.0, 120.0}) {
    const PatternFile file = parse_svg_pattern(
        tunic(
            fmt::format("<circle inkscape:label=\"arm hole\" cx=\"{}\" cy=\"400\" r=\"100\"/>", x)),
        "t");
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_NEAR(area_mm2(file), 600 * 850, 1e-3);
    EXPECT_TRUE(tells(file.warnings, "its hole \"arm hole\" is not cut")) << all(file.warnings);
  }
}

TEST(PatternAccount, HoleAcrossAFoldIsCutOnceWhereItIsSymmetric) {
  const std::string fold = "<path inkscape:label=\"fold\" d=\"M 50,60 V 300\"/>";
  const auto circle = [](double x) {
    return fmt::format("<circle inkscape:label=\"neck hole\" cx=\"{}\" cy=\"400\" r=\"80\"/>", x);
  };
  const PatternFile across = parse_svg_pattern(tunic(fold + circle(50), "panel"), "t");
  EXPECT_NEAR(area_mm2(across), 1200 * 850 - kPi * 6400, 30) << all(across.warnings);
  const PatternFile apart = parse_svg_pattern(tunic(fold + circle(300), "panel"), "t");
  EXPECT_NEAR(area_mm2(apart), 1200 * 850 - 2 * kPi * 6400, 60) << all(apart.warnings);
  const PatternFile askew = parse_svg_pattern(tunic(fold + circle(70), "panel"), "t");
  EXPECT_NEAR(area_mm2(askew), 1200 * 850, 1e-3);
  EXPECT_TRUE(tells(askew.warnings, "\"neck hole\" is not cut: it crosses the fold"));
}

TEST(PatternAccount, SecondFoldIsUsedAtARightAngleAndToldOtherwise) {
  const auto folds = [](const std::string& second) {
    return "<path inkscape:label=\"fold\" d=\"M 50,60 V 300\"/><path inkscape:label=\"fold line\" "
           "d=\"" +
           second + "\"/>";
  };
  // At the lower edge; on the first one again; at the other side; beside all edges.
  const PatternFile four = parse_svg_pattern(tunic(folds("M 100,900 H 500"), "panel"), "t");
  EXPECT_NEAR(area_mm2(four), 4 * 600 * 850, 1);
  const PatternFile again = parse_svg_pattern(tunic(folds("M 50,500 V 800"), "panel"), "t");
  EXPECT_NEAR(area_mm2(again), 2 * 600 * 850, 1);
  EXPECT_FALSE(tells(again.warnings, "fold")) << all(again.warnings);
  const PatternFile opposite = parse_svg_pattern(tunic(folds("M 650,500 V 800"), "panel"), "t");
  EXPECT_NEAR(area_mm2(opposite), 2 * 600 * 850, 1);
  EXPECT_TRUE(tells(opposite.warnings, "2 fold lines")) << all(opposite.warnings);
  const PatternFile one = parse_svg_pattern(
      tunic("<path inkscape:label=\"fold\" d=\"M 50,300 V 900 H 500\"/>", "panel"), "t");
  EXPECT_NEAR(area_mm2(one), 4 * 600 * 850, 1);
}

TEST(PatternAccount, TextOfAFoldWithoutALineIsTold) {
  const PatternFile svg =
      parse_svg_pattern(tunic("<text x=\"60\" y=\"400\">place on fold</text>", "panel"), "t");
  EXPECT_TRUE(tells(svg.warnings, "\"place on fold\"")) << all(svg.warnings);
  Design design{drawn_design(3).back()};
  design[0].count = "cut 1 on fold";
  for (const auto& [dialect, file] : read_all(design))
    EXPECT_TRUE(tells(file.warnings, "fold")) << dialect << "\n" << all(file.warnings);
}

TEST(PatternAccount, CountsThatAreNotPlainAreToldInTheWordsOfTheFile) {
  for (const std::string says : {"2,0", "4", "3", "2 pairs", "none at all", "0"}) {
    Design design = drawn_design(5);
    design.back().count = says;
    const PatternFile file = parse_dxf_pattern(as_dxf(design, 0), "d.dxf");
    const auto& lines = says == "0" ? file.unused : file.warnings;
    EXPECT_TRUE(tells(lines, says == "0" ? "quantity is 0" : '"' + says + '"')) << all(lines);
    const bool twice = says != "3" && says != "none at all" && says != "0";
    EXPECT_EQ(file.pattern.panels.size(), says == "0" ? 7u : twice ? 9u : 8u) << says;
  }
  const std::string svg =
      svg_page("",
               "<path inkscape:label=\"sleeve\" data-quantity=\"2\" d=\"M 0,0 H 300 V 500 z\"/>"
               "<path inkscape:label=\"cuff, cut 4\" d=\"M 400,0 H 700 V 100 z\"/>");
  const PatternFile file = parse_svg_pattern(svg, "p.svg");
  EXPECT_EQ(file.pattern.panels.size(), 4u);
  EXPECT_GE(file.pattern.find_panel("cuff_mirrored"), 0);
  EXPECT_TRUE(tells(file.warnings, "(\"cut 4\")")) << all(file.warnings);
}

TEST(PatternAccount, NamedOutlinesThatMissClosingAreClosedOrTold) {
  for (const double gap : {0.2, 1.0, 1.9, 2.5, 30.0}) {
    const std::string back = "<path inkscape:label=\"back\" d=\"M 700,50 H 900 V 400 H 700 V " +
                             std::to_string(50 + gap) + "\"/>";
    const PatternFile file = parse_svg_pattern(tunic(back), "t");
    EXPECT_EQ(file.pattern.panels.size(), gap < 2 ? 2u : 1u) << gap;
    EXPECT_TRUE(tells(file.warnings, "open line \"back\"")) << all(file.warnings);
  }
}

TEST(PatternAccount, NamesThatEndAsASizeOrACountAreToldAndStayReadable) {
  for (const char* name : {"Ärmel 2X", "Rücken 3X", "Vorderstück_12X", "Ärmel XXL"}) {
    const PatternFile file = parse_svg_pattern(tunic("", name), "t");
    EXPECT_EQ(tells(file.warnings, "may be a size or a count"), std::string(name) != "Ärmel XXL")
        << all(file.warnings);
    EXPECT_TRUE(tells(file.used, name)) << all(file.used);
  }
}

TEST(PatternAccount, WordsOfASheetLoseNoPiece) {
  const std::string rest = "\" d=\"M 700,50 H 900 V 400 H 700 z\"/>";
  for (const char* word : {"page", "frame", "title", "scale", "control", "logo"}) {
    for (const char* piece : {"front", "back", "sleeve"}) {
      const std::string name = std::string(piece) + " " + word + " 2";
      EXPECT_EQ(parse_svg_pattern(tunic("<path inkscape:label=\"" + name + rest), "t")
                    .pattern.panels.size(),
                2u)
          << name;
    }
    const PatternFile other =
        parse_svg_pattern(tunic("<path inkscape:label=\"big " + std::string(word) + rest), "t");
    EXPECT_EQ(other.pattern.panels.size(), 1u) << word;
    EXPECT_TRUE(tells(other.warnings, "\"big " + std::string(word))) << all(other.warnings);
  }
  for (const char* page : {"Page 1", "page-2", "Page"})
    EXPECT_EQ(parse_svg_pattern(tunic("<g inkscape:label=\"" + std::string(page) +
                                      "\"><path inkscape:label=\"A" + rest + "</g>"),
                                "t")
                  .pattern.panels.size(),
              2u)
        << page;
}

TEST(PatternAccount, RectangleNamedAfterAPieceIsNoFrame) {
  const std::string shapes =
      "<path d=\"M 750,100 H 800 V 200 H 750 z\"/><path d=\"M 820,100 H 850 V 200 H 820 z\"/>";
  for (const char* name : {"Vorderteil", "Umhang", "cloak", "back"})
    for (const bool of_group : {false, true}) {
      const std::string label = " inkscape:label=\"" + std::string(name) + "\"";
      const PatternFile file = parse_svg_pattern(
          tunic("<g" + (of_group ? label : "") + "><rect" + (of_group ? "" : label) +
                " x=\"700\" y=\"50\" width=\"200\" height=\"350\"/>" + shapes + "</g>"),
          "t");
      ASSERT_EQ(file.pattern.panels.size(), 2u) << name << all(file.warnings);
      EXPECT_NEAR(1e6 * pattern::cloth_area(file.pattern.panels[1]), 200 * 350, 1) << name;
    }
}

TEST(PatternAccount, ClassesAndLinesOfOtherLayersAreNamed) {
  std::string text = as_freesewing_svg(drawn_design(2));
  const std::string lining = "<path class=\"lining\" d=\"M 0,0 H 200 V 300 z\"/>\n";
  text.insert(text.find("<path class=\"fabric\""), lining);
  const PatternFile svg = parse_svg_pattern(text, "d.svg");
  EXPECT_TRUE(tells(svg.unused, "\"lining\"")) << all(svg.unused);
  // A closed line on the layer of internal lines is drawn, not cut.
  std::string dxf = as_dxf(drawn_design(2), 0);
  const std::string line =
      "0\nPOLYLINE\n8\n8\n66\n1\n70\n1\n0\nVERTEX\n8\n8\n10\n20\n20\n20\n0\nVERTEX\n8\n8\n10\n80\n2"
      "0\n"
      "20\n0\nVERTEX\n8\n8\n10\n80\n20\n90\n0\nSEQEND\n8\n8\n";
  dxf.insert(dxf.find("0\nENDBLK"), line);
  const PatternFile file = parse_dxf_pattern(dxf, "d.dxf");
  EXPECT_TRUE(tells(file.warnings, "layer 8")) << all(file.warnings);
}

}  // namespace
}  // namespace loosefit::io
