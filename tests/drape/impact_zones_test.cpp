#include "loosefit/drape/impact_zones.h"

#include <gtest/gtest.h>

#include "loosefit/contact/candidate_pairs.h"
#include "loosefit/contact/pair_distance.h"
#include "loosefit/drape/settling_tuning.h"
#include "support/shapes.h"

namespace loosefit::drape {
namespace {

const int kRounds = CarryTuning{}.impact_rounds;

constexpr double kGap = 1e-3;

/// Two square sheets, one above the other.
struct Layers {
  std::vector<Vec3> x;
  std::vector<Triangle> triangles;
  Layers() {
    for (int layer = 0; layer < 2; ++layer) {
      const int first = 4 * layer;
      for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        x.emplace_back(0.01 * u, 0.01 * v, kGap * layer);
      triangles.push_back({first, first + 1, first + 2});
      triangles.push_back({first, first + 2, first + 3});
    }
  }
  contact::ContactFeatures features() const {
    return contact::ContactFeatures(triangles, std::vector<double>(triangles.size(), 5e-5), 8, 5e-4,
                                    {}, {});
  }
  double free_way(const std::vector<Vec3>& u) const {
    contact::CandidatePairs candidates(features());
    double least = 1;
    for (const contact::FeaturePair& pair : candidates.approaching(x, u))
      least = std::min(least, contact::time_of_impact(pair.kind, pair.points(x), pair.points(u)));
    return least;
  }
};

TEST(ImpactZones, LeaveWhatDoesNotCollideAlone) {
  const Layers layers;
  std::vector<Vec3> u(8, Vec3(0.1, 0, 0));
  for (int i = 4; i < 8; ++i) u[i] = Vec3(0.1, 0, 0.02);
  EXPECT_EQ(without_impacts(layers.features(), layers.x, u, kRounds), u);
}

TEST(ImpactZones, MoveWhatWouldCollideTogether) {
  const Layers layers;
  std::vector<Vec3> u(8, Vec3::Zero());
  for (int i = 4; i < 8; ++i) u[i] = Vec3(0, 0, -0.01);  // through the lower sheet
  EXPECT_LT(layers.free_way(u), 0.2);
  const std::vector<Vec3> kept = without_impacts(layers.features(), layers.x, u, kRounds);
  EXPECT_DOUBLE_EQ(layers.free_way(kept), 1);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& d : kept) mean += d / 8;
  EXPECT_NEAR(mean.z(), -0.005, 1e-12) << "the momentum of equal masses is kept";
}

TEST(ImpactZones, KeepARigidTurnOfAZone) {
  const Layers layers;
  const Mat3 turn = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix();
  std::vector<Vec3> u;
  for (const Vec3& p : layers.x) u.push_back(turn * p - p);
  for (int i = 4; i < 8; ++i) u[i].z() -= 3e-3;  // and the upper sheet presses on
  const std::vector<Vec3> kept = without_impacts(layers.features(), layers.x, u, kRounds);
  EXPECT_DOUBLE_EQ(layers.free_way(kept), 1);
  for (int i = 1; i < 8; ++i)
    EXPECT_NEAR((layers.x[i] + kept[i] - layers.x[0] - kept[0]).norm(),
                (layers.x[i] - layers.x[0]).norm(), 1e-12);
}

}  // namespace
}  // namespace loosefit::drape
