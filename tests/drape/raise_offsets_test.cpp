#include "loosefit/drape/raise_offsets.h"

#include <gtest/gtest.h>

#include "support/square_over_ball.h"

namespace loosefit::drape {
namespace {

constexpr double kFarthest = 0.01;

struct Square : testing_support::SquareOverBall {
  using SquareOverBall::SquareOverBall;
  double half_thickness() const { return 0.5 * material.thickness; }
  std::set<int> penetrating() const { return penetrating_triangles(model->mesh(), body->body, x); }
  void raise(std::map<int, int>& times_cut, double farthest = kFarthest) {
    raise_offsets_at_penetrations(*model, farthest, penetrating(), times_cut, PenetrationTuning{});
  }
};

TEST(RaiseOffsets, LeavesClothThatDoesNotCutAlone) {
  Square square(0.01);
  std::map<int, int> times_cut;
  EXPECT_TRUE(square.penetrating().empty());
  square.raise(times_cut);
  EXPECT_TRUE(times_cut.empty());
  for (const contact::ContactPoint& p : square.model->body().points())
    EXPECT_EQ(p.offset, square.half_thickness());
}

TEST(RaiseOffsets, HoldsTheTrianglesThatCutOffTheSkinAndNoOthersMoreSoEachTime) {
  Square square(-0.001);
  const std::set<int> cut = square.penetrating();
  ASSERT_FALSE(cut.empty());
  ASSERT_LT(cut.size(), square.garment.triangles.size());
  const PenetrationTuning tuning;
  std::map<int, int> times_cut;
  double expected = square.half_thickness();
  for (int round = 1; round <= 3; ++round) {
    square.raise(times_cut);
    expected += tuning.clearance + (round - 1) * tuning.clearance_each_time;
    EXPECT_EQ(times_cut.size(), cut.size());
    for (const contact::ContactPoint& p : square.model->body().points()) {
      const bool on_cut = std::any_of(cut.begin(), cut.end(),
                                      [&](int t) { return p.within(square.garment.triangles[t]); });
      EXPECT_NEAR(p.offset, on_cut ? expected : square.half_thickness(), 1e-15);
    }
  }
}

TEST(RaiseOffsets, NoFartherThanTheFieldIsSmooth) {
  Square square(-0.001);
  std::map<int, int> times_cut;
  const double farthest = square.half_thickness() + 2e-4;
  double most = 0;
  for (int round = 0; round < 5; ++round) square.raise(times_cut, farthest);
  for (const contact::ContactPoint& p : square.model->body().points())
    most = std::max(most, p.offset);
  EXPECT_EQ(most, farthest);
}

}  // namespace
}  // namespace loosefit::drape
