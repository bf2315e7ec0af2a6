#include "loosefit/garment/covered_share.h"

namespace loosefit::garment {

bool PathStrip::may_cover(const Vec2& low, const Vec2& high) {
  const Vec2 half = Vec2::Constant(half_);
  near_.clear();
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    const Vec2 &a = path_[i], &b = path_[i + 1];
    if ((a.cwiseMin(b) - half - high).maxCoeff() <= 0 &&
        (low - a.cwiseMax(b) - half).maxCoeff() <= 0)
      near_.push_back(i);
  }
  return !near_.empty();
}

bool PathStrip::covers(const Vec2& p) const {
  return std::any_of(near_.begin(), near_.end(), [&](std::size_t i) {
    const Vec2 along = path_[i + 1] - path_[i];
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((p - path_[i]).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (path_[i] + t * along - p).norm() <= half_;
  });
}

}  // namespace loosefit::garment
