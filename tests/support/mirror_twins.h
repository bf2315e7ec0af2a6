#pragma once
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "loosefit/body/body.h"
#include "support/body_fixture.h"

namespace loosefit {

inline Vec3 in_the_mirror(const Vec3& p) { return {-p.x(), p.y(), p.z()}; }

/// The posture with left and right exchanged.
inline body::Posture mirrored(body::Posture posture) {
  posture.trunk_rotation = -posture.trunk_rotation;
  posture.side_bend = -posture.side_bend;
  std::swap(posture.left_hip_flexion, posture.right_hip_flexion);
  std::swap(posture.left_knee_flexion, posture.right_knee_flexion);
  return posture;
}

/// For each vertex of the model's skin the one at (−x, y, z) of a person at rest; −1 for none.
inline const std::vector<int>& mirror_twins() {
  static const std::vector<int> kTwins = [] {
    constexpr double kCell = 1e-7;  // [m]
    using Cell = std::array<long, 3>;
    const auto cell = [](const Vec3& p) {
      return Cell{std::lround(p.x() / kCell), std::lround(p.y() / kCell),
                  std::lround(p.z() / kCell)};
    };
    const std::vector<Vec3> rest = body_model().rest({}).surface.vertices;
    std::map<Cell, int> place;
    for (std::size_t v = 0; v < rest.size(); ++v) place[cell(rest[v])] = static_cast<int>(v);
    std::vector<int> twins(rest.size(), -1);
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const Cell c = cell(in_the_mirror(rest[v]));
      for (int k = 0; k < 27; ++k) {  // rounding may lead into the next cell
        const auto found = place.find({c[0] + k % 3 - 1, c[1] + k / 3 % 3 - 1, c[2] + k / 9 - 1});
        if (found != place.end()) twins[v] = found->second;
      }
    }
    return twins;
  }();
  return kTwins;
}

/// Largest distance of the skin of one body from that of the other in the mirror [m].
inline double lopsidedness(const body::Body& one, const body::Body& other) {
  double worst = 0;
  for (std::size_t v = 0; v < one.surface.vertices.size(); ++v) {
    const int twin = mirror_twins()[v];
    if (twin < 0) return INFINITY;
    const Vec3& p = other.surface.vertices[static_cast<std::size_t>(twin)];
    worst = std::max(worst, (one.surface.vertices[v] - in_the_mirror(p)).norm());
  }
  return worst;
}

}  // namespace loosefit
