#include "loosefit/contact/candidate_pairs.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>
#include <random>

#include "loosefit/base/error.h"
#include "support/shapes.h"

namespace loosefit::contact {
namespace {

using Field = std::vector<Vec3>;

/// A crumpled sheet over another one, of different thickness.
struct Cloth {
  Field x;
  Field flat;  ///< before it was crumpled, its layers 4 mm apart
  std::vector<Triangle> triangles;
  std::vector<double> area, thickness;

  Cloth() {
    std::mt19937 rng(5);
    std::normal_distribution<double> normal;
    for (int layer = 0; layer < 2; ++layer) {
      const geometry::TriangleMesh sheet = support::sheet(0.06, 0.05, 0.01, 0.2, 1 + layer);
      const int first = static_cast<int>(x.size());
      for (const Triangle& t : sheet.triangles) {
        triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        area.push_back(4e-5);
        thickness.push_back(layer == 0 ? 1e-3 : 3e-3);
      }
      for (const Vec3& p : sheet.vertices) {
        flat.push_back(p + Vec3(0, 0, 0.004 * layer));
        x.push_back(flat.back() + 0.002 * Vec3(normal(rng), normal(rng), normal(rng)));
      }
    }
  }
  ContactFeatures features(const Field& rest = {}) const {
    return ContactFeatures(triangles, area, static_cast<int>(x.size()), 1, thickness, {}, rest);
  }
};

std::vector<FeaturePair> all_pairs(const ContactFeatures& f) {
  std::vector<FeaturePair> pairs;
  for (int v = 0; v < static_cast<int>(f.of_vertex.size()); ++v)
    for (int t = 0; t < static_cast<int>(f.triangles.size()); ++t) {
      const Triangle& tri = f.triangles[t];
      if (v == tri[0] || v == tri[1] || v == tri[2]) continue;
      pairs.push_back({PairKind::point_triangle,
                       v,
                       t,
                       {v, tri[0], tri[1], tri[2]},
                       0.5 * (f.of_vertex[v].thickness + f.of_triangle[t].thickness)});
    }
  for (int i = 0; i < static_cast<int>(f.edges.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(f.edges.size()); ++j) {
      const auto &a = f.edges[i], &b = f.edges[j];
      if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
      pairs.push_back({PairKind::edge_edge,
                       i,
                       j,
                       {a[0], a[1], b[0], b[1]},
                       0.5 * (f.of_edge[i].thickness + f.of_edge[j].thickness)});
    }
  return pairs;
}

std::vector<std::uint64_t> keys(const std::vector<FeaturePair>& pairs) {
  std::vector<std::uint64_t> k;
  for (const FeaturePair& p : pairs) k.push_back(p.key());
  return k;
}

Field random_move(const Field& x, double length, std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  const Vec3 common = 2 * length * Vec3(u(rng), u(rng), u(rng));
  Field dx;
  for (std::size_t i = 0; i < x.size(); ++i)
    dx.push_back(common + length * Vec3(u(rng), u(rng), u(rng)));
  return dx;
}

double least_share(const std::vector<FeaturePair>& pairs, const Field& x, const Field& dx) {
  double share = 1;
  for (const FeaturePair& p : pairs)
    share = std::min(share, time_of_impact(p.kind, p.points(x), p.points(dx)));
  return share;
}

/// Moves a list's cloth to and fro and holds its touching pairs against all pairs within `reach`.
template <typename Reach>
void expect_brute_force_touching(CandidatePairs& candidates, Field x, const Reach& reach,
                                 std::size_t at_least) {
  const auto all = all_pairs(candidates.features());
  std::mt19937 rng(1);
  for (int call = 0; call < 40; ++call) {
    std::vector<FeaturePair> expected;
    for (const FeaturePair& p : all)
      if (pair_distance(p.kind, p.points(x)).distance < reach(p)) expected.push_back(p);
    ASSERT_GT(expected.size(), at_least);
    EXPECT_EQ(keys(candidates.touching(x)), keys(expected)) << call;
    const double length = call % 10 == 9 ? 4e-3 : 1e-4;
    const Field dx = random_move(x, length, rng);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += dx[i];
  }
}

TEST(CandidatePairs, TouchingPairsAreThoseOfBruteForceWhileTheClothMoves) {
  const Cloth cloth;
  CandidatePairs candidates(cloth.features());
  expect_brute_force_touching(
      candidates, cloth.x, [](const FeaturePair& p) { return p.reach; }, 20);
  EXPECT_LT(candidates.builds(), 20);  // the list has been of use
  EXPECT_GE(candidates.builds(), 4);   // and has not outlived the long moves
}

TEST(CandidatePairs, WithAShapeAtRestTouchingPairsAreThoseWithinHalfOfTheirDistanceThere) {
  const Cloth cloth;
  CandidatePairs candidates(cloth.features(cloth.flat));
  expect_brute_force_touching(
      candidates, cloth.x,
      [&](const FeaturePair& p) {
        const double at_rest = pair_distance(p.kind, p.points(cloth.flat)).distance;
        return std::min(p.reach, std::max(0.5 * at_rest, 1e-4));  // p.reach: mean thickness
      },
      5);
}

TEST(CandidatePairs, NoPairThatComesWithinReachIsMissedAndTheShareIsThatOfBruteForce) {
  const Cloth cloth;
  CandidatePairs kept(cloth.features()), narrow(cloth.features(), 0.05);
  const auto all = all_pairs(kept.features());
  std::mt19937 rng(2);
  Field x = cloth.x;
  int limited = 0;
  for (int call = 0; call < 40; ++call) {
    const double lengths[] = {1e-5, 3e-4, 1e-3, 1e-2, 5e-2};
    const Field dx = random_move(x, lengths[(call / 4) % 5], rng);
    const auto near = kept.approaching(x, dx);
    // The same pairs as of a list that was made for this call alone, in the same order.
    CandidatePairs fresh(kept.features());
    ASSERT_EQ(keys(near), keys(fresh.approaching(x, dx))) << call;
    ASSERT_EQ(keys(near), keys(narrow.approaching(x, dx))) << call;  // whatever the margin
    const auto found = keys(near);
    std::vector<FeaturePair> meeting;
    for (const FeaturePair& p : all) {
      double least = 1;
      for (int j = 0; j <= 8; ++j) {
        PairPoints at = p.points(x);
        const PairPoints d = p.points(dx);
        for (int k = 0; k < 4; ++k) at[k] += j / 8.0 * d[k];
        least = std::min(least, pair_distance(p.kind, at).distance);
      }
      if (least >= p.reach) continue;
      meeting.push_back(p);
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), p.key())) << call;
    }
    const double share = least_share(near, x, dx);
    // Pairs that are not met might be stopped early, never late.
    EXPECT_LE(share, least_share(meeting, x, dx)) << call;
    limited += share < 1;
    // Nothing passes through on the admissible part of the way: every pair keeps apart.
    for (const FeaturePair& p : all) {
      PairPoints at = p.points(x);
      const double before = pair_distance(p.kind, at).distance;
      const PairPoints d = p.points(dx);
      for (int k = 0; k < 4; ++k) at[k] += share * d[k];
      EXPECT_GE(pair_distance(p.kind, at).distance, 0.0999 * std::min(before, p.reach)) << call;
    }
    const double t = 0.5 * share;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += t * dx[i];
  }
  EXPECT_GT(limited, 15);
  EXPECT_LT(kept.builds(), 40);
}

/// Two larger sheets, one over the other, of which a few points leap while all others creep.
struct LeapingCloth {
  Field x, dx;
  std::vector<Triangle> triangles;
  std::mt19937 rng{11};

  LeapingCloth() {
    for (int layer = 0; layer < 2; ++layer) {
      const geometry::TriangleMesh sheet = support::sheet(0.3, 0.2, 0.01, 0.2, 1 + layer);
      const int first = static_cast<int>(x.size());
      for (const Triangle& t : sheet.triangles)
        triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      for (const Vec3& p : sheet.vertices) x.push_back(p + Vec3(0, 0, 0.004 * layer));
    }
    dx.resize(x.size());
  }
  ContactFeatures features() const {
    return ContactFeatures(triangles, std::vector<double>(triangles.size(), 4e-5),
                           static_cast<int>(x.size()), 2e-3, {}, {});
  }
  /// Neighbours leap together, here and at a place far from there.
  void choose_move() {
    std::uniform_real_distribution<double> u(-1, 1);
    for (Vec3& d : dx) d = 5e-5 * Vec3(u(rng), u(rng), u(rng));
    for (int place = 0; place < 2; ++place) {
      const std::size_t first = rng() % (x.size() - 5);
      const Vec3 leap = 0.012 * Vec3(u(rng), u(rng), u(rng));
      for (std::size_t i = first; i < first + 4; ++i) dx[i] += leap;
    }
  }
  void move() {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += dx[i];
  }
};

TEST(CandidatePairs, AFewPointsThatStrayNeedNoNewListAndNoPairOfTheirsIsMissed) {
  LeapingCloth cloth;
  ASSERT_GT(cloth.x.size(), 1000u);
  CandidatePairs kept(cloth.features());
  kept.touching(cloth.x);
  std::size_t pairs = 0;
  for (int call = 0; call < 12; ++call) {
    cloth.choose_move();
    CandidatePairs fresh(kept.features());
    const auto near = keys(kept.approaching(cloth.x, cloth.dx));
    EXPECT_EQ(near, keys(fresh.approaching(cloth.x, cloth.dx))) << call;
    pairs += near.size();
    cloth.move();
    CandidatePairs later(kept.features());
    EXPECT_EQ(keys(kept.touching(cloth.x)), keys(later.touching(cloth.x))) << call;
  }
  EXPECT_GT(pairs, 200u);
  EXPECT_LE(kept.builds(),
            6);  // of 25 calls, though in each one points leap farther than the margin
}

TEST(CandidatePairs, WhatStraysInAnActiveSetIsFoundThereAndAfterwards) {
  LeapingCloth cloth;
  CandidatePairs kept(cloth.features());
  kept.touching(cloth.x);
  for (int call = 0; call < 6; ++call) {
    cloth.choose_move();
    particles::ActiveSet active_set{{}, std::vector<char>(cloth.x.size(), 0)};
    for (std::size_t i = 0; i < cloth.x.size(); ++i) {
      if (cloth.dx[i].norm() < 1e-3) cloth.dx[i].setZero();
      if (cloth.dx[i].isZero()) continue;
      active_set.particles.push_back(static_cast<int>(i));
      active_set.inside[i] = 1;
    }
    const auto touching_active_set = [&](const std::vector<FeaturePair>& all) {
      std::vector<FeaturePair> some;
      for (const FeaturePair& p : all)
        if (active_set.touches(p.particle, 4)) some.push_back(p);
      return keys(some);
    };
    CandidatePairs fresh(kept.features());
    kept.set_active_set(&active_set);
    EXPECT_EQ(keys(kept.approaching(cloth.x, cloth.dx)),
              touching_active_set(fresh.approaching(cloth.x, cloth.dx)))
        << call;
    cloth.move();
    EXPECT_EQ(keys(kept.touching(cloth.x)), touching_active_set(fresh.touching(cloth.x))) << call;
    kept.set_active_set(nullptr);
    EXPECT_EQ(keys(kept.touching(cloth.x)), keys(fresh.touching(cloth.x))) << call;
  }
  EXPECT_LE(kept.builds(), 4);
}

TEST(CandidatePairs, OneAndTwoThreadsFindTheSame) {
  const Cloth cloth;
  std::vector<std::uint64_t> found[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + k);
    CandidatePairs candidates(cloth.features());
    std::mt19937 rng(3);
    Field x = cloth.x;
    for (int call = 0; call < 10; ++call) {
      const Field dx = random_move(x, 2e-3, rng);
      for (std::uint64_t key : keys(candidates.approaching(x, dx))) found[k].push_back(key);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += 0.1 * dx[i];
    }
  }
  EXPECT_GT(found[0].size(), 100u);
  EXPECT_EQ(found[0], found[1]);
}

TEST(CandidatePairs, OneAndTwoThreadsFindTheSameStrays) {
  std::vector<std::uint64_t> found[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + k);
    LeapingCloth cloth;
    CandidatePairs candidates(cloth.features());
    candidates.touching(cloth.x);
    for (int call = 0; call < 4; ++call) {
      cloth.choose_move();
      for (std::uint64_t key : keys(candidates.approaching(cloth.x, cloth.dx)))
        found[k].push_back(key);
      cloth.move();
    }
    EXPECT_LE(candidates.builds(), 3);
  }
  EXPECT_GT(found[0].size(), 50u);
  EXPECT_EQ(found[0], found[1]);
}

TEST(CandidatePairs, TouchingPairsOfStraysAreThoseOfBruteForce) {
  LeapingCloth cloth;
  CandidatePairs candidates(cloth.features());
  const auto all = all_pairs(candidates.features());
  candidates.touching(cloth.x);
  for (int call = 0; call < 3; ++call) {
    cloth.choose_move();
    cloth.move();
    std::vector<FeaturePair> expected;
    for (const FeaturePair& p : all)
      if (separation(p.kind, p.points(cloth.x)) < p.reach &&
          pair_distance(p.kind, p.points(cloth.x)).distance < p.reach)
        expected.push_back(p);
    EXPECT_EQ(keys(candidates.touching(cloth.x)), keys(expected)) << call;
  }
  EXPECT_EQ(candidates.builds(), 1);
}

/// While everything goes a long common way and turns on it, so that the bounds of motion matter.
TEST(CandidatePairs, WhatAListOfACommonWayReturnsIsWhatANewOneReturns) {
  LeapingCloth cloth;
  CandidatePairs kept(cloth.features());
  std::uniform_real_distribution<double> u(-1, 1);
  for (int call = 0; call < 10; ++call) {
    const Vec3 way(0.02, 0.01 * u(cloth.rng), 0.005 * u(cloth.rng));
    for (std::size_t i = 0; i < cloth.x.size(); ++i)
      cloth.dx[i] = way + Vec3(0, 0, 2e-3 * std::sin(90 * cloth.x[i][0] + call)) +
                    4e-4 * Vec3(u(cloth.rng), u(cloth.rng), u(cloth.rng));
    for (double share : {1.0, 0.8, 0.5, 0.2}) {
      const Field whole = cloth.dx;
      for (Vec3& d : cloth.dx) d *= share;
      CandidatePairs fresh(kept.features());
      EXPECT_EQ(keys(kept.approaching(cloth.x, cloth.dx)),
                keys(fresh.approaching(cloth.x, cloth.dx)))
          << call << ", " << share;
      cloth.dx = whole;
    }
    for (Vec3& d : cloth.dx) d *= 0.3;
    cloth.move();
  }
  EXPECT_LT(kept.builds(), 40);
}

TEST(ContactFeatures, EveryPairOfFeaturesHasOneOwner) {
  const Cloth cloth;
  const ContactFeatures f = cloth.features();
  std::vector<int> vertex(f.of_vertex.size(), 0), edge(f.edges.size(), 0);
  for (std::size_t t = 0; t < f.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (f.owned_vertices[t][k] >= 0) ++vertex[f.owned_vertices[t][k]];
      if (f.owned_edges[t][k] >= 0) ++edge[f.owned_edges[t][k]];
    }
  EXPECT_EQ(vertex, std::vector<int>(vertex.size(), 1));
  EXPECT_EQ(edge, std::vector<int>(edge.size(), 1));
}

TEST(ContactFeatures, SeamsBetweenMaterialsHaveTheMeanThicknessByArea) {
  // Two triangles that share the edge 1-2; the second is three times as large.
  const ContactFeatures f({{0, 1, 2}, {2, 1, 3}}, {1, 3}, 5, 1, {2e-3, 6e-3}, {0, 1});
  EXPECT_DOUBLE_EQ(f.of_vertex[0].thickness, 2e-3);
  EXPECT_DOUBLE_EQ(f.of_vertex[1].thickness, 5e-3);
  EXPECT_DOUBLE_EQ(f.of_vertex[3].thickness, 6e-3);
  EXPECT_DOUBLE_EQ(f.of_vertex[1].area, 4.0 / 3);
  for (std::size_t e = 0; e < f.edges.size(); ++e)
    if (f.edges[e] == std::array<int, 2>{1, 2}) {
      EXPECT_DOUBLE_EQ(f.of_edge[e].thickness, 5e-3);
    }
  EXPECT_EQ(f.of_vertex[0].layer, 0);
  EXPECT_EQ(f.of_vertex[3].layer, 1);
  EXPECT_EQ(f.of_vertex[4].area, 0);
}

TEST(ContactFeatures, NeighboursAtRestBeginToRepelAtAShareOfTheirDistanceThere) {
  // Three triangles above each other, the second 4 mm over the first at rest, the third 40 mm.
  std::vector<Triangle> triangles;
  std::vector<Vec3> rest;
  for (double height : {0.0, 0.004, 0.04}) {
    const int first = static_cast<int>(rest.size());
    triangles.push_back({first, first + 1, first + 2});
    for (const Vec3& p : {Vec3(0, 0, height), Vec3(0.01, 0, height), Vec3(0, 0.01, height)})
      rest.push_back(p);
  }
  const std::vector<double> area(3, 5e-5);
  std::vector<Vec3> x = rest;
  for (int k = 0; k < 9; ++k) x[k].z() = 0.003 * (k / 3);
  const auto reaches = [&](const std::vector<Vec3>& known) {
    CandidatePairs pairs(ContactFeatures(triangles, area, 9, 8e-3, {}, {}, known));
    std::map<std::pair<int, int>, double> reach;  // by the triangles of the two features
    for (const FeaturePair& pair : pairs.touching(x))
      if (pair.kind == PairKind::point_triangle)
        reach[{pair.particle[0] / 3, pair.particle[1] / 3}] = pair.reach;
    return reach;
  };
  const auto unknown = reaches({});
  EXPECT_EQ(unknown.size(), 6u);
  for (const auto& [of, reach] : unknown) EXPECT_DOUBLE_EQ(reach, 8e-3);
  const auto known = reaches(rest);  // 3 mm apart, the first two are farther than half of 4 mm
  EXPECT_EQ(known.size(), 4u);
  EXPECT_FALSE(known.contains({0, 1}));
  EXPECT_DOUBLE_EQ(known.at({0, 2}), 8e-3);
  EXPECT_DOUBLE_EQ(known.at({2, 1}), 8e-3);
  x[3].z() = x[4].z() = x[5].z() = 0.001;
  EXPECT_NEAR(reaches(rest).at({0, 1}), 2e-3, 1e-12);
}

TEST(ContactFeatures, BadListsAreRefused) {
  const std::vector<Triangle> one = {{0, 1, 2}};
  const auto make = [&](std::vector<double> area, double thickness, std::vector<double> each,
                        std::vector<int> layer) {
    ContactFeatures(one, area, 3, thickness, each, layer);
  };
  EXPECT_NO_THROW(make({1}, 1e-3, {}, {}));
  EXPECT_THROW(make({1, 1}, 1e-3, {}, {}), InvalidInput);
  EXPECT_THROW(make({1}, 1e-3, {1e-3, 1e-3}, {}), InvalidInput);
  EXPECT_THROW(make({1}, 1e-3, {}, {0, 1}), InvalidInput);
  EXPECT_THROW(make({1}, 0, {}, {}), InvalidInput);
  EXPECT_THROW(make({1}, 1e-3, {-1e-3}, {}), InvalidInput);
  EXPECT_THROW(make({1}, 1e-3, {}, {-1}), InvalidInput);
  EXPECT_THROW(ContactFeatures(one, {1}, 3, 1e-3, {}, {}, {Vec3::Zero()}), InvalidInput);
}

}  // namespace
}  // namespace loosefit::contact
