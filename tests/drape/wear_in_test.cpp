#include "loosefit/drape/phases/wear_in.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/body/breath.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/phases/contract.h"
#include "loosefit/drape/phases/dress_on.h"
#include "loosefit/drape/recoveries.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

/// A shirt on its coarsest mesh, dressed and contracted.
struct Dressed {
  body::BodyParameters parameters = support::adult_parameters();
  fabric::Material material = support::knit();
  garment::GarmentHierarchy garment = garment::build_hierarchy(
      support::shirt_for(support::standing(parameters, 40), 0.10), 0.05, material);
  std::vector<ClothLayer> layers{{&garment, material}};
  DrapeOptions options;
  Progress silent;
  ClothState state{layers, options, recoveries(), silent};

  Dressed() {
    state.path = support::arms_path(parameters, 40, 40);
    dress_on(state);
    contract_soft(state);
    contract(state);
  }
  std::vector<int> hem() const {
    for (const Opening& opening : garment_openings(garment.levels[0], garment.pattern))
      if (opening.use == kinds::OpeningUse::hem) return opening.loop;
    return {};
  }
};

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

TEST(WearIn, PullsAtTheHemAloneDownTheTrunkWithSoManyWeights) {
  const Dressed shirt;
  const particles::VectorField force = hem_pull(shirt.state, 5);
  const std::vector<int> hem = shirt.hem();
  ASSERT_FALSE(hem.empty());
  Vec3 sum = Vec3::Zero();
  int pulled = 0;
  for (const Vec3& f : force) sum += f, pulled += f.norm() > 0;
  EXPECT_EQ(pulled, static_cast<int>(hem.size()));
  EXPECT_NEAR(sum.norm(), 5 * shirt.garment.levels[0].mass * kGravity, 1e-9);
  EXPECT_LT(sum.z(), -0.95 * sum.norm());
}

TEST(WearIn, LeavesBodyAndLoadAsTheyWereAndTheClothElsewhere) {
  Dressed shirt;
  ClothState& state = shirt.state;
  const std::shared_ptr<const ContactBody> body = state.body;
  const std::vector<Vec3> before = state.x;
  state.movements = {{.name = "hem-pull", .hem_pull = 5}};
  wear_in(state);
  EXPECT_EQ(state.body, body);
  EXPECT_FALSE(state.model->is_loaded());
  EXPECT_GT(farthest(state.x, before), 0.005) << "friction holds it where it came to lie";
}

TEST(WearIn, AWayThereAndBackEndsOnTheSameBodyWithTheClothElsewhere) {
  const auto lowest = [](const std::vector<Vec3>& x) {
    double z = HUGE_VAL;
    for (const Vec3& p : x) z = std::min(z, p.z());
    return z;
  };
  double hem[2];
  for (const bool drawn : {false, true}) {
    Dressed shirt;
    ClothState& state = shirt.state;
    const std::shared_ptr<const ContactBody> body = state.body;
    const std::vector<Vec3> before = state.x;
    const auto raised = [&](double share) {
      return body::PosedBody(
          body_model().build(shirt.parameters, {radians(40), 0, 0, radians(60) * share}));
    };
    state.movements = {{.name = "arm-raise", .way = raised, .hem_pull = drawn ? 5.0 : 0.0}};
    wear_in(state);
    EXPECT_EQ(state.body, body);
    EXPECT_FALSE(state.model->is_loaded());
    EXPECT_GT(farthest(state.x, before), 0.005);
    EXPECT_LT(farthest(state.x, before), 0.3);
    hem[drawn] = lowest(state.x);
  }
  EXPECT_LT(hem[true], hem[false] - 0.001) << "drawn down as the arms come down";
}

TEST(WearIn, ABodyWithoutASkeletonBreathesToo) {
  Dressed shirt;
  ClothState& state = shirt.state;
  body::Body scan = state.body->body;
  scan.pose_from_rest.clear();
  state.body = with_field(scan, bounds(state.x), contact::kFieldSpacing, state.tuning.carry);
  state.model->set_body(*state.body);
  double widest = 1;
  state.movements = {{.name = "breath", .way = [&](double share) {
                        widest = std::max(widest,
                                          body::breathing_girth(body::inhaled(scan, 0.02 * share)) /
                                              body::breathing_girth(scan));
                        return body::PosedBody(body::inhaled(scan, 0.02 * share));
                      }}};
  wear_in(state);
  EXPECT_NEAR(widest, 1.02, 1e-4);
  EXPECT_EQ(state.body->body->surface.vertices, scan.surface.vertices);
}

double friction_on_body(const ClothState& state) {
  particles::VectorField force(state.x.size(), Vec3::Zero());
  state.model->body().add_friction(state.x, force);
  double sum = 0;
  for (const Vec3& f : force) sum += f.norm();
  return sum;
}

TEST(WearIn, FidgetingSetsFreeWhatFrictionHadLockedIn) {
  Dressed shirt;
  ClothState& state = shirt.state;
  state.movements = {{.name = "hem-pull", .hem_pull = 5}};
  wear_in(state);
  const std::vector<Vec3> locked = state.x;
  const double held = friction_on_body(state);
  state.movements = {{.name = "fidget", .friction_share = 0.2}};
  wear_in(state);
  EXPECT_EQ(state.x, locked) << "the levels settle under it";
  state.loosen_friction();
  const SettleGoal goal{5, 50, 0.02, true};
  state.settle(goal);
  EXPECT_GT(farthest(state.x, locked), 0.001);
  state.stick();
  EXPECT_EQ(friction_on_body(state), 0) << "it sticks anew from where the cloth lies";
  state.settle(goal);
  EXPECT_GT(friction_on_body(state), 0) << "in full again";
  EXPECT_LT(friction_on_body(state), held);
}

TEST(WearIn, ADrapeThatWasMovedInSettlesElsewhere) {
  const Dressed shirt;
  const auto drape = [&](const Movements& movements) {
    Progress silent;
    DrapeSession session(shirt.garment, shirt.material, {}, silent);
    return session.put_on(support::arms_path(shirt.parameters, 40, 25), {}, movements);
  };
  const Drape plain = drape({}), worn_in = drape({{.name = "hem-pull", .hem_pull = 5}});
  ASSERT_TRUE(plain.certificate.settled()) << plain.certificate.stop_reason;
  ASSERT_TRUE(worn_in.certificate.settled()) << worn_in.certificate.stop_reason;
  EXPECT_GT(farthest(plain.positions, worn_in.positions), 0.002);
  EXPECT_TRUE(std::any_of(worn_in.report.parts.begin(), worn_in.report.parts.end(),
                          [](const PartWork& p) { return p.part == "wear-in" && p.level == 0; }));
}

}  // namespace
}  // namespace loosefit::drape
