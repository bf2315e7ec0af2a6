#include "loosefit/io/pattern_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

#include "loosefit/io/garmentcode_read.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

/// End points of the path segments in the file [mm], per outline.
std::vector<std::vector<Vec2>> outline_points(const std::string& svg) {
  std::vector<std::vector<Vec2>> outlines;
  const std::regex path("class=\"outline\" d=\"([^\"]*)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
    std::vector<Vec2> points;
    const std::string d = (*it)[1];
    const std::regex step("([MLCQA])([^MLCQAZ]*)");
    for (std::sregex_iterator s(d.begin(), d.end(), step); s != end; ++s) {
      std::istringstream in((*s)[2]);
      std::vector<double> numbers;
      for (double x; in >> x;) numbers.push_back(x);
      points.push_back({numbers[numbers.size() - 2], numbers.back()});
    }
    outlines.push_back(points);
  }
  return outlines;
}

TEST(PatternSvg, PiecesAreTrueToScaleAndApart) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const std::string svg = pattern_svg(shirt);
  const auto outlines = outline_points(svg);
  ASSERT_EQ(outlines.size(), 6u);
  std::vector<std::pair<Vec2, Vec2>> boxes;
  for (std::size_t p = 0; p < outlines.size(); ++p) {
    const pattern::Panel& panel = shirt.panels[p];
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const Vec2& q : outlines[p]) low = low.cwiseMin(q), high = high.cwiseMax(q);
    boxes.push_back({low, high});
    // Corner to corner distances of the panel come back in millimetres.
    std::size_t point = 0;
    for (const pattern::PanelEdge& edge : panel.edges) {
      const Vec2 from = outlines[p][point];
      point += edge.curves.size();
      EXPECT_NEAR((outlines[p][point] - from).norm(),
                  1000 * (panel.vertices[edge.end] - panel.vertices[edge.start]).norm(), .01);
    }
    EXPECT_NE(svg.find("id=\"panel-" + panel.name + "\""), std::string::npos);
  }
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(
          boxes[a].first.x() > boxes[b].second.x() || boxes[b].first.x() > boxes[a].second.x() ||
          boxes[a].first.y() > boxes[b].second.y() || boxes[b].first.y() > boxes[a].second.y())
          << a << " and " << b << " overlap";
  std::smatch head;
  ASSERT_TRUE(std::regex_search(
      svg, head,
      std::regex(
          "width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\" viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"")));
  EXPECT_EQ(head[1], head[3]);
  EXPECT_EQ(head[2], head[4]);
}

TEST(PatternSvg, EverySeamNumberStandsOnBothSides) {
  const std::string svg = pattern_svg(kinds::draft_shirt({}));
  for (int seam = 1; seam <= 12; ++seam) {
    const std::string word = ">" + std::to_string(seam) + "</text>";
    int count = 0;
    for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, at + 1))
      ++count;
    EXPECT_EQ(count, 2) << seam;
  }
  EXPECT_NE(svg.find("armhole_L  "), std::string::npos);
  EXPECT_EQ(std::count(svg.begin(), svg.end(), '\0'), 0);
}

TEST(PatternSvg, AnElasticSaysHowLongItIsCut) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  EXPECT_EQ(pattern_svg(shirt).find("elastic"), std::string::npos);
  pattern::Panel& front = shirt.panels[shirt.find_panel("front")];
  const int hem = pattern::find_edge(front, "hem");
  front.edges[hem].elastic = {0.75, 20, 0.03};
  const double length = 750 * pattern::EdgePath(front, hem).length();
  const std::string svg = pattern_svg(shirt), mark = "elastic ";
  const std::size_t at = svg.find(mark);
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(svg.substr(at + mark.size())), length, 0.06);
}

TEST(PatternSvg, NamesAreEscapedAndArcsTurnedOver) {
  pattern::Pattern p =
      read_garmentcode(std::string(LOOSEFIT_SOURCE_DIR) + "/tests/data/patterns/curves.json")
          .pattern;
  p.panels[0].name = "a<b>&\"c\"";
  const std::string svg = pattern_svg(p);
  EXPECT_NE(svg.find("panel-a&lt;b&gt;&amp;&quot;c&quot;"), std::string::npos);
  EXPECT_NE(svg.find(" A 100.000 100.000 0 0 0 "), std::string::npos) << "sweep 1 in y-up axes";
}

}  // namespace
}  // namespace loosefit::io
