#include "loosefit/render/render_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/render/drape_painter.h"
#include "loosefit/render/mannequin.h"
#include "loosefit/render/scene.h"
#include "loosefit/render/screen.h"
#include "support/scratch_folder.h"
#include "support/tube_garment.h"

namespace loosefit::render {
namespace {

constexpr double kTube = 0.17;

class Pictures : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { screen_ = new Screen; }
  static void TearDownTestSuite() { delete screen_; }
  void SetUp() override {
    garment_ = testing::tube_garment(2 * kPi * kTube, 0.5, 120, 40);
    positions_ = testing::settled_drape(garment_, [](const Vec2& uv) {
                   const double a = uv.x() / kTube;
                   return Vec3(kTube * std::cos(a), kTube * std::sin(a), 0.9 + uv.y());
                 }).positions;
    // Left half 0 mm, right half 40 mm: a jump at x = 0.
    map_ = {{"distance_mm", "Body-garment distance", "mm", 0, 40, "distance"}, {}};
    for (const Vec3& p : positions_) map_.values.push_back(p.x() > 0 ? 40 : 0);
    options_.width = 300;
    options_.height = 320;
    options_.views = {View::front};
  }
  static std::string bytes(const std::filesystem::path& p) {
    std::ifstream f(p, std::ios::binary);
    return {std::istreambuf_iterator<char>(f), {}};
  }
  static Screen* screen_;
  body::Body body_ = testing::cylinder_body(0.15, 1.7, 64, 40);
  garment::Garment garment_;
  std::vector<Vec3> positions_;
  maps::PerformanceMap map_;
  PictureOptions options_;
  const support::ScratchFolder dir_;
};
Screen* Pictures::screen_ = nullptr;

TEST_F(Pictures, ShowALineWhereTheClothIsSeenAndHideItElsewhere) {
  LineMark line{"lead", {}};
  for (int i = 0; i <= 20; ++i) line.points.emplace_back(0, -kTube, 1.0 + 0.015 * i);
  const geometry::TriangleMesh nothing;
  DrapePainter painter(*screen_, {body_, garment_, positions_, nothing, {line}},
                       {.width = 300, .height = 320, .ambient_occlusion = false});
  const auto blue = [&](View view) {
    painter.look(camera(view));
    int count = 0;
    for (const Rgb& p : finished(painter.cloth()).pixels) count += p[2] > p[0] + 80;
    return count;
  };
  EXPECT_GT(blue(View::front), 150);  // some 0.3 m of it
  EXPECT_EQ(blue(View::back), 0);
}

TEST_F(Pictures, AreNamedByMapAndView) {
  options_.views = {View::front, View::back, View::left, View::right};
  maps::PerformanceMap hidden = map_;
  hidden.map = "hidden";
  hidden.pictured = false;
  double last = 0;
  const auto pictures = render_pictures(*screen_, dir_, body_, garment_, positions_, {map_, hidden},
                                        options_, [&](double share) { last = share; });
  ASSERT_EQ(pictures.size(), 8u);
  EXPECT_EQ(last, 1);
  for (const char* file : {"drape-front.png", "distance-left.png", "distance-right.png"})
    EXPECT_GT(std::filesystem::file_size(dir_ / file), 1000u) << file;
}

TEST_F(Pictures, EqualInputGivesEqualBytes) {
  render_pictures(*screen_, dir_, body_, garment_, positions_, {map_}, options_);
  const std::string first = bytes(dir_ / "distance-front.png");
  render_pictures(*screen_, dir_, body_, garment_, positions_, {map_}, options_);
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, bytes(dir_ / "distance-front.png"));
}

TEST_F(Pictures, ColoursAreThoseOfTheLegendAndSidesAreRight) {
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  Scene scene(*screen_, {form, positions_, garment_.triangles, {}, {}}, 300, 280, 1, false);
  const auto near = [](const Rgb& seen, const Rgb& wanted) {
    int worst = 0;
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(int{seen[k]} - int{wanted[k]}));
    return worst <= 2;
  };
  scene.look(View::front);  // the wearer's left, +x, is on the right of the picture
  Image image = scene.colours(&map_);
  EXPECT_TRUE(near(image.at(100, 140), sequential_colours()[0]));
  EXPECT_TRUE(near(image.at(200, 140), sequential_colours()[255]));
  scene.look(View::back);
  image = scene.colours(&map_);
  EXPECT_TRUE(near(image.at(100, 140), sequential_colours()[255]));
  scene.look(View::left);
  EXPECT_TRUE(near(scene.colours(&map_).at(150, 140), sequential_colours()[255]));
  map_.values.assign(map_.values.size(), std::nan(""));
  EXPECT_TRUE(near(scene.colours(&map_).at(150, 140), kUndefinedColour));
}

TEST_F(Pictures, AreSeenFromAnyDirection) {
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  const SceneContent content{form, positions_, garment_.triangles, {}, {}};
  Scene scene(*screen_, content, 300, 280, 1, false);
  // Where the jump of the map lies in the middle row, as a share of the cloth's width: it turns
  // from the middle to the rim as the sine of the azimuth does.
  const auto share_of_right_half = [&](double azimuth) {
    scene.look({azimuth, 0});
    const Image image = scene.colours(&map_);
    int low = 0, high = 0;
    for (int x = 0; x < image.width; ++x) {
      low += image.at(x, 140) == sequential_colours()[0];
      high += image.at(x, 140) == sequential_colours()[255];
    }
    return static_cast<double>(high) / (low + high);
  };
  for (double azimuth : {0.0, 30.0, -30.0, 360.0, 390.0})
    EXPECT_NEAR(share_of_right_half(azimuth), 0.5 + 0.5 * std::sin(radians(azimuth)), 0.03)
        << azimuth;
}

TEST_F(Pictures, FromAboveNeedRoomForTheDepthAndShowItAll) {
  const geometry::TriangleMesh form = mannequin(body_, garment_, positions_);
  const SceneContent content{form, positions_, garment_.triangles, {}, {}};
  for (const Camera& from : {Camera{0, 0}, Camera{70, 40}, Camera{200, -40}}) {
    Scene scene(*screen_, content, 300, 280, 1, false);
    scene.look(from);
    const Image image = scene.colours(nullptr);
    int rim = 0, inside = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const bool drawn = image.at(x, y) != Rgb{255, 255, 255};
        inside += drawn;
        rim += drawn && (x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1);
      }
    EXPECT_EQ(rim, 0) << str(from);
    EXPECT_GT(inside, 8000) << str(from);
  }
  EXPECT_GT(frame_height(content, 1, {0, 40}), frame_height(content, 1, {0, 0}));
  // Twice the frame, half the picture.
  SceneContent wide = content;
  wide.frame_height = 2 * frame_height(content, 300.0 / 280, {});
  const auto width_of = [](Scene& scene) {
    scene.look(View::front);
    const Image image = scene.colours(nullptr, {9, 9, 9});
    int width = 0;
    for (int x = 0; x < image.width; ++x) width += image.at(x, 140) == Rgb{9, 9, 9};
    return width;
  };
  int whole = 0, half = 0;
  {
    Scene scene(*screen_, content, 300, 280, 1, false);
    whole = width_of(scene);
  }
  {
    Scene scene(*screen_, wide, 300, 280, 1, false);
    half = width_of(scene);
  }
  EXPECT_NEAR(half, whole / 2.0, 2);
}

TEST_F(Pictures, ClothThatFacesTheLightIsBrightAndClothThatTurnsAwayIsShaded) {
  Scene scene(*screen_, {body_.surface, positions_, garment_.triangles, {}, {}}, 300, 280, 1, true);
  scene.look(View::front);
  const Image cloth = scene.colours(&map_), light = scene.light();
  const int row = 140;
  int left = 0;
  while (cloth.at(left, row) == Rgb{255, 255, 255}) ++left;
  ASSERT_LT(left, 140);
  EXPECT_GT(light.at(150, row)[1], 200);
  EXPECT_LT(light.at(left + 2, row)[1], 0.8 * light.at(150, row)[1]);
}

TEST_F(Pictures, WrongSizesAndPlacesAreErrors) {
  map_.values.pop_back();
  EXPECT_THROW(render_pictures(*screen_, dir_, body_, garment_, positions_, {map_}, options_),
               InvalidInput);
  EXPECT_THROW(render_pictures(*screen_, dir_ / "none", body_, garment_, positions_, {}, options_),
               IoError);
  EXPECT_THROW(view_from_name("top"), InvalidInput);
}

}  // namespace
}  // namespace loosefit::render
