#include "loosefit/drape/limb_pieces.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/phases/sew_on.h"
#include "loosefit/drape/worn.h"
#include "loosefit/drape/worn_way.h"
#include "loosefit/garment/assemble.h"
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

/// Stands beside the middle plane; `outwards`: the sign of x of its outside.
void stand_beside(pattern::Panel& panel, double outwards, const Vec3& at) {
  panel.rotation.col(2) = outwards * Vec3::UnitX();
  panel.rotation.col(1) = Vec3::UnitZ();
  panel.rotation.col(0) = panel.rotation.col(1).cross(panel.rotation.col(2));
  panel.translation = at;
}

/// Two sides of a foot, sewn all round but for the top, on the left (1) or right (−1) of the
/// wearer, `apart` from the middle of the foot at x = side · `beside`.
pattern::Pattern sock(int side, double beside, double apart, double height, double length) {
  const double back = 0.065, front = length - back, wide = 0.15, toe = 0.06;
  const double instep = std::min(0.12, 0.9 * height);
  const std::vector<Vec2> outer = {
      {0.03 - front, 0},     {back, 0},           {back, height},     {back - wide, height},
      {back - wide, instep}, {0.02 - front, toe}, {-front, 0.5 * toe}};
  std::vector<Vec2> inner;
  for (int i : {1, 0, 6, 5, 4, 3, 2}) inner.emplace_back(-outer[i].x(), outer[i].y());
  pattern::Pattern pattern;
  pattern.name = "sock";
  pattern.panels = {polygon_panel("plus", outer), polygon_panel("minus", inner)};
  stand_beside(pattern.panels[0], 1, Vec3(side * beside + apart, 0, 0));
  stand_beside(pattern.panels[1], -1, Vec3(side * beside - apart, 0, 0));
  // All edges but those at the top, 2 and 5.
  for (const auto& [a, b] : {std::pair(0, 0), {1, 6}, {3, 4}, {4, 3}, {5, 2}, {6, 1}})
    pattern.stitches.push_back(stitch(0, a, 1, b));
  return pattern;
}

/// A strip round the limb at `middle`, in one piece, upright before it.
pattern::Pattern ring(const Vec3& middle, double girth, double height) {
  pattern::Pattern pattern;
  pattern.name = "ring";
  pattern.panels = {polygon_panel("strip", {{-girth / 2, -height / 2},
                                            {girth / 2, -height / 2},
                                            {girth / 2, height / 2},
                                            {-girth / 2, height / 2}})};
  pattern.panels[0].rotation.col(0) = Vec3::UnitX();
  pattern.panels[0].rotation.col(1) = Vec3::UnitZ();
  pattern.panels[0].rotation.col(2) = -Vec3::UnitY();
  pattern.panels[0].translation = middle - 0.1 * Vec3::UnitY();
  pattern.stitches = {stitch(0, 1, 0, 3)};
  return pattern;
}

std::vector<Opening> openings_of(const pattern::Pattern& pattern) {
  return garment_openings(garment::assemble(pattern, 0.03, fabric::Material{}), pattern, woman());
}

TEST(LimbPieces, APieceWithOneOpeningIsForTheLimbThatItGoesRound) {
  for (const int side : {1, -1})
    for (const double beside : {0.10, 0.15}) {
      const auto openings = openings_of(sock(side, beside, 0.1, 0.3, 0.25));
      ASSERT_EQ(openings.size(), 1u);
      EXPECT_EQ(openings[0].use, kinds::OpeningUse::limb);
      EXPECT_EQ(openings[0].round, round_limb(side > 0 ? kLeftLeg : kRightLeg));
    }
}

TEST(LimbPieces, OneThatLiesBesideTheLimbIsForTheNearerOneOfThatSide) {
  const auto openings = openings_of(sock(-1, 0.4, 0.05, 0.3, 0.25));
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_EQ(openings[0].round, round_limb(kRightLeg));
  EXPECT_FALSE(openings[0].placed_round);
  // A skirt whose file begins at x = 0 is none, however far it lies aside.
  const auto wide = openings_of(ring({0.8, 0, 1.0}, 1.2, 0.4));
  for (const Opening& o : wide) EXPECT_NE(o.use, kinds::OpeningUse::limb);
}

TEST(LimbPieces, ASockIsArrangedBesideItsFootWhereverTheFileHasIt) {
  for (const auto& [beside, y] : {std::pair(0.10, 0.0), {0.15, 0.05}, {0.35, -0.2}}) {
    pattern::Pattern pattern = sock(1, beside, 0.1, 0.3, 0.27);
    for (pattern::Panel& panel : pattern.panels) panel.translation.y() += y;
    const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
    const garment::OpenSeams open = garment::open_seams(sewn);
    const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
    geometry::Box3 cloth, foot;
    for (const Vec3& p : panels.x) cloth.extend(p);
    for (std::size_t i = 0; i < woman()->surface.vertices.size(); ++i)
      if (woman()->segment[i] == body::Segment::foot && woman()->side[i] > 0)
        foot.extend(woman()->surface.vertices[i]);
    EXPECT_LT(cloth.min().x(), foot.min().x()) << beside;
    EXPECT_GT(cloth.max().x(), foot.max().x()) << beside;
    EXPECT_NEAR(cloth.min().y(), foot.min().y(), 0.04) << beside;
    EXPECT_LT(std::abs(cloth.min().z()), 0.031);
  }
}

TEST(LimbPieces, AGloveWithFingersFindsNoPlaceAMittenDoes) {
  // On the right hand, as the wearer holds it.
  const Vec3 wrist = woman()->joints.at("wrist_R"), elbow = woman()->joints.at("elbow_R");
  const Vec3 down = (wrist - elbow).normalized(),
             back = (Vec3::UnitY() - down.y() * down).normalized();
  const auto hand = [&](bool fingers) {
    std::vector<Vec2> outer = {{0.06, 0}, {0.06, 0.20}};
    if (fingers)
      for (const double x : {0.035, 0.01, -0.015, -0.04})
        for (const auto& [dx, y] : {std::pair(0.006, 0.20), {0.0, 0.12}, {-0.006, 0.20}})
          outer.emplace_back(x + dx, y);
    outer.emplace_back(-0.06, 0.20), outer.emplace_back(-0.06, 0);
    std::vector<Vec2> inner;
    for (std::size_t i = outer.size(); i-- > 0;) inner.emplace_back(-outer[i].x(), outer[i].y());
    pattern::Pattern pattern;
    pattern.panels = {polygon_panel("outer", outer), polygon_panel("inner", inner)};
    for (int k : {0, 1}) {
      pattern::Panel& panel = pattern.panels[k];
      panel.rotation.col(2) = k == 0 ? back : Vec3(-back);
      panel.rotation.col(1) = down;
      panel.rotation.col(0) = panel.rotation.col(1).cross(panel.rotation.col(2));
      panel.translation = wrist + 0.07 * panel.rotation.col(2);
    }
    // All edges but the last one, at the wrist.
    const int n = static_cast<int>(outer.size());
    for (int e = 0; e + 1 < n; ++e) pattern.stitches.push_back(stitch(0, e, 1, n - 2 - e));
    return pattern;
  };
  const auto arranged = [&](const pattern::Pattern& pattern) {
    const garment::Garment sewn = garment::assemble(pattern, 0.02, fabric::Material{});
    return arrange_panels(sewn, garment::open_seams(sewn), pattern, woman());
  };
  EXPECT_THROW(arranged(hand(true)), GeometryError);
  const ArrangedPanels mitten = arranged(hand(false));
  EXPECT_TRUE(mitten.on_limbs);
  EXPECT_FALSE(mitten.under_soles);
  double farthest = 0, fingertips = 0;
  for (const Vec3& p : mitten.x) farthest = std::max(farthest, (p - wrist).dot(down));
  for (std::size_t i = 0; i < woman()->surface.vertices.size(); ++i)
    if (woman()->segment[i] == body::Segment::hand && woman()->side[i] < 0)
      fingertips = std::max(fingertips, (woman()->surface.vertices[i] - wrist).dot(down));
  EXPECT_NEAR(farthest, fingertips, 0.035);
}

pattern::PanelHole round_hole(const Vec2& centre, double radius) {
  pattern::PanelHole hole{"hole", {}};
  for (int i = 0; i < 36; ++i)
    hole.points.push_back(centre + radius * Vec2(std::cos(kPi * i / 18), std::sin(kPi * i / 18)));
  return hole;
}

// A hole of 12 cm is wider than what counts as for nothing.
TEST(LimbPieces, AHoleCutIntoOneChangesNothing) {
  for (const int side : {1, -1}) {
    pattern::Pattern holed = sock(side, 0.12, 0.1, 0.3, 0.25);
    holed.panels[0].holes = {round_hole({0, 0.2}, 0.02)};
    const auto openings = openings_of(holed);
    ASSERT_EQ(openings.size(), 2u);
    for (const Opening& o : openings) {
      EXPECT_EQ(o.use, o.is_cut_hole ? kinds::OpeningUse::unknown : kinds::OpeningUse::limb);
      EXPECT_EQ(o.round,
                o.is_cut_hole ? kRoundNothing : round_limb(side > 0 ? kLeftLeg : kRightLeg));
    }
  }
  const auto& joints = woman()->joints;
  const Vec3 left = 0.5 * (joints.at("knee_L") + joints.at("ankle_L"));
  const Vec3 right = 0.5 * (joints.at("knee_R") + joints.at("ankle_R"));
  for (const bool pair : {false, true}) {
    pattern::Pattern stockings = ring(left, 0.36, 0.2);
    stockings.panels[0].holes = {round_hole({0.02, 0.01}, 0.02)};
    if (pair) {
      stockings.panels.push_back(ring(right, 0.36, 0.2).panels[0]);
      stockings.panels[1].name = "other";
      stockings.stitches.push_back(stitch(1, 1, 1, 3));
    }
    int ends = 0;
    for (const Opening& o : openings_of(stockings)) {
      if (o.is_cut_hole) continue;
      ++ends;
      EXPECT_EQ(o.use, kinds::OpeningUse::limb);
      EXPECT_EQ(o.round, round_limb(o.placed.x() > 0 ? kLeftLeg : kRightLeg));
    }
    EXPECT_EQ(ends, pair ? 4 : 2);
  }
}

bool under_soles(const pattern::Pattern& pattern) {
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  return goes_under_soles(sewn, pattern, garment_openings(sewn, pattern, woman()));
}

TEST(LimbPieces, SocksAloneGoUnderTheSolesHoweverLowAndWhereverTheFileHasThem) {
  for (const double height : {0.09, 0.15, 0.3})
    for (const double up : {0.0, 0.2}) {
      pattern::Pattern pattern = sock(1, 0.12, 0.1, height, 0.25);
      for (pattern::Panel& panel : pattern.panels) panel.translation.z() += up;
      EXPECT_TRUE(under_soles(pattern)) << height << " " << up;
      const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
      EXPECT_TRUE(arrange_panels(sewn, garment::open_seams(sewn), pattern, woman()).under_soles);
    }
  EXPECT_FALSE(under_soles(ring(woman()->joints.at("ankle_L"), 0.36, 0.2))) << "open below";
  EXPECT_FALSE(under_soles(ring({0, 0, 0.5}, 1.3, 0.8))) << "a skirt";
}

TEST(LimbPieces, AStockingThatNarrowsDownwardsIsNotUpsideDown) {
  pattern::Pattern pattern = ring(woman()->joints.at("knee_L"), 0.4, 0.3);
  for (const int corner : {0, 1}) pattern.panels[0].vertices[corner].x() *= 0.6;
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const std::vector<Vec3> x = placed_by_pattern(sewn, pattern);
  EXPECT_EQ(way_round(sewn, pattern, x, woman()).upside_down, "");
}

// That it is on its foot is asked of every posture by itself.
TEST(LimbPieces, ASockNeedNotBeComparedWithAnotherPosture) {
  const pattern::Pattern pattern = sock(1, 0.12, 0.1, 0.3, 0.25);
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const std::vector<Vec3> x = placed_by_pattern(sewn, pattern);
  std::vector<Vec3> first = x;
  for (Vec3& p : first) p.x() += 0.6;
  EXPECT_TRUE(worn_alike(sewn, pattern, x, woman(), first, woman().body()));
  EXPECT_FALSE(why_not_worn(sewn, pattern, first, woman(), false).empty());
}

TEST(LimbPieces, ASockOfAKnitIsWornOnItsFoot) {
  testing_support::expect_worn_and_settled(sock(-1, 0.14, 0.1, 0.28, 0.29), 0.02, woman());
}

TEST(LimbPieces, AStripInOnePieceIsSewnRoundTheLimbBeforeWhichItLies) {
  const auto& joints = woman()->joints;
  const LimbLines lines = limb_lines(woman().body());
  for (const auto& [limb, middle, girth] :
       {std::tuple(kLeftLeg, Vec3(0.5 * (joints.at("knee_L") + joints.at("ankle_L"))), 0.36),
        {kRightLeg, joints.at("knee_R") + Vec3(0, 0, 0.06), 0.40},
        {kHead, joints.at("neck") + Vec3(0, 0, 0.16), 0.56}}) {
    const pattern::Pattern pattern = ring(middle, girth, 0.08);
    const garment::Garment sewn = garment::assemble(pattern, 0.02, fabric::Material{});
    const std::vector<Vec3> x = sew_on(sewn, pattern, woman());
    const auto openings = garment_openings(sewn, pattern, woman());
    ASSERT_EQ(openings.size(), 2u);
    for (const Opening& o : openings) {
      EXPECT_EQ(o.use, kinds::OpeningUse::limb) << limb_name(limb);
      EXPECT_EQ(o.round, round_limb(limb)) << limb_name(limb);
      EXPECT_EQ(limbs_through_openings(o.loop, x, lines), round_limb(limb)) << limb_name(limb);
      double z = 0;
      for (int v : o.loop) z += x[v].z() / static_cast<double>(o.loop.size());
      EXPECT_NEAR(z, o.placed.z(), 0.05) << limb_name(limb);
    }
  }
}

}  // namespace
}  // namespace loosefit::drape
