#include "loosefit/render/figure.h"

#include <gtest/gtest.h>

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/render/colour_table.h"
#include "support/png_pixels.h"
#include "support/scratch_folder.h"

namespace loosefit::render {
namespace {

class FigureOfPanels : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const Rgb& colour : colours_)
      figure_.panels.push_back({Image(220, 180, colour), "a caption"});
    figure_.columns = 2;
    figure_.legends.push_back(
        {{"distance_mm", "Body-garment distance", "mm", 0, 40, "distance"}, false, true});
  }
  Image drawn() const {
    const support::ScratchFolder scratch;
    const std::filesystem::path file = scratch / "figure.png";
    std::ofstream(file, std::ios::binary) << figure_file(figure_, FigureFormat::png);
    return testing::png_pixels(file);
  }
  static int worst(const Rgb& a, const Rgb& b) {
    int difference = 0;
    for (int k = 0; k < 3; ++k) difference = std::max(difference, std::abs(int{a[k]} - int{b[k]}));
    return difference;
  }
  /// Box of all pixels of nearly one colour: left, top, right, bottom; and their number.
  struct Found {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1, count = 0;
  };
  static Found find(const Image& image, const Rgb& colour, int tolerance = 0) {
    Found found;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (worst(image.at(x, y), colour) <= tolerance) {
          found.left = std::min(found.left, x);
          found.right = std::max(found.right, x);
          found.top = std::min(found.top, y);
          found.bottom = std::max(found.bottom, y);
          ++found.count;
        }
    return found;
  }
  const std::vector<Rgb> colours_ = {{250, 10, 20}, {20, 240, 30}, {40, 20, 230}};
  Figure figure_;
};

TEST_F(FigureOfPanels, PicturesStandInAGridPixelForPixel) {
  const Image image = drawn();
  EXPECT_EQ(image.width, size_of(figure_).width);
  EXPECT_EQ(image.height, size_of(figure_).height);
  std::vector<Found> found;
  for (const Rgb& colour : colours_) found.push_back(find(image, colour));
  for (const Found& panel : found) {
    EXPECT_EQ(panel.count, 220 * 180);
    EXPECT_EQ(panel.right - panel.left + 1, 220);
    EXPECT_EQ(panel.bottom - panel.top + 1, 180);
  }
  EXPECT_EQ(found[0].top, found[1].top);
  EXPECT_GT(found[1].left, found[0].right);
  EXPECT_EQ(found[2].left, found[0].left);
  EXPECT_GT(found[2].top, found[0].bottom);
}

TEST_F(FigureOfPanels, TheBarShowsTheColourTableFromLeftToRight) {
  const Image image = drawn();
  std::vector<double> at;  // the frame of the bar covers its ends
  for (int entry : {32, 96, 160, 224}) {
    const Found found = find(image, sequential_colours()[entry], 1);
    ASSERT_GT(found.count, 0) << entry;
    EXPECT_LE(found.right - found.left, 6) << entry;
    at.push_back(0.5 * (found.left + found.right));
  }
  for (int i = 1; i < 3; ++i) EXPECT_NEAR(at[i + 1] - at[i], at[1] - at[0], 3);
  EXPECT_GT(at[1] - at[0], 40);
}

TEST_F(FigureOfPanels, VectorsHaveTheSizeOfThePixelsAtTheirResolution) {
  const std::string svg = figure_file(figure_, FigureFormat::svg);
  const FigureSize size = size_of(figure_);
  const std::size_t at = svg.find("width=\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(svg.substr(at + 7)), size.width * 72 / kFigureResolution, 0.5);
  EXPECT_NE(svg.find("image/png;base64"), std::string::npos);
  EXPECT_EQ(figure_file(figure_, FigureFormat::pdf).substr(0, 5), "%PDF-");
}

TEST_F(FigureOfPanels, EqualFiguresGiveEqualBytes) {
  for (FigureFormat format : {FigureFormat::png, FigureFormat::pdf})
    EXPECT_TRUE(figure_file(figure_, format) == figure_file(figure_, format));
}

TEST_F(FigureOfPanels, CaptionsAndTitleTakeRoomOnlyWhenTheyAreThere) {
  Figure bare{
      .panels = {{Image(220, 180, colours_[0]), ""}}, .legends = {}, .columns = 3, .title = ""};
  const FigureSize alone = size_of(bare);
  bare.title = "Title";
  EXPECT_GT(size_of(bare).height, alone.height);
  bare.title = "";
  bare.panels[0].caption = "front";
  EXPECT_GT(size_of(bare).height, alone.height);
  EXPECT_EQ(size_of(bare).width, alone.width);
}

TEST(FigureFormats, AreToldByTheEndingOfTheName) {
  EXPECT_EQ(figure_format("a/b.png"), FigureFormat::png);
  EXPECT_EQ(figure_format("b.svg"), FigureFormat::svg);
  EXPECT_EQ(figure_format("b.pdf"), FigureFormat::pdf);
  EXPECT_THROW(figure_format("b.eps"), InvalidInput);
  EXPECT_THROW(figure_format("png"), InvalidInput);
}

}  // namespace
}  // namespace loosefit::render
