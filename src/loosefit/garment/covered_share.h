#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::garment {

/// All points of a panel that lie no farther than half of `width` from a path [m]. Keeps a
/// reference to the path.
class PathStrip {
 public:
  PathStrip(const std::vector<Vec2>& path, double width) : path_(path), half_(width / 2) {}
  /// Looks ahead at the box of one triangle: false if it lies outside. To be asked before `covers`
  /// is asked for points of that box.
  bool may_cover(const Vec2& low, const Vec2& high);
  bool covers(const Vec2& p) const;

 private:
  const std::vector<Vec2>& path_;
  double half_;
  std::vector<std::size_t> near_;  ///< segments near the box of the last may_cover
};

/// Share of a triangle within a shape, by equal sub-triangles.
template <class Shape>
double covered_share(const std::array<Vec2, 3>& uv, const Shape& shape) {
  constexpr int kSamples = 8;  // per direction
  int hits = 0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples - i; ++j)
      for (const double third : {1.0 / 3, 2.0 / 3}) {
        if (third > 0.5 && i + j == kSamples - 1) continue;
        const double a = (i + third) / kSamples, b = (j + third) / kSamples;
        hits += shape.covers(uv[0] + a * (uv[1] - uv[0]) + b * (uv[2] - uv[0]));
      }
  return double(hits) / (kSamples * kSamples);
}

}  // namespace loosefit::garment
