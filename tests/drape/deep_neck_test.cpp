#include <gtest/gtest.h>

#include <map>

#include "loosefit/drape/openings.h"
#include "loosefit/garment/assemble.h"
#include "support/shirt_on_body.h"
#include "support/simple_patterns.h"
#include "support/worn_and_settled.h"

// A neck that comes down nearly to the hem, as that of a bra or a camisole with straps, is no open
// front.
namespace loosefit::drape {
namespace {

using namespace testing_support;
using kinds::OpeningUse;

/// Sizes of a top that hangs on two straps [m].
struct Straps {
  double width, band, strap, notch, at = 0.11;

  /// Front with a notch, back straight; each strap is one piece, sewn to both. `bottom`: height of
  /// the hem.
  pattern::Pattern pattern(double bottom) const {
    const double w = width / 2, high = band + 0.06, in = at - 0.015, out = at + 0.015;
    pattern::Pattern p;
    const auto add = [&](const char* name, const std::vector<Vec2>& outline, bool back) {
      pattern::Panel panel = polygon_panel(name, outline);
      panel.rotation.col(0) = (back ? -1 : 1) * Vec3::UnitX();
      panel.rotation.col(1) = Vec3::UnitZ();
      panel.rotation.col(2) = (back ? 1 : -1) * Vec3::UnitY();
      panel.translation = Vec3(0, back ? 0.2 : -0.2, bottom);
      p.panels.push_back(panel);
    };
    // Edges: 0 hem, 1 side, 2 armhole, 3 strap, 4 and 5 neck, 6 strap, 7 armhole, 8 side.
    const auto outline = [&](double middle) {
      return std::vector<Vec2>{{-w, 0},     {w, 0},      {w, band},    {out, high}, {in, high},
                               {0, middle}, {-in, high}, {-out, high}, {-w, band}};
    };
    add("bra_front", outline(high - notch), false);
    add("bra_back", outline(high - 0.02), true);
    for (const int side : {1, -1}) {
      pattern::Panel panel = rectangle_panel(side > 0 ? "strap_L" : "strap_R", 0.03, strap);
      panel.rotation.col(1) = Vec3::UnitY();
      panel.rotation.col(2) = Vec3::UnitZ();
      panel.rotation.col(0) = Vec3::UnitX();
      panel.translation = Vec3(side * at - 0.015, -0.2, bottom + high + 0.1);
      p.panels.push_back(panel);
    }
    p.stitches = {stitch(0, 1, 1, 8), stitch(0, 8, 1, 1), stitch(0, 3, 2, 0),
                  stitch(1, 6, 2, 2), stitch(0, 6, 3, 0), stitch(1, 3, 3, 2)};
    return p;
  }
};

TEST(DeepNeck, BetweenStrapsIsANeck) {
  const std::map<OpeningUse, int> expected{{OpeningUse::neck, 1},
                                           {OpeningUse::hem, 1},
                                           {OpeningUse::left_arm, 1},
                                           {OpeningUse::right_arm, 1}};
  for (const double band : {0.08, 0.14, 0.4})
    for (const double strap : {0.2, 0.4})
      for (const double left : {0.02, 0.5, 0.9}) {
        SCOPED_TRACE(::testing::Message() << band << ' ' << strap << ' ' << left);
        const Straps top{.width = 0.4,
                         .band = band,
                         .strap = strap,
                         .notch = band + 0.06 - std::max(0.03, left * band)};
        const pattern::Pattern pattern = top.pattern(1.1);
        std::map<OpeningUse, int> found;
        for (const Opening& o :
             garment_openings(garment::assemble(pattern, 0.02, fabric::Material{}), pattern))
          ++found[o.use];
        EXPECT_EQ(found, expected);
      }
}

TEST(DeepNeck, ABraHangsOnTheShoulders) {
  const body::PosedBody woman = support::standing(support::adult_parameters(), 40);
  const Straps bra{.width = 0.47, .band = 0.1, .strap = 0.36, .notch = 0.1};
  expect_worn_and_settled(bra.pattern(woman->measured.at("chest_level") - 0.07), 0.03, woman);
}

}  // namespace
}  // namespace loosefit::drape
