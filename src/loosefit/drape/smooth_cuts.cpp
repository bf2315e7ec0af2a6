#include "loosefit/drape/smooth_cuts.h"

#include <set>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {
namespace {

constexpr int kRings = 2;          ///< of triangles round what cuts
constexpr int kRoundsPerRing = 8;  ///< after which one more is taken
constexpr int kPasses = 3;         ///< of smoothing in a round
constexpr double kReach = 0.5;     ///< within which the skin is looked for [m]

}  // namespace

SmoothedCuts smooth_cuts(std::vector<Vec3> x, const std::vector<Triangle>& triangles,
                         const geometry::ClosestPointTree& skin, double clear, int rounds) {
  SmoothedCuts smoothed;
  std::vector<std::set<int>> around(x.size());
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      around[t[k]].insert(t[(k + 1) % 3]);
      around[t[k]].insert(t[(k + 2) % 3]);
    }
  for (int round = 0; round <= rounds; ++round) {
    const auto cuts = geometry::self_intersections(x, triangles);
    std::set<int> moving;
    for (const auto& [a, b] : cuts)
      for (const int t : {a, b}) moving.insert(triangles[t].begin(), triangles[t].end());
    smoothed.cuts = static_cast<int>(cuts.size());
    if (round == 0) smoothed.first_cuts = smoothed.cuts;
    smoothed.first_cut = cuts.empty() ? std::pair(-1, -1) : cuts.front();
    if (moving.empty() || round == rounds) break;
    for (int ring = 0; ring < kRings + round / kRoundsPerRing; ++ring) {
      std::set<int> wider = moving;
      for (int v : moving) wider.insert(around[v].begin(), around[v].end());
      moving = std::move(wider);
    }
    for (int pass = 0; pass < kPasses; ++pass) {
      std::vector<Vec3> next = x;
      for (int v : moving) {
        Vec3 mean = Vec3::Zero();
        for (int w : around[v]) mean += x[w] / static_cast<double>(around[v].size());
        next[v] = 0.5 * (x[v] + mean);
        geometry::ClosestPoint near;
        const double d = skin.signed_distance(next[v], &near, kReach);
        if (d < clear) {
          const Vec3 away = (next[v] - near.point) * (d < 0 ? -1 : 1);
          if (away.norm() > 1e-9) next[v] = near.point + clear * away.normalized();
        }
      }
      x = std::move(next);
    }
  }
  smoothed.x = std::move(x);
  return smoothed;
}

}  // namespace loosefit::drape
