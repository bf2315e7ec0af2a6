#include "loosefit/drape/raise_offsets.h"

#include <gtest/gtest.h>

#include "support/square_over_ball.h"

namespace loosefit::drape {
namespace {

struct Square : testing_support::SquareOverBall {
  using SquareOverBall::SquareOverBall;
  const std::vector<contact::ContactPoint>& points() const { return model->body().points(); }
  double held_off() const {
    double sum = 0;
    for (const contact::ContactPoint& p : points()) sum += p.offset - 0.5 * material.thickness;
    return sum;
  }
  std::set<int> penetrating() const { return penetrating_triangles(model->mesh(), body->body, x); }
  bool raise(std::map<int, int>& times_cut) {
    return raise_offsets_at_penetrations(*model, *body, x, {0.5 * material.thickness},
                                         penetrating(), times_cut, PenetrationTuning{});
  }
};

TEST(RaiseOffsets, LeavesClothThatDoesNotCutAlone) {
  Square square(0.01);
  const std::size_t before = square.points().size();
  std::map<int, int> times_cut;
  EXPECT_TRUE(square.penetrating().empty());
  EXPECT_FALSE(square.raise(times_cut));
  EXPECT_EQ(square.points().size(), before);
  EXPECT_TRUE(times_cut.empty());
}

TEST(RaiseOffsets, GivesATriangleThatCutsMorePointsAndHoldsThemOffTheSkin) {
  Square square(-0.001);
  const std::size_t before = square.points().size();
  std::map<int, int> times_cut;
  EXPECT_FALSE(square.penetrating().empty());
  EXPECT_TRUE(square.raise(times_cut));
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

TEST(RaiseOffsets, ATriangleThatCutAgainIsHeldOffFartherByThePointsThatItHas) {
  Square square(-0.001);
  std::map<int, int> times_cut;
  square.raise(times_cut);
  const std::size_t points = square.points().size();
  double held_off = square.held_off();
  square.raise(times_cut);
  EXPECT_EQ(square.points().size(), points);
  EXPECT_GT(square.held_off(), held_off);
  held_off = square.held_off();
  std::map<int, int> in_next_posture;
  square.raise(in_next_posture);
  EXPECT_EQ(square.points().size(), points);
  EXPECT_GT(square.held_off(), held_off);
}

TEST(RaiseOffsets, WhatIsAboutToCutIsTreatedAsIfItDid) {
  for (const auto& [height, is_near] : {std::pair(5e-5, true), std::pair(2e-4, false)}) {
    Square square(height);
    std::map<int, int> times_cut;
    EXPECT_TRUE(square.penetrating().empty());
    square.raise(times_cut);
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
}  // namespace loosefit::drape
