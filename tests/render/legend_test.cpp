#include "loosefit/render/legend.h"

#include <gtest/gtest.h>

#include "loosefit/render/garment_lines.h"
#include "support/tube_garment.h"

namespace loosefit::render {
namespace {

TEST(Legend, BarRunsThroughAllColoursInOrder) {
  maps::PerformanceMap map{{"distance_mm", "Distance", "mm", 0, 40, "distance"}, {1, 2}};
  Image image(900, 300);
  draw_legend(image, map, 120);
  const int row = 180 + 120 / 2;
  EXPECT_EQ(image.at(112, row), sequential_colours()[0]);
  EXPECT_EQ(image.at(787, row), sequential_colours()[255]);
  EXPECT_EQ(image.at(450, row), sequential_colours()[128]);
  // Something is written above and below the bar, nothing above the legend.
  const auto inked = [&](int y0, int y1) {
    int count = 0;
    for (int y = y0; y < y1; ++y)
      for (int x = 0; x < image.width; ++x) count += image.at(x, y)[1] < 128;
    return count;
  };
  EXPECT_GT(inked(185, 220), 200);
  EXPECT_GT(inked(262, 300), 60);
  EXPECT_EQ(inked(0, 180), 0);
}

TEST(Legend, TicksStandAtTheBreaksOfABrokenScale) {
  maps::PerformanceMap map{{"pressure_kPa", "Pressure", "kPa", 0, 4, "pressure"}, {1, 5}};
  map.breaks = {0, 0.3, 0.7, 2.7, 4, 8};
  Image image(900, 300);
  draw_legend(image, map, 120);
  const int under = 180 + 120 * 10 / 16 + 3;  // in the tick marks below the bar
  for (int i = 0; i < 6; ++i) EXPECT_LT(image.at(112 + 675 * i / 5, under)[1], 128) << i;
}

TEST(Legend, TicksAreShort) {
  EXPECT_EQ(tick_text(20), "20");
  EXPECT_EQ(tick_text(0.025), "0.025");
  EXPECT_EQ(tick_text(-0.05), "\u22120.05");
  EXPECT_EQ(tick_text(1e-17), "0");
}

TEST(GarmentLines, TubeHasTwoRimsAndOneSeam) {
  const GarmentLines lines = garment_lines(testing::tube_garment(0.6, 0.4, 20, 10));
  EXPECT_EQ(lines.boundary.size(), 40u);
  EXPECT_EQ(lines.seams.size(), 10u);
}

}  // namespace
}  // namespace loosefit::render
