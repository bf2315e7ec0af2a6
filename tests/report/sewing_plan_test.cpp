#include "loosefit/report/sewing_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/report/sewing_labels.h"
#include "loosefit/report/sewing_marks.h"

namespace loosefit::report {
namespace {

/// One piece of 400 x 600 mm, origin in its lower left corner; the right side is sewn to the left.
pattern::Pattern rectangle() {
  pattern::Pattern pattern;
  pattern.name = "tube <&>";
  pattern::Panel panel;
  panel.name = "front";
  panel.vertices = {{0, 0}, {0.4, 0}, {0.4, 0.6}, {0, 0.6}};
  for (int i = 0; i < 4; ++i) {
    pattern::PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % 4;
    edge.name = std::vector<std::string>{"hem", "side_L", "neck", "side_R"}[i];
    panel.edges.push_back(edge);
  }
  pattern.panels = {panel};
  pattern::Stitch stitch;
  stitch.first = {0, 1};
  stitch.second = {0, 3};
  stitch.name = "side";
  pattern.stitches = {stitch};
  return pattern;
}

/// Scores 1, 0.3 and 0, at u = 100, 200, 300 mm.
placement::RankingTable table() {
  placement::RankingTable t;
  t.scorecard.name = "plain";
  t.scorecard.title = "Plain <sensor>";
  t.scorecard.criteria = {{"contact_ratio", {1, 0}, {}, "lifts off", "", "test"}};
  t.sites = {{"good", {{{"contact_ratio", 1.0}}}},
             {"poor", {{{"contact_ratio", 0.3}}}},
             {"none", {{{"contact_ratio", 0.0}}}}};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  t.places.resize(3);
  for (int i = 0; i < 3; ++i) {
    t.places[i].panel = "front";
    t.places[i].at = {0.1 * (i + 1), 0.2};
  }
  t.places[0].angle = kPi / 2;  // the axis points along -u
  t.places[0].tolerance = placement::Tolerance{Vec2(-1, 0), 0.020, 0.005, {}, {}};
  return t;
}

std::vector<std::smatch> found(const std::string& text, const std::string& pattern) {
  std::vector<std::smatch> all;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    all.push_back(*it);
  return all;
}

double number(const std::ssub_match& match) { return std::stod(match.str()); }

TEST(SewingPlan, SensorsLieAtTheirPlacesInMillimetres) {
  const std::string svg = sewing_plan_svg(table(), rectangle());
  const auto outline = found(svg, "class=\"outline\" d=\"M ([\\d.]+) ([\\d.]+)");
  const auto sensors = found(
      svg, "class=\"sensor\" cx=\"([\\d.]+)\" cy=\"([\\d.]+)\" r=\"([\\d.]+)\" fill=\"([^\"]*)\"");
  ASSERT_EQ(outline.size(), 1u);
  ASSERT_EQ(sensors.size(), 2u) << "the one that fails is only a cross";
  const double x0 = number(outline[0][1]), y0 = number(outline[0][2]);  // lower left corner
  EXPECT_NEAR(number(sensors[0][1]) - x0, 100, 0.02);
  EXPECT_NEAR(y0 - number(sensors[0][2]), 200, 0.02) << "y runs downwards on the sheet";
  EXPECT_NEAR(number(sensors[0][3]), 12, 0.01);
  EXPECT_NEAR(number(sensors[1][1]) - x0, 200, 0.02);
  EXPECT_NE(sensors[0][4], sensors[1][4]) << "who does not pass looks different";
  EXPECT_EQ(found(svg, "class=\"failing\"").size(), 1u);
}

TEST(SewingPlan, ArrowAndEllipseFollowAxisAndSegment) {
  const std::string svg = sewing_plan_svg(table(), rectangle());
  const auto axis = found(svg, "class=\"axis\" d=\"M ([\\d.]+) ([\\d.]+) L ([\\d.]+) ([\\d.]+)");
  ASSERT_EQ(axis.size(), 2u);
  EXPECT_NEAR(number(axis[0][3]) - number(axis[0][1]), -24, 0.02)
      << "radius and 12 mm, to the left";
  EXPECT_NEAR(number(axis[0][4]), number(axis[0][2]), 0.02);
  EXPECT_NEAR(number(axis[1][4]) - number(axis[1][2]), -24, 0.02) << "along the grain: upwards";
  const auto ellipse =
      found(svg, "rx=\"([\\d.]+)\" ry=\"([\\d.]+)\" transform=\"rotate\\((-?[\\d.]+)");
  ASSERT_EQ(ellipse.size(), 1u);
  EXPECT_NEAR(number(ellipse[0][1]), 20, 0.01) << "along";
  EXPECT_NEAR(number(ellipse[0][2]), 5, 0.01) << "around";
  EXPECT_NEAR(std::abs(std::remainder(number(ellipse[0][3]), 180)), 0, 0.01);
}

TEST(SewingPlan, TellsScaleSignsSitesAndEscapesNames) {
  const std::string svg = sewing_plan_svg(table(), rectangle());
  EXPECT_NE(svg.find("Where to sew: Plain &lt;sensor&gt;"), std::string::npos);
  EXPECT_NE(svg.find("the control square must measure 100 mm"), std::string::npos);
  EXPECT_NE(svg.find("1 good: front at u 100.0, v 200.0 mm, axis 90° from the grain"),
            std::string::npos);
  EXPECT_NE(svg.find("±20 mm along, ±5 mm around"), std::string::npos);
  EXPECT_NE(svg.find("score 0.30, does not pass: lifts off"), std::string::npos);
  EXPECT_NE(svg.find(">100 mm to side_R<"), std::string::npos);
  EXPECT_NE(svg.find(">200 mm to hem<"), std::string::npos);
  EXPECT_EQ(svg.find("no place is recommended"), std::string::npos);
  placement::RankingTable none = table();
  none.sites = {none.sites[2]};
  none.places = {none.places[2]};
  none.ranking = placement::rank_sites(none.sites, none.scorecard);
  none.scorecard.left_out = {"slip_mm"};
  const std::string empty = sewing_plan_svg(none, rectangle());
  EXPECT_NE(empty.find("no place is recommended"), std::string::npos);
  EXPECT_NE(empty.find("upper bounds, not looked at: slip_mm"), std::string::npos);
}

TEST(SewingPlan, ShadesSeamsHemsAndZones) {
  placement::RankingTable t = table();
  t.constraints.seam_clearance = 0.015;
  t.constraints.edge_clearance = 0.004;
  placement::KeepOutZone zone;
  zone.panel = "front";
  zone.lower = {0.1, 0.4};
  zone.upper = {0.2, 0.5};
  t.constraints.keep_out.zones = {zone};
  zone.panel = "back";
  t.constraints.keep_out.zones.push_back(zone);
  const std::string svg = sewing_plan_svg(t, rectangle());
  const auto borders = found(svg, "class=\"border\"[^/]*stroke-width=\"([\\d.]+)\"");
  ASSERT_EQ(borders.size(), 4u);
  // Strokes are centred on the edge, and the outer half is cut off.
  for (int edge = 0; edge < 4; ++edge)
    EXPECT_NEAR(number(borders[edge][1]), edge % 2 ? 30 : 8, 0.01);
  const auto zones = found(svg, "class=\"zone\"[^/]*width=\"([\\d.]+)\" height=\"([\\d.]+)\"");
  ASSERT_EQ(zones.size(), 1u) << "that of another piece is not drawn here";
  EXPECT_NEAR(number(zones[0][1]), 100, 0.01);
}

TEST(SewingPlan, LinesRoundTheBodyAreDottedOnEveryPieceTheyCross) {
  placement::RankingTable t = table();
  t.places[0].shape.kind = placement::FootprintShape::Kind::girth;
  t.places[0].line = {{"front", {0.1, 0.1}}, {"front", {0.2, 0.1}}, {"back", {0, 0}}};
  EXPECT_EQ(found(sewing_plan_svg(t, rectangle()), "class=\"line\"").size(), 2u);
}

TEST(SewingPlan, DistancesGoToTwoEdgesThatDoNotRunAlike) {
  const pattern::Panel panel = rectangle().panels[0];
  const auto two = pipeline::edge_distances(panel, {0.05, 0.3});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(panel.edges[two[0].edge].name, "side_R");
  EXPECT_NEAR(two[0].length, 0.05, 1e-12);
  // side_L is 350 mm away and lies opposite; hem and neck are 300 mm away, the first counts.
  EXPECT_EQ(panel.edges[two[1].edge].name, "hem");
  EXPECT_NEAR(two[1].length, 0.30, 1e-12);
  EXPECT_NEAR((two[1].foot - Vec2(0.05, 0)).norm(), 0, 1e-12);
}

TEST(SewingPlan, WordsKeepOffWordsAndLines) {
  SewingLabels labels({});
  std::vector<Vec2> line;
  for (int i = 0; i < 100; ++i) line.push_back({100 + i, 100});
  labels.keep_off(line);
  std::vector<Vec2> corners;
  for (int i = 0; i < 3; ++i) {
    const std::string svg = labels.place({100, 100}, 5, {"1 name", "", "words"});
    const auto texts = found(svg, "<text x=\"([\\d.]+)\" y=\"([\\d.]+)\"");
    ASSERT_EQ(texts.size(), 2u) << "empty lines are passed over";
    corners.push_back({number(texts[0][1]), number(texts[0][2])});
    for (const Vec2& other : line)
      EXPECT_FALSE(other.x() > corners[i].x() && other.x() < corners[i].x() + 15 &&
                   other.y() > corners[i].y() - 3 && other.y() < corners[i].y() + 5);
    for (int j = 0; j < i; ++j)
      EXPECT_TRUE(std::abs(corners[i].x() - corners[j].x()) >= 15 ||
                  std::abs(corners[i].y() - corners[j].y()) >= 10);
  }
}

}  // namespace
}  // namespace loosefit::report
