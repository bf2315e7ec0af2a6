#include "loosefit/drape/hold_off_cuts.h"

#include <gtest/gtest.h>

#include "support/square_over_ball.h"

namespace loosefit {
namespace {

struct Square : testing_support::SquareOverBall {
  using SquareOverBall::SquareOverBall;
  const std::vector<ContactPoint>& points() const { return model->body().points(); }
  double held_off() const {
    double sum = 0;
    for (const ContactPoint& p : points()) sum += p.offset - 0.5 * material.thickness;
    return sum;
  }
  CutRound round(std::map<int, int>& times_cut, bool look_ahead = false) {
    return hold_off_cuts(*model, *body, x, {0.5 * material.thickness}, look_ahead, times_cut);
  }
};

TEST(HoldOffCuts, LeavesClothThatDoesNotCutAlone) {
  Square square(0.01);
  const std::size_t before = square.points().size();
  std::map<int, int> times_cut;
  const CutRound round = square.round(times_cut);
  EXPECT_FALSE(round.cuts || round.held);
  EXPECT_EQ(square.points().size(), before);
  EXPECT_TRUE(times_cut.empty());
}

TEST(HoldOffCuts, GivesATriangleThatCutsMorePointsAndHoldsThemOffTheSkin) {
  Square square(-0.001);
  const std::size_t before = square.points().size();
  std::map<int, int> times_cut;
  const CutRound round = square.round(times_cut);
  EXPECT_TRUE(round.cuts && round.held);
  ASSERT_FALSE(times_cut.empty());
  std::map<Triangle, int> lattice;
  for (std::size_t i = before; i < square.points().size(); ++i)
    ++lattice[square.points()[i].particle];
  EXPECT_EQ(lattice.size(), times_cut.size());
  for (const auto& [t, times] : times_cut) {
    EXPECT_EQ(times, 1);
    // At least five intervals an edge without corners, edge midpoints aside.
    EXPECT_GE(lattice.at(square.garment.triangles[t]), 12);
  }
  for (std::size_t i = before; i < square.points().size(); ++i) {
    EXPECT_GE(square.points()[i].offset, 0.5 * square.material.thickness + 3e-5);
    EXPECT_LE(square.points()[i].offset, square.body->field->smooth_reach());
  }
}

TEST(HoldOffCuts, ATriangleThatCutAgainIsHeldOffFartherByThePointsThatItHas) {
  Square square(-0.001);
  std::map<int, int> times_cut;
  square.round(times_cut);
  const std::size_t points = square.points().size();
  double held_off = square.held_off();
  square.round(times_cut);
  EXPECT_EQ(square.points().size(), points);
  EXPECT_GT(square.held_off(), held_off);
  held_off = square.held_off();
  std::map<int, int> in_next_posture;
  square.round(in_next_posture);
  EXPECT_EQ(square.points().size(), points);
  EXPECT_GT(square.held_off(), held_off);
}

TEST(HoldOffCuts, LookingAheadTreatsWhatIsAboutToCutAsIfItDid) {
  for (const auto& [height, is_near] : {std::pair(5e-5, true), std::pair(2e-4, false)}) {
    Square square(height);
    std::map<int, int> times_cut;
    EXPECT_FALSE(square.round(times_cut, true).cuts);
    // The top of the ball is under the middle of the square, and nowhere else is it that near.
    EXPECT_EQ(!times_cut.empty(), is_near);
    EXPECT_LE(times_cut.size(), 6u);
    for (const auto& [t, times] : times_cut) {
      double nearest = 1;
      for (int v : square.garment.triangles[t])
        nearest = std::min(nearest, square.x[v].head<2>().norm());
      EXPECT_LT(nearest, 0.03);
    }
  }
}

}  // namespace
}  // namespace loosefit
