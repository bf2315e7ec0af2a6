#include "loosefit/report/plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/report/residual_chart.h"

namespace loosefit::report {
namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(SvgPlot, DrawsReferenceAsLineAndPointsAsMarks) {
  Plot plot{"t", "x", "y", true, false, {}};
  plot.series = {{"exact", {1, 10, 100}, {0, 1, 2}, true},
                 {"found", {1, 10, -5, 100}, {0, 1, 1, std::nan("")}, false}};
  const std::string svg = svg_plot(plot);
  EXPECT_EQ(count(svg, "<polyline"), 1);
  // Two points can be drawn; the third mark is in the legend.
  EXPECT_EQ(count(svg, "<circle"), 3);
  EXPECT_NE(svg.find(">exact<"), std::string::npos);
  EXPECT_NE(svg.find(">found<"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(SvgPlot, IsEmptyWithoutPoints) {
  Plot plot{"t", "x", "y", true, false, {}};
  EXPECT_TRUE(svg_plot(plot).empty());
  plot.series = {{"s", {-1}, {1}, false}};
  EXPECT_TRUE(svg_plot(plot).empty()) << "nothing is positive on a logarithmic axis";
}

TEST(AxisTicks, AreRoundAndSpanTheValues) {
  const AxisTicks linear = axis_ticks({0.13, 1.9}, false);
  EXPECT_LE(linear.low, 0.13);
  EXPECT_GE(linear.high, 1.9);
  ASSERT_GE(linear.at.size(), 4u);
  EXPECT_NEAR(linear.at[1] - linear.at[0], 0.2, 1e-12);
  const AxisTicks decades = axis_ticks({0.01, 1e4}, true);
  EXPECT_EQ(decades.at.size(), 7u);
  EXPECT_DOUBLE_EQ(decades.low, -2);
  EXPECT_DOUBLE_EQ(decades.high, 4);
  const AxisTicks single = axis_ticks({5}, false);
  EXPECT_LT(single.low, 5);
  EXPECT_GT(single.high, 5);
}

TEST(SvgPlot, IsAsHighAsAskedForWithItsLegend) {
  Plot plot{"t", "x", "y", false, false, {{"s", {1, 2}, {3, 4}, false}}};
  plot.height = 200;
  EXPECT_NE(svg_plot(plot).find("viewBox=\"0 0 560 222\""), std::string::npos);
}

TEST(ResidualChart, HasALineForTheResidualAndOneForTheTolerance) {
  EXPECT_TRUE(residual_chart({}, 1e-3).empty());
  EXPECT_TRUE(residual_chart({{0, 0, 0, 1.0}}, 1e-3).empty());
  const std::string svg = residual_chart({{0, 0, 0, 1.0}, {1, 0, 1, 1e-5}}, 1e-3);
  EXPECT_EQ(count(svg, "<polyline"), 2);
  EXPECT_NE(svg.find(">tolerance<"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::report
