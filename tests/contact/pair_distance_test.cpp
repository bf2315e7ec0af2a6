#include "loosefit/contact/pair_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace loosefit::contact {
namespace {

using Points = std::array<Vec3, 4>;

double distance(PairKind kind, const Points& x) {
  return kind == PairKind::point_triangle ? point_triangle_distance(x[0], x[1], x[2], x[3]).distance
                                          : edge_edge_distance(x[0], x[1], x[2], x[3]).distance;
}

/// Smallest distance over a fine sampling of the two features: never below the true one and at most
/// a sample spacing above it.
double sampled(PairKind kind, const Points& x, int n) {
  double least = 1e9;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double s = double(i) / n, t = double(j) / n;
      if (kind == PairKind::point_triangle) {
        if (i + j > n) continue;
        least = std::min(least, ((1 - s - t) * x[1] + s * x[2] + t * x[3] - x[0]).norm());
      } else {
        least = std::min(least, ((1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3]).norm());
      }
    }
  return least;
}

void expect_matches_sampling(PairKind kind, const Points& x) {
  const int n = 120;
  const double d = distance(kind, x), approximate = sampled(kind, x, n);
  double size = 0;
  for (const Vec3& a : x)
    for (const Vec3& b : x) size = std::max(size, (a - b).norm());
  EXPECT_LE(d, approximate + 1e-12) << (kind == PairKind::edge_edge ? "edges" : "point, triangle");
  EXPECT_GE(d, approximate - 2 * size / n);
  const PairDistance p = kind == PairKind::point_triangle
                             ? point_triangle_distance(x[0], x[1], x[2], x[3])
                             : edge_edge_distance(x[0], x[1], x[2], x[3]);
  EXPECT_NEAR(p.weight[0] + p.weight[1] + p.weight[2] + p.weight[3], 0, 1e-12);
  Vec3 gap = Vec3::Zero();
  for (int k = 0; k < 4; ++k) gap += p.weight[k] * x[k];
  EXPECT_NEAR(gap.norm(), p.distance, 1e-15);
  if (p.distance > 0) {
    EXPECT_LT((p.normal * p.distance - gap).norm(), 1e-14);
  }
}

Points random_points(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  Points x;
  for (Vec3& p : x) p = Vec3(u(rng), u(rng), u(rng));
  return x;
}

TEST(PairDistance, MatchesSamplingInGeneralPosition) {
  std::mt19937 rng(1);
  for (int i = 0; i < 150; ++i) {
    const Points x = random_points(rng);
    expect_matches_sampling(PairKind::point_triangle, x);
    expect_matches_sampling(PairKind::edge_edge, x);
  }
}

TEST(PairDistance, MatchesSamplingForDegenerateFeatures) {
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 60; ++i) {
    Points x = random_points(rng);
    SCOPED_TRACE(i);
    x[3] = x[2] + 0.7 * (x[1] - x[0]);  // parallel edges
    expect_matches_sampling(PairKind::edge_edge, x);
    x[3] = x[2] - 0.7 * (x[1] - x[0]) + 1e-9 * Vec3(u(rng), u(rng), u(rng));  // nearly
    expect_matches_sampling(PairKind::edge_edge, x);
    x[2] = x[0] + u(rng) * 3 * (x[1] - x[0]);  // on one line
    x[3] = x[2] + u(rng) * (x[1] - x[0]);
    expect_matches_sampling(PairKind::edge_edge, x);
    x[3] = x[2];  // an edge without length
    expect_matches_sampling(PairKind::edge_edge, x);
    x[1] = x[0];
    expect_matches_sampling(PairKind::edge_edge, x);

    x = random_points(rng);
    x[3] = x[1] + 0.4 * (x[2] - x[1]);  // a triangle without area
    expect_matches_sampling(PairKind::point_triangle, x);
    x[3] = x[1] + 1.6 * (x[2] - x[1]);
    expect_matches_sampling(PairKind::point_triangle, x);
    x[3] = x[2];
    expect_matches_sampling(PairKind::point_triangle, x);
    x[1] = x[2];
    expect_matches_sampling(PairKind::point_triangle, x);
  }
}

TEST(PairDistance, ZeroWhereTheyTouch) {
  EXPECT_LT(point_triangle_distance({0.2, 0.2, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}).distance,
            1e-15);
  EXPECT_LT(edge_edge_distance({-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}).distance, 1e-15);
}

Points moved(Points x, const Points& dx, double share) {
  for (int k = 0; k < 4; ++k) x[k] += share * dx[k];
  return x;
}

/// First time at which dense sampling in time finds the features nearer than `touch`; 2 if never.
double sampled_contact(PairKind kind, const Points& x, const Points& dx, double touch) {
  const int n = 2000;
  for (int i = 0; i <= n; ++i) {
    if (distance(kind, moved(x, dx, double(i) / n)) < touch) return double(i) / n;
  }
  return 2;
}

TEST(TimeOfImpact, NeverPassesContactAndDoesNotStopWithoutReason) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const PairKind kind = i % 2 ? PairKind::edge_edge : PairKind::point_triangle;
    const Points x = random_points(rng);
    const double start = distance(kind, x);
    if (start < 0.05) continue;
    // Moves that make them meet at a random time: the nearest points swap sides, plus noise.
    const PairDistance p = kind == PairKind::point_triangle
                               ? point_triangle_distance(x[0], x[1], x[2], x[3])
                               : edge_edge_distance(x[0], x[1], x[2], x[3]);
    const double through = 0.5 + std::abs(u(rng));
    Points dx;
    for (int k = 0; k < 4; ++k) {
      const bool first = kind == PairKind::point_triangle ? k == 0 : k < 2;
      dx[k] =
          (first ? -1.0 : 0.5) * through * start * p.normal + 0.2 * Vec3(u(rng), u(rng), u(rng));
    }
    const double t = time_of_impact(kind, x, dx);
    ASSERT_GE(t, 0);
    ASSERT_LE(t, 1);
    // On the whole way up to t they stay apart by a tenth of their distance.
    for (int j = 0; j <= 200; ++j) {
      ASSERT_GE(distance(kind, moved(x, dx, t * j / 200.0)), 0.0999 * start) << i;
    }
    if (t < 1) {
      ++hits;
      EXPECT_LT(distance(kind, moved(x, dx, t)), 0.15 * start) << i << ": stopped without reason";
    } else {
      EXPECT_EQ(sampled_contact(kind, x, dx, 0.05 * start), 2) << i;
    }
  }
  EXPECT_GT(hits, 200);
}

TEST(TimeOfImpact, CommonMotionAndPartingAreFree) {
  const Points x = {Vec3(0.2, 0.2, 1e-3), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Points dx;
  dx.fill(Vec3(3, -2, -5));
  EXPECT_EQ(time_of_impact(PairKind::point_triangle, x, dx), 1);
  dx.fill(Vec3::Zero());
  EXPECT_EQ(time_of_impact(PairKind::point_triangle, x, dx), 1);
  dx[0] = Vec3(0, 0, 1e-4);  // away
  EXPECT_EQ(time_of_impact(PairKind::point_triangle, x, dx), 1);
}

TEST(TimeOfImpact, StopsAThinSheetShotAtWithHugeSpeed) {
  const Points x = {Vec3(0.2, 0.2, 1e-3), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Points dx;
  dx.fill(Vec3::Zero());
  dx[0] = Vec3(0, 0, -100);
  const double t = time_of_impact(PairKind::point_triangle, x, dx);
  EXPECT_GT(t * 100, 0.85e-3);
  EXPECT_LT(t * 100, 0.95e-3);
}

// A bound from the lengths of the motions alone would let them go a few hundred nanometres a call.
TEST(TimeOfImpact, SlidingAlongEachOtherIsFreeHoweverNear) {
  const double gap = 1e-9;
  Points x = {Vec3(-1, 0, gap), Vec3(1, 0, gap), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  Points dx = {Vec3(0.5, 0.3, 0), Vec3(0.4, -0.2, 0), Vec3(-0.1, 0.6, 0), Vec3(0.2, 0.5, 0)};
  EXPECT_EQ(time_of_impact(PairKind::edge_edge, x, dx), 1);
  x = {Vec3(0.2, 0.2, gap), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  dx = {Vec3(0.1, 0.3, 0), Vec3(0, 0.2, 0), Vec3(0.2, 0, 0), Vec3(0, 0, -0.1)};
  EXPECT_EQ(time_of_impact(PairKind::point_triangle, x, dx), 1);
}

// Far from the origin, tilted, and so near that round-off tilts the normal: still no way through.
TEST(TimeOfImpact, KeepsFeaturesApartAtNanometres) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<double> u(-1, 1);
  int stopped = 0;
  for (int i = 0; i < 400; ++i) {
    const PairKind kind = i % 2 ? PairKind::edge_edge : PairKind::point_triangle;
    const double gap = std::pow(10.0, -4.0 - 5.0 * (i % 50) / 49.0), size = 0.01;
    Points x =
        kind == PairKind::edge_edge
            ? Points{Vec3(-size, 0, gap), Vec3(size, 0, gap), Vec3(0, -size, 0), Vec3(0, size, 0)}
            : Points{Vec3(0, 0, gap), Vec3(-size, -size, 0), Vec3(2 * size, -size, 0),
                     Vec3(-size, 2 * size, 0)};
    const Eigen::Quaterniond turn(Eigen::Vector4d(u(rng), u(rng), u(rng), u(rng)).normalized());
    for (Vec3& p : x) p = turn * p + Vec3(0.3, -0.2, 1.3);
    const double start = distance(kind, x);
    Points dx;
    for (Vec3& d : dx) d = 0.005 * Vec3(u(rng), u(rng), u(rng));
    const double t = time_of_impact(kind, x, dx);
    stopped += t < 1;
    for (int j = 0; j <= 100; ++j) {
      ASSERT_GE(distance(kind, moved(x, dx, t * j / 100.0)), 0.05 * start - 1e-15)
          << i << " gap " << gap;
    }
  }
  EXPECT_GT(stopped, 100);
}

TEST(TimeOfImpact, MotionThatIsNotANumberIsNotFree) {
  const Points x = {Vec3(0, 0, 1e-3), Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)};
  Points dx;
  dx.fill(Vec3::Zero());
  dx[0].z() = std::nan("");
  EXPECT_EQ(time_of_impact(PairKind::point_triangle, x, dx), 0);
}

TEST(PairDistance, HessianIsTheDerivativeOfTheGradient) {
  std::mt19937 rng(6);
  const double h = 1e-6;
  for (int i = 0; i < 300; ++i) {
    const PairKind kind = i % 2 ? PairKind::edge_edge : PairKind::point_triangle;
    const Points x = random_points(rng);
    const PairDistance d = pair_distance(kind, x);
    if (d.distance < 0.1) continue;
    const PairMatrix exact = distance_hessian(kind, x, d);
    double worst = 0;
    bool same_part = true;
    for (int k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c) {
        Points plus = x, minus = x;
        plus[k][c] += h;
        minus[k][c] -= h;
        const PairDistance up = pair_distance(kind, plus), down = pair_distance(kind, minus);
        for (int j = 0; j < 4; ++j) {
          same_part &= (up.weight[j] == 0) == (down.weight[j] == 0);
          const Vec3 slope = (up.weight[j] * up.normal - down.weight[j] * down.normal) / (2 * h);
          worst = std::max(worst, (slope - exact.block<3, 1>(3 * j, 3 * k + c)).norm());
        }
      }
    if (same_part) {
      EXPECT_LT(worst, 1e-6 * (1 + exact.norm())) << i;
    }
  }
}

TEST(PairDistance, SeparationAndMotionBoundHold) {
  std::mt19937 rng(7);
  int close = 0;
  for (int i = 0; i < 2000; ++i) {
    const PairKind kind = i % 2 ? PairKind::edge_edge : PairKind::point_triangle;
    const Points x = random_points(rng), dx = random_points(rng);
    const double d = distance(kind, x), gap = separation(kind, x), loss = motion_bound(kind, dx);
    ASSERT_LE(gap, d * (1 + 1e-12));
    close += gap > 0.8 * d;
    Points y = x;
    for (int k = 0; k < 4; ++k) y[k] += dx[k];
    ASSERT_GE(distance(kind, y), d - loss - 1e-12);
    Points common;
    common.fill(dx[0]);
    ASSERT_LT(motion_bound(kind, common), 1e-12);
  }
  EXPECT_GT(close, 500);  // the quick bound is worth its while
}

/// What a list of candidates with a margin rests on.
TEST(PairDistance, DeviationsByOneFromACommonMotionCostAtMostFourOverRootThree) {
  const double most = 4 / std::sqrt(3.0);
  const Vec3 far(100, 0, 0);
  std::mt19937 rng(8);
  for (PairKind kind : {PairKind::point_triangle, PairKind::edge_edge}) {
    for (int i = 0; i < 20000; ++i) {
      Points dx = random_points(rng);
      for (Vec3& d : dx) d = far + d.normalized();
      ASSERT_LE(motion_bound(kind, dx), most * (1 + 1e-12));
    }
    const double c = std::sqrt(8.0) / 3;
    const Vec3 left(-c, 1.0 / 3, 0), right(c, 1.0 / 3, 0), down(0, -1, 0);
    const Points worst = kind == PairKind::point_triangle ? Points{left, right, down, down}
                                                          : Points{left, down, right, down};
    Points moved;
    for (int k = 0; k < 4; ++k) moved[k] = far + worst[k];
    EXPECT_NEAR(motion_bound(kind, moved), most, 1e-12);
  }
}

}  // namespace
}  // namespace loosefit::contact
