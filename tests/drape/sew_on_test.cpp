#include "loosefit/drape/phases/sew_on.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/panel_roles.h"
#include "loosefit/drape/phases/close_seams.h"
#include "loosefit/drape/worn.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/pattern/place_pieces.h"
#include "support/body_fixture.h"
#include "support/placed_top.h"
#include "support/sewn_garments.h"
#include "support/shirt_on_body.h"
#include "support/unsewn_garments.h"
#include "support/worn_and_settled.h"

namespace loosefit::drape {
namespace {

using testing_support::from_nothing;
using testing_support::PlacedTop;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

/// For a person of 1.9 m in a T-pose whose middle is beside the origin.
pattern::Pattern for_somebody_else() {
  PlacedTop top;
  top.arm_angle = 0;
  return top.pattern(Vec3(0.06, 0, 1.0));
}

double height_of_top(const garment::OpenSeams& open, const std::vector<Vec3>& x, int panel) {
  double top = 0;
  for (int v = 0; v < open.garment.vertex_count; ++v)
    if (open.garment.vertex_panel[v] == panel) top = std::max(top, x[v].z());
  return top;
}

TEST(PanelRoles, SleevesAreToldByTheSeamsWhateverTheyAreCalled) {
  pattern::Pattern pattern = for_somebody_else();
  for (std::size_t k = 0; k < pattern.panels.size(); ++k)
    pattern.panels[k].name = "piece_" + std::to_string(k);
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  std::vector<Vec3> placed;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    const pattern::Panel& panel = pattern.panels[open.garment.vertex_panel[v]];
    const Vec2& uv = open.garment.vertex_uv[v];
    placed.push_back(panel.rotation * Vec3(uv[0], uv[1], 0) + panel.translation);
  }
  using Role = PanelRole;
  EXPECT_EQ(panel_roles(open, pattern, garment_openings(sewn, pattern), placed),
            (std::vector<Role>{Role::trunk, Role::trunk, Role::left_arm, Role::left_arm,
                               Role::right_arm, Role::right_arm}));
}

TEST(ArrangePanels, APatternForSomebodyElseComesToTheShouldersAndArmsOfThisBody) {
  const pattern::Pattern pattern = for_somebody_else();
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  const double hps = woman()->landmarks.at("hps_L").z();
  EXPECT_NEAR(height_of_top(open, panels.x, 0), hps, 0.03);
  EXPECT_NEAR(height_of_top(open, panels.x, 1), hps, 0.03);
  Vec3 wrist = Vec3::Zero();  // middle of the left cuff
  int count = 0;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    EXPECT_GT(woman().tree().signed_distance(panels.x[v]), 0);
    const bool left = open.garment.vertex_panel[v] == 2 || open.garment.vertex_panel[v] == 3;
    if (left && std::abs(std::abs(open.garment.vertex_uv[v][0]) - 0.5) < 1e-9)
      wrist += panels.x[v], ++count;
  }
  wrist /= count;
  // Between elbow and fingertips, within a hand's breadth of the line of the arm.
  const Vec3 &elbow = woman()->joints.at("elbow_L"), &at = woman()->joints.at("wrist_L");
  const Vec3 along = (at - elbow).normalized();
  EXPECT_GT((wrist - elbow).dot(along), 0.1);
  const Vec3 off = (wrist - elbow) - (wrist - elbow).dot(along) * along;
  EXPECT_LT(std::hypot(off.x(), off.z()), 0.05);
}

TEST(ArrangePanels, APlacementThatFitsIsKept) {
  const double hps = woman()->landmarks.at("hps_L").z();
  const pattern::Pattern pattern = PlacedTop{}.pattern(Vec3(0, 0, hps - 0.62));
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  for (int v = 0; v < open.garment.vertex_count; ++v)
    if (open.garment.vertex_panel[v] == 0) {
      const Vec2& uv = open.garment.vertex_uv[v];
      EXPECT_NEAR(panels.x[v].x(), uv[0], 1e-12);
      EXPECT_NEAR(panels.x[v].z(), uv[1] + hps - 0.62, 1e-12);
    }
}

TEST(CloseSeams, SewnItCutsNothingOfItselfAndFewSeamsAreOpen) {
  const pattern::Pattern pattern = for_somebody_else();
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  const ClosedSeams closed = close_seams(sewn, open, panels, woman(), 3);
  EXPECT_EQ(closed.cuts, 0);
  EXPECT_TRUE(geometry::self_intersections(closed.x, sewn.triangles).empty());
  EXPECT_LT(closed.gap, 0.03);
  int inside = 0;
  for (const Vec3& p : closed.x) inside += woman().tree().signed_distance(p) < -0.003;
  EXPECT_LT(inside, sewn.vertex_count / 100);
}

TEST(CloseSeams, ASkirtNarrowerThanTheLegsAreApartIsSewnRoundBothOfThem) {
  // To below the knees, with a hem that would have to stretch by a third.
  const testing_support::Levels levels = testing_support::levels_of(woman());
  const pattern::Pattern pattern = testing_support::skirt(levels, 1.05, 0.85, 0.62, 2);
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  const ClosedSeams closed = close_seams(sewn, open, panels, woman(), 3);
  EXPECT_FALSE(closed.in_limb);
  EXPECT_LT(closed.gap, 0.01);
}

TEST(SewOn, ASeamThatWouldGoThroughALimbIsNoRoomWhileThereAreWiderPostures) {
  // Arms that hang into a flared skirt of four gores.
  static const body::PosedBody hanging = support::standing(support::adult_parameters(), 20);
  const testing_support::Levels levels = testing_support::levels_of(hanging);
  const pattern::Pattern pattern = testing_support::skirt(levels, 1.05, 2, 0.6, 4);
  const garment::Garment sewn = garment::assemble(pattern, 0.04, fabric::Material{});
  EXPECT_THROW(sew_on(sewn, pattern, hanging, true), dress::NoRoom);
  EXPECT_EQ(sew_on(sewn, pattern, hanging, false).size(), std::size_t(sewn.vertex_count));
}

TEST(SewOn, HandsThatComeDownPushASkirtAsideAndDoNotPassThroughIt) {
  const body::BodyParameters parameters = support::adult_parameters();
  const testing_support::Levels levels = testing_support::levels_of(woman());
  const pattern::Pattern pattern = testing_support::skirt(levels, 1.0, 2.2, 0.5, 2);
  fabric::Material material;
  material.bending_warp = material.bending_weft = 5e-6;
  const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, 0.02, material);
  const body::BodyPath path = [&](double share) {
    return body_model().build(parameters, body::blend(body::kArmsApart, body::kStanding, share));
  };
  Progress silent;
  const Drape drape = drape_garment(garment, material, path, DrapeOptions{}, silent);
  EXPECT_TRUE(drape.certificate.settled()) << drape.certificate.stop_reason;
  const garment::Garment& mesh = garment.finest();
  double most = 0;  // stretch of an edge
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Triangle& c = mesh.triangles[t];
      const double flat = (mesh.triangle_uv[t][k] - mesh.triangle_uv[t][(k + 1) % 3]).norm();
      most =
          std::max(most, (drape.positions[c[k]] - drape.positions[c[(k + 1) % 3]]).norm() / flat);
    }
  EXPECT_LT(most, 1.3);  // round a hand it was 3
}

TEST(ArrangePanels, ASleeveInOnePieceIsRolledRoundTheArm) {
  const pattern::Pattern pattern = from_nothing(testing_support::unsewn_tshirt());
  const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  const double hps = woman()->landmarks.at("hps_L").z();
  EXPECT_NEAR(height_of_top(open, panels.x, 0), hps, 0.03);
  int left = -1;
  for (std::size_t k = 0; k < open.garment.panel_names.size(); ++k)
    if (open.garment.panel_names[k] == "sleeve_mirrored") left = static_cast<int>(k);
  ASSERT_GE(left, 0);
  EXPECT_TRUE(panels.outside[left].isZero());
  // The cuff goes all the way round the arm: no plane through the arm has all of it on one side.
  std::vector<Vec3> cuff;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    EXPECT_GT(woman().tree().signed_distance(panels.x[v]), 0) << v;
    if (open.garment.vertex_panel[v] == left && open.garment.vertex_uv[v][1] < -0.149)
      cuff.push_back(panels.x[v]);
  }
  const Vec3 &shoulder = woman()->joints.at("shoulder_L"), &elbow = woman()->joints.at("elbow_L"),
             &wrist = woman()->joints.at("wrist_L");
  const Vec3 mean = std::accumulate(cuff.begin(), cuff.end(), Vec3(0, 0, 0)) / double(cuff.size());
  const Vec3 along = (wrist - elbow).normalized(), upper = (elbow - shoulder).normalized();
  const bool below_elbow = (mean - elbow).dot(along) > 0;
  const Vec3 axis = below_elbow ? along : upper;
  const Vec3 on_arm = elbow + (mean - elbow).dot(axis) * axis;
  for (int i = 0; i < 8; ++i) {
    const Vec3 across = axis.cross(Vec3::UnitY()).normalized();
    const Vec3 n = Eigen::AngleAxisd(i * kPi / 4, axis) * across;
    EXPECT_TRUE(std::any_of(cuff.begin(), cuff.end(), [&](const Vec3& p) {
      return (p - on_arm).dot(n) > 0.03;
    })) << i;
  }
  const ClosedSeams closed = close_seams(sewn, open, panels, woman(), 3);
  EXPECT_EQ(closed.cuts, 0);
  EXPECT_LT(closed.gap, 0.03);
}

TEST(SewOn, AGarmentWithoutAnyPlacementIsWornAndSettled) {
  for (const bool trousers : {false, true}) {
    SCOPED_TRACE(trousers);
    const auto& m = woman()->measured;
    const pattern::Pattern pattern =
        from_nothing(trousers ? testing_support::unsewn_trousers(
                                    1.02 * m.at("waist"), 1.06 * m.at("hip"),
                                    m.at("waist_level") - m.at("crotch_height") + 0.02,
                                    m.at("waist_level") - 0.12)
                              : testing_support::unsewn_tshirt(0.56 * m.at("chest")));
    testing_support::expect_worn_and_settled(pattern, 0.03, woman());
  }
}

TEST(SewOn, ASleevedTopOfAFileForSomebodyElseIsWornAndSettled) {
  const pattern::Pattern pattern = for_somebody_else();
  testing_support::expect_worn_and_settled(pattern, 0.03, woman());
}

}  // namespace
}  // namespace loosefit::drape
