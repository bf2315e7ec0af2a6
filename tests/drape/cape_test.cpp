#include <gtest/gtest.h>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/pattern/place_pieces.h"
#include "support/shirt_on_body.h"
#include "support/simple_patterns.h"
#include "support/worn_and_settled.h"

namespace loosefit::drape {
namespace {

using testing_support::polygon_panel;
using testing_support::stitch;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

/// Two rectangles sewn along the shoulders, the sides open; the neck is cut out of their tops,
/// which stand at `top`.
pattern::Pattern poncho(double top, double width, double length, double neck) {
  pattern::Pattern pattern;
  pattern.name = "poncho";
  const double w = width / 2, n = neck / 2;
  for (const double deep : {0.08, 0.03}) {
    const bool front = deep > 0.05;
    pattern::Panel panel =
        polygon_panel(front ? "front" : "back",
                      {{-w, -length}, {w, -length}, {w, 0}, {n, 0}, {0, -deep}, {-n, 0}, {-w, 0}});
    const double side = front ? 1 : -1;
    panel.rotation.col(0) = side * Vec3::UnitX();
    panel.rotation.col(1) = Vec3::UnitZ();
    panel.rotation.col(2) = -side * Vec3::UnitY();
    panel.translation = Vec3(0, -0.22 * side, top);
    pattern.panels.push_back(panel);
  }
  pattern.stitches = {stitch(0, 2, 1, 5), stitch(0, 5, 1, 2)};
  return pattern;
}

std::vector<Vec3> arranged(const pattern::Pattern& pattern) {
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  return arrange_panels(sewn, garment::open_seams(sewn), pattern, woman()).x;
}

double highest(const std::vector<Vec3>& x) {
  double top = 0;
  for (const Vec3& p : x) top = std::max(top, p.z());
  return top;
}

TEST(Cape, ItsNeckComesToTheNeckOfWhoeverWearsIt) {
  const double hps = woman()->landmarks.at("hps_L").z();
  for (const double off : {-0.09, 0.0, 0.08, 0.30})
    EXPECT_NEAR(highest(arranged(poncho(hps + off, 1.3, 0.65, 0.3))), hps, 0.03) << off;
}

TEST(Cape, ItIsLaidOverTheArmsAndNotBetweenThem) {
  const auto x = arranged(poncho(woman()->landmarks.at("hps_L").z(), 1.3, 0.65, 0.3));
  double widest = 0;
  for (const Vec3& p : x) widest = std::max(widest, std::abs(p.x()));
  EXPECT_NEAR(widest, 0.65, 1e-9);
}

TEST(Cape, ATubeOfThatGirthAtTheWaistIsStillASkirt) {
  const double waist = woman()->measured.at("waist_level");
  const auto x = arranged(poncho(waist, 1.3, 0.65, 0.36));
  EXPECT_LT(highest(x), waist + 0.04);
}

// A drawing places nothing; what is sewn on the shoulders alone hangs there, and not at the waist.
TEST(Cape, ATabardOfADrawingComesToTheNeck) {
  const double hps = woman()->landmarks.at("hps_L").z();
  for (const double width : {0.45, 0.9, 1.2})
    for (const double length : {0.5, 0.7, 1.1}) {
      pattern::Pattern drawn = poncho(0, width, length, 0.22);
      for (pattern::Panel& panel : drawn.panels) panel.translation = Vec3::Zero();
      pattern::place_pieces(drawn);
      EXPECT_NEAR(highest(arranged(drawn)), hps, 0.03) << width << ' ' << length;
      // Sewn at its sides it is a skirt or a dress, by its names.
      drawn.stitches = {stitch(0, 1, 1, 6), stitch(0, 6, 1, 1)};
      pattern::place_pieces(drawn);
      EXPECT_LT(highest(arranged(drawn)), hps - 0.1) << width << ' ' << length;
    }
}

TEST(Cape, APonchoHangsOnTheShoulders) {
  testing_support::expect_worn_and_settled(
      poncho(woman()->landmarks.at("hps_L").z() + 0.05, 0.9, 0.45, 0.32), 0.05, woman());
}

}  // namespace
}  // namespace loosefit::drape
