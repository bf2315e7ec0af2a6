#include "loosefit/drape/raise_offsets.h"

#include <gtest/gtest.h>

#include "support/square_over_ball.h"

namespace loosefit::drape {
namespace {

struct Square : testing_support::SquareOverBall {
  using SquareOverBall::SquareOverBall;
  double half_thickness() const { return 0.5 * material.thickness; }
  std::set<int> penetrating() const { return penetrating_triangles(model->mesh(), body->body, x); }
  void raise(std::map<int, int>& times_cut) {
    raise_offsets_at_penetrations(*model, *body, x, penetrating(), times_cut, PenetrationTuning{});
  }
  /// Of the contact points of a triangle [m].
  double least_distance(int triangle) const {
    double least = 1;
    for (int p : model->lattice().points_of(triangle))
      least =
          std::min(least, body->body.tree().signed_distance(model->body().points()[p].position(x)));
    return least;
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
  std::vector<double> expected(square.model->body().points().size(), square.half_thickness());
  for (int round = 1; round <= 3; ++round) {
    square.raise(times_cut);
    EXPECT_EQ(times_cut.size(), cut.size());
    std::vector<double> raise(expected.size(), 0.0);
    for (int t : cut)
      for (int p : square.model->lattice().points_of(t))
        raise[p] = std::max(
            raise[p], std::min(tuning.clearance - square.least_distance(t), tuning.largest_raise) +
                          round * tuning.clearance_each_time);
    for (std::size_t p = 0; p < expected.size(); ++p)
      EXPECT_NEAR(square.model->body().points()[p].offset, expected[p] += raise[p], 1e-9) << p;
  }
}

TEST(RaiseOffsets, NoFartherThanTheFieldIsSmooth) {
  Square square(-0.001);
  std::map<int, int> times_cut;
  double most = 0;
  for (int round = 0; round < 60; ++round) square.raise(times_cut);
  for (const contact::ContactPoint& p : square.model->body().points())
    most = std::max(most, p.offset);
  EXPECT_EQ(most, square.body->field->smooth_reach());
}

}  // namespace
}  // namespace loosefit::drape
