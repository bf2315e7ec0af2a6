#pragma once
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::drape {

/// A line through joints, continued straight at both ends, by the way along it from the first.
class Polyline {
 public:
  explicit Polyline(std::vector<Vec3> points) : points_(std::move(points)) {}
  struct Place {
    Vec3 point, tangent;
  };
  Place at(double s) const {
    std::size_t i = 0;
    double length = (points_[1] - points_[0]).norm();
    while (i + 2 < points_.size() && s > length) {
      s -= length, ++i;
      length = (points_[i + 1] - points_[i]).norm();
    }
    const Vec3 tangent = (points_[i + 1] - points_[i]) / length;
    return {points_[i] + s * tangent, tangent};
  }
  /// Way to the point of the line, continued straight at both ends, that is next to p.
  double project(const Vec3& p) const {
    double best = 0, least = std::numeric_limits<double>::infinity(), before = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec3 way = points_[i + 1] - points_[i];
      const double length = way.norm();
      double s = (p - points_[i]).dot(way) / length;
      if (i > 0) s = std::max(s, 0.0);
      if (i + 2 < points_.size()) s = std::min(s, length);
      const double far = (points_[i] + s / length * way - p).squaredNorm();
      if (far < least) least = far, best = before + s;
      before += length;
    }
    return best;
  }
  /// Way along the first piece, however far, that is next to p.
  double project_on_first(const Vec3& p) const {
    return (p - points_[0]).dot((points_[1] - points_[0]).normalized());
  }

 private:
  std::vector<Vec3> points_;
};

}  // namespace loosefit::drape
