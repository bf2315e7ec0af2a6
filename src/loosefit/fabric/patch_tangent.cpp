#include "loosefit/fabric/patch_tangent.h"

#include <cmath>

#include "loosefit/particles/tile.h"

namespace loosefit::fabric {
namespace {

/// L of K = L Lᵀ for K ⪰ 0, singular ones included.
Mat3 root_of(const Mat3& k) {
  Mat3 l = Mat3::Zero();
  for (int j = 0; j < 3; ++j) {
    double pivot = k(j, j);
    for (int m = 0; m < j; ++m) pivot -= l(j, m) * l(j, m);
    if (!(pivot > 1e-14 * k(j, j))) continue;
    l(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i) {
      double entry = k(i, j);
      for (int m = 0; m < j; ++m) entry -= l(i, m) * l(j, m);
      l(i, j) = entry / l(j, j);
    }
  }
  return l;
}

std::vector<std::array<int, 2>> pairs_of(const std::vector<CurvaturePatch>& patches,
                                         int pairs_per_patch) {
  std::vector<std::array<int, 2>> pairs(patches.size() * pairs_per_patch, {-1, -1});
  for (std::size_t t = 0; t < patches.size(); ++t) {
    const CurvaturePatch& p = patches[t];
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b <= a; ++b)
        pairs[t * pairs_per_patch + a * (a + 1) / 2 + b] = {p.particle[a], p.particle[b]};
  }
  return pairs;
}

}  // namespace

PatchTangent::Products::Products(const std::vector<CurvaturePatch>& patches)
    : particles::BlockGather(pairs_of(patches, kPairs)) {
  std::array<std::array<int, 2>, kPairs> of{};
  for (int a = 0; a < kMost; ++a)
    for (int b = 0; b <= a; ++b) of[a * (a + 1) / 2 + b] = {a, b};
  factors_.assign(source_.size(), {0, 0});
  for (std::size_t p = 0; p < row_.size(); ++p)
    for (int k = first_[p]; k < first_[p + 1]; ++k) {
      const int base = source_[k] / kPairs * kMost;
      const auto [a, b] = of[source_[k] % kPairs];
      factors_[k] =
          k < flipped_[p] ? std::array{base + a, base + b} : std::array{base + b, base + a};
    }
  source_.clear();
  source_.shrink_to_fit();
}

void PatchTangent::Products::add(const std::vector<Factor>& factor,
                                 particles::BlockMatrix& h) const {
  find_slots(h);
  particles::for_ranges(static_cast<int>(row_.size()), 512, [&](int begin, int end) {
    for (int p = begin; p < end; ++p) {
      particles::Quad sum[3] = {};  // columns of Σ aᵀ b
      for (int k = first_[p]; k < first_[p + 1]; ++k) {
        for (int side : factors_[k + kAhead]) {
          __builtin_prefetch(factor[side].data());
          __builtin_prefetch(factor[side].data() + 8);
        }
        // Not auto, which would forget that a Quad may lie anywhere.
        const particles::Quad* a =
            reinterpret_cast<const particles::Quad*>(factor[factors_[k][0]].data());
        const double* b = factor[factors_[k][1]].data();
        for (int q = 0; q < 3; ++q) sum[q] += a[0] * b[q] + a[1] * b[4 + q] + a[2] * b[8 + q];
      }
      double* to = h.block(slot_[p]).data();
      for (int q = 0; q < 3; ++q)
        for (int r = 0; r < 3; ++r) to[3 * q + r] += sum[q][r];
    }
  });
}

PatchTangent::PatchTangent(const std::vector<CurvaturePatch>& patches)
    : products_(patches), factor_(patches.size() * kMost, Factor{}) {}

void PatchTangent::set(std::size_t t, const CurvaturePatch& patch, const Mat3& k,
                       const std::vector<Vec3>& gradient) {
  const Eigen::Matrix<double, 3, 9> s = root_of(k).transpose() * patch.s;
  Factor* factor = factor_.data() + t * kMost;
  for (int a = 0; a < patch.count; ++a) factor[a].fill(0);
  for (int c = 0; c < patch.hinges; ++c) {
    if (patch.hinge[c] < 0) continue;
    for (int point = 0; point < 4; ++point) {
      const Vec3& g = gradient[4 * patch.hinge[c] + point];
      Factor& to = factor[patch.slot[c][point]];
      for (int r = 0; r < 3; ++r)
        for (int d = 0; d < 3; ++d) to[4 * r + d] += s(r, c) * g[d];
    }
  }
}

}  // namespace loosefit::fabric
