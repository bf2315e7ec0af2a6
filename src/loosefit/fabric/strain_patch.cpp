#include "loosefit/fabric/strain_patch.h"

#include <algorithm>

#include "loosefit/base/union_find.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/particles/tile.h"

namespace loosefit::fabric {
namespace {

/// Whether two triangles at an edge see it as the same vector of the flat pattern.
bool same_piece(const std::vector<std::array<Vec2, 3>>& uv, const geometry::MeshTopology::Side& a,
                const geometry::MeshTopology::Side& b) {
  const Vec2 first = uv[a.triangle][(a.corner + 1) % 3] - uv[a.triangle][a.corner];
  const Vec2 second = uv[b.triangle][b.corner] - uv[b.triangle][(b.corner + 1) % 3];
  constexpr double kSameEdge = 1e-9;  // of its length
  return (first - second).norm() <= kSameEdge * first.norm();
}

std::vector<std::array<int, 2>> pairs_of(const std::vector<StrainPatch>& patches, int each) {
  std::vector<std::array<int, 2>> pairs(patches.size() * each, {-1, -1});
  for (std::size_t t = 0; t < patches.size(); ++t) {
    const StrainPatch& p = patches[t];
    for (int a = 0; a < p.particles; ++a)
      for (int b = 0; b <= a; ++b)
        pairs[t * each + a * (a + 1) / 2 + b] = {p.particle[a], p.particle[b]};
  }
  return pairs;
}

}  // namespace

StrainPatches strain_patches(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const std::vector<double>& factor, const std::vector<double>& weight) {
  const geometry::MeshTopology topology(triangles);
  const int count = static_cast<int>(triangles.size());
  UnionFind corners(3 * count);
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    if (sides.size() != 2) continue;
    const auto &a = sides[0], &b = sides[1];
    if (triangles[a.triangle][a.corner] != triangles[b.triangle][(b.corner + 1) % 3] ||
        factor[a.triangle] != factor[b.triangle] || !same_piece(triangle_uv, a, b))
      continue;
    corners.unite(3 * a.triangle + a.corner, 3 * b.triangle + (b.corner + 1) % 3);
    corners.unite(3 * a.triangle + (a.corner + 1) % 3, 3 * b.triangle + b.corner);
  }
  // In the order of their first triangles, so that a patch is near these in memory, too.
  StrainPatches result;
  std::vector<int> number(3 * count, -1);
  std::vector<std::vector<int>> members;
  result.at_corner.assign(count, {-1, -1, -1});
  for (int t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) {
      int& of = number[corners.find(3 * t + k)];
      if (of < 0) {
        of = static_cast<int>(members.size());
        members.emplace_back();
      }
      members[of].push_back(3 * t + k);
    }
  for (const std::vector<int>& group : members) {
    StrainPatch patch;
    std::vector<int> particles;
    for (int corner : group)
      for (int v : triangles[corner / 3]) particles.push_back(v);
    std::sort(particles.begin(), particles.end());
    particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
    if (particles.size() > StrainPatch::kMost) continue;
    patch.particles = static_cast<int>(particles.size());
    std::copy(particles.begin(), particles.end(), patch.particle.begin());
    patch.first = static_cast<int>(result.triangle.size());
    patch.count = static_cast<int>(group.size());
    for (int corner : group) {
      result.triangle.push_back(corner / 3);
      patch.weight += weight[corner / 3] / 3;
      result.at_corner[corner / 3][corner % 3] = static_cast<int>(result.patches.size());
    }
    result.patches.push_back(patch);
  }
  return result;
}

StrainPatchTangent::StrainPatchTangent(const std::vector<StrainPatch>& patches)
    : products_(patches), factor_(patches.size() * StrainPatch::kMost, Factor{}) {}

void StrainPatchTangent::add(particles::BlockMatrix& h,
                             const particles::ActiveSet* active_set) const {
  products_.add(factor_, h, active_set);
}

StrainPatchTangent::Products::Products(const std::vector<StrainPatch>& patches)
    : particles::BlockGather(pairs_of(patches, kPairs)) {
  std::array<std::array<int, 2>, kPairs> of{};
  for (int a = 0; a < StrainPatch::kMost; ++a)
    for (int b = 0; b <= a; ++b) of[a * (a + 1) / 2 + b] = {a, b};
  factors_.assign(source_.size(), {0, 0});
  for (std::size_t p = 0; p < row_.size(); ++p)
    for (int k = first_[p]; k < first_[p + 1]; ++k) {
      const int base = source_[k] / kPairs * StrainPatch::kMost;
      const auto [a, b] = of[source_[k] % kPairs];
      factors_[k] =
          k < flipped_[p] ? std::array{base + a, base + b} : std::array{base + b, base + a};
    }
  source_.clear();
  source_.shrink_to_fit();
}

void StrainPatchTangent::Products::add_products(int begin, int end,
                                                const std::vector<Factor>& factor,
                                                particles::BlockMatrix& h) const {
  for (int p = begin; p < end; ++p) {
    double sum[9] = {};
    for (int k = first_[p]; k < first_[p + 1]; ++k) {
      const Factor &a = factor[factors_[k][0]], &b = factor[factors_[k][1]];
      for (int q = 0; q < 3; ++q)
        for (int r = 0; r < 3; ++r) sum[3 * q + r] += a[r] * b[6 + q] + a[3 + r] * b[9 + q];
    }
    double* to = h.block(slot_[p]).data();
    for (int c = 0; c < 9; ++c) to[c] += sum[c];
  }
}

void StrainPatchTangent::Products::add(const std::vector<Factor>& factor, particles::BlockMatrix& h,
                                       const particles::ActiveSet* active_set) const {
  find_slots(h);
  if (!active_set) {
    particles::for_ranges(static_cast<int>(row_.size()), 512,
                          [&](int begin, int end) { add_products(begin, end, factor, h); });
    return;
  }
  const int columns = static_cast<int>(column_start_.size()) - 1;
  particles::for_ranges(
      static_cast<int>(active_set->particles.size()), 64, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
          if (const int column = active_set->particles[k]; column < columns)
            add_products(column_start_[column], column_start_[column + 1], factor, h);
      });
}

}  // namespace loosefit::fabric
