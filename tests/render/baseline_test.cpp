#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "loosefit/render/drape_painter.h"
#include "loosefit/render/legend.h"
#include "support/png_pixels.h"
#include "support/tube_garment.h"

// Whole pictures against stored ones. With LOOSEFIT_STORE_PICTURES set the stored ones are written
// anew: look at them before they are committed.
namespace loosefit::render {
namespace {

namespace fs = std::filesystem;

const fs::path kStored = fs::path(LOOSEFIT_SOURCE_DIR) / "tests/data/pictures";

/// Nearly the same: drivers round differently, and lie half a pixel apart at silhouettes.
void expect_like_stored(const Image& image, const std::string& name) {
  const fs::path stored = kStored / (name + ".png");
  if (std::getenv("LOOSEFIT_STORE_PICTURES")) write_png(stored, image);
  const fs::path seen =  // left for a look where they differ
      fs::path(::testing::TempDir()) / ("seen-" + name + "-" + std::to_string(getpid()) + ".png");
  write_png(seen, image);
  const Image wanted = testing::png_pixels(stored);
  ASSERT_EQ(image.width, wanted.width) << seen;
  ASSERT_EQ(image.height, wanted.height) << seen;
  double sum = 0;
  int far = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    int worst = 0;
    for (int k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs(int{image.pixels[i][k]} - int{wanted.pixels[i][k]}));
    sum += worst;
    far += worst > 32;
  }
  const auto count = static_cast<double>(image.pixels.size());
  EXPECT_LT(sum / count, 2) << "mean difference of 255; compare " << seen << " with " << stored;
  EXPECT_LT(far / count, 0.01) << "share of pixels; compare " << seen << " with " << stored;
  if (!::testing::Test::HasFailure()) fs::remove(seen);
}

class StoredPictures : public ::testing::Test {
 protected:
  /// A tube with six folds round a cylinder, wider towards its hem.
  static std::vector<Vec3> folded(const garment::Garment& garment) {
    return testing::settled_drape(garment,
                                  [](const Vec2& uv) {
                                    const double a = uv.x() / 0.17, down = 0.5 - uv.y();
                                    const double r = 0.17 + 0.08 * down * std::cos(6 * a);
                                    return Vec3(r * std::cos(a), r * std::sin(a), 0.9 + uv.y());
                                  })
        .positions;
  }
  void SetUp() override {
    garment_ = testing::tube_garment(2 * kPi * 0.17, 0.5, 120, 40);
    positions_ = folded(garment_);
    map_ = {{"distance_mm", "Body-garment distance", "mm", 0, 40, "distance"}, {}};
    for (const Vec3& p : positions_) map_.values.push_back(1e3 * (p.head<2>().norm() - 0.15));
    map_.values[700] = std::nan("");
  }
  body::Body body_ = testing::cylinder_body(0.15, 1.7, 64, 40);
  garment::Garment garment_;
  std::vector<Vec3> positions_;
  geometry::TriangleMesh nothing_;
  maps::PerformanceMap map_;
};

TEST_F(StoredPictures, OfClothAndMapsLookAsTheyDid) {
  const Screen screen;
  DrapePainter painter(screen, {body_, garment_, positions_, nothing_},
                       {.width = 220, .height = 240});
  painter.look(camera(View::front));
  expect_like_stored(finished(painter.cloth()), "folded-tube-cloth-front");
  expect_like_stored(finished(painter.map(map_)), "folded-tube-distance-front");
  painter.look({40, 25});
  expect_like_stored(finished(painter.map(map_)), "folded-tube-distance-turned");
}

TEST_F(StoredPictures, OfLegendsLookAsTheyDid) {
  Image image(300, 60);
  draw_legend(image, map_, 60);
  expect_like_stored(image, "legend");
}

TEST_F(StoredPictures, WouldNoticeAnotherRangeOrSide) {
  const Screen screen;
  DrapePainter painter(screen, {body_, garment_, positions_, nothing_},
                       {.width = 220, .height = 240});
  painter.look(camera(View::front));
  const Image right = finished(painter.map(map_));
  map_.range_high = 30;
  const Image other_range = finished(painter.map(map_));
  map_.range_high = 40;
  painter.look({15, 0});
  const Image other_side = finished(painter.map(map_));
  const auto difference = [&](const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      for (int k = 0; k < 3; ++k)
        sum += std::abs(int{image.pixels[i][k]} - int{right.pixels[i][k]}) / 3.0;
    return sum / static_cast<double>(image.pixels.size());
  };
  EXPECT_GT(difference(other_range), 2);
  EXPECT_GT(difference(other_side), 2);
}

}  // namespace
}  // namespace loosefit::render
