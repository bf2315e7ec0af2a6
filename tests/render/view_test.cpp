#include "loosefit/render/view.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"

namespace loosefit::render {
namespace {

TEST(Camera, IsNamedOrGivenInDegrees) {
  EXPECT_EQ(camera_from_text("back").azimuth, 180);
  EXPECT_EQ(camera_from_text("-30").azimuth, -30);
  EXPECT_EQ(camera_from_text("30,-15").elevation, -15);
  for (const char* bad : {"", "top", "30,", ",15", "30,15,2", "30 15", "nan", "30,81", "361", "3x"})
    EXPECT_THROW(camera_from_text(bad), InvalidInput) << bad;
}

TEST(Camera, SaysWhereItStands) {
  EXPECT_EQ(str(camera(View::left)), "left");
  EXPECT_EQ(str({30, 0}), "30°");
  EXPECT_EQ(str({30, 15}), "30°, 15° up");
  EXPECT_EQ(str({180, -5}), "180°, 5° down");
}

}  // namespace
}  // namespace loosefit::render
