#include "loosefit/solver/residual_region.h"

#include <algorithm>
#include <numeric>

#include "loosefit/base/check.h"

namespace loosefit::solver {
namespace {

/// Particles that bear `share` of the sum of squares, the largest first; ties by number. None if
/// that takes more than `most`.
std::vector<int> seeds_of(const particles::VectorField& force, double share, std::size_t most) {
  std::vector<double> square(force.size());
  for (std::size_t i = 0; i < force.size(); ++i) square[i] = force[i].squaredNorm();
  const double all = std::accumulate(square.begin(), square.end(), 0.0);
  if (!(all > 0)) return {};
  std::vector<int> order(force.size());
  std::iota(order.begin(), order.end(), 0);
  const auto end = order.begin() + static_cast<long>(std::min(most, order.size()));
  std::partial_sort(order.begin(), end, order.end(), [&](int a, int b) {
    return square[a] > square[b] || (square[a] == square[b] && a < b);
  });
  double sum = 0;
  for (auto it = order.begin(); it != end; ++it) {
    sum += square[*it];
    if (sum >= share * all) return {order.begin(), it + 1};
  }
  return {};
}

/// Marks the neighbours of what is marked.
void add_ring(const particles::BlockMatrix& matrix, std::vector<char>& inside) {
  const auto &start = matrix.column_start(), &rows = matrix.rows();
  const std::vector<char> before = inside;
  for (int j = 0; j < matrix.particles(); ++j)
    for (int k = start[j]; k < start[j + 1]; ++k) {
      inside[rows[k]] |= before[j];
      inside[j] |= before[rows[k]];
    }
}

}  // namespace

ResidualRegion residual_region(const particles::BlockMatrix& matrix,
                               const particles::VectorField& force, const RegionTuning& tuning,
                               const std::vector<char>& left_out) {
  const auto n = static_cast<double>(force.size());
  std::vector<char> inside(force.size(), 0);
  const auto leave_out = [&](std::vector<char>& of) {
    for (std::size_t i = 0; i < left_out.size(); ++i)
      if (left_out[i]) of[i] = 0;
  };
  const auto seeds =
      seeds_of(force, tuning.force_share, static_cast<std::size_t>(tuning.max_seeds * n));
  for (int i : seeds) inside[i] = 1;
  leave_out(inside);
  for (int ring = 0; ring < tuning.rings && !seeds.empty(); ++ring) {
    std::vector<char> wider = inside;
    add_ring(matrix, wider);
    leave_out(wider);
    if (static_cast<double>(std::count(wider.begin(), wider.end(), 1)) > tuning.max_extent * n)
      break;
    inside.swap(wider);
  }
  ResidualRegion region;
  region.index.assign(force.size(), -1);
  for (std::size_t i = 0; i < force.size(); ++i)
    if (inside[i]) {
      region.index[i] = static_cast<int>(region.particles.size());
      region.particles.push_back(static_cast<int>(i));
    }
  return region;
}

void restrict_to(const ResidualRegion& region, const particles::BlockMatrix& matrix,
                 particles::BlockMatrix& part, RestrictedBlocks& blocks) {
  LOOSEFIT_ASSERT(blocks.of_pattern != matrix.pattern_id() ||
                  (part.particles() == static_cast<int>(region.particles.size()) &&
                   part.blocks().size() == blocks.source.size()));
  if (blocks.of_pattern != matrix.pattern_id()) {
    blocks.of_pattern = matrix.pattern_id();
    blocks.source.clear();
    const auto &start = matrix.column_start(), &rows = matrix.rows();
    std::vector<int> part_start{0}, part_rows;
    // The order of blocks is the same in both, since indices rise with the particles.
    for (int j : region.particles) {
      for (int k = start[j]; k < start[j + 1]; ++k)
        if (const int i = region.index[rows[k]]; i >= 0) {
          part_rows.push_back(i);
          blocks.source.push_back(k);
        }
      part_start.push_back(static_cast<int>(part_rows.size()));
    }
    part = particles::BlockMatrix(std::move(part_start), std::move(part_rows));
  }
  for (std::size_t k = 0; k < blocks.source.size(); ++k)
    part.block(static_cast<int>(k)) = matrix.blocks()[blocks.source[k]];
}

}  // namespace loosefit::solver
