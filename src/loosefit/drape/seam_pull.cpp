#include "loosefit/drape/seam_pull.h"

#include <algorithm>
#include <cmath>

namespace loosefit::drape {

SeamPull::SeamPull(const std::vector<std::vector<int>>& partners, double stiffness, double reach)
    : reach_(reach) {
  for (const std::vector<int>& of : partners)
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        threads_.push_back({of[i], of[j], stiffness / static_cast<double>(of.size() - 1)});
}

double SeamPull::value(const particles::VectorField& x) const {
  double sum = 0;
  for (const Thread& t : threads_) {
    // √(1 + q) − 1 without cancellation.
    const double q = (x[t.a] - x[t.b]).squaredNorm() / (reach_ * reach_);
    sum += t.stiffness * reach_ * reach_ * q / (std::sqrt(1 + q) + 1);
  }
  return sum;
}

void SeamPull::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  for (const Thread& t : threads_) {
    const Vec3 d = x[t.a] - x[t.b];
    const Vec3 f = t.stiffness / std::sqrt(1 + d.squaredNorm() / (reach_ * reach_)) * d;
    g[t.a] += f;
    g[t.b] -= f;
  }
}

void SeamPull::add_pattern(const particles::VectorField&, particles::BlockPattern& pattern) const {
  for (const Thread& t : threads_) pattern.add(t.a, t.b);
}

void SeamPull::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                           particles::HessianKind) const {
  for (const Thread& t : threads_) {
    const Vec3 d = x[t.a] - x[t.b];
    const double root = std::sqrt(1 + d.squaredNorm() / (reach_ * reach_));
    const Mat3 block = t.stiffness / root *
                       (Mat3::Identity() - d * d.transpose() / (reach_ * reach_ * root * root));
    h.add(t.a, t.a, block);
    h.add(t.b, t.b, block);
    h.add(t.a, t.b, -block);
  }
}

double widest_gap(const std::vector<std::vector<int>>& partners, const std::vector<Vec3>& x) {
  double widest = 0;
  for (const std::vector<int>& of : partners)
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) widest = std::max(widest, (x[of[i]] - x[of[j]]).norm());
  return widest;
}

}  // namespace loosefit::drape
