#include "loosefit/solver/tangent_matrix.h"

namespace loosefit::solver {

std::vector<TangentMatrix::Stand> TangentMatrix::stands() const {
  std::vector<Stand> all(system_.particles());
  for (int i = 0; i < system_.particles(); ++i) all[i].particle[0] = i;
  for (const Plate& plate : system_.plates)
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      const Vec3& w = plate.weights[f];
      all[plate.followers[f]] = {3, plate.leaders, {w[0], w[1], w[2]}};
    }
  return all;
}

void TangentMatrix::follow_pattern(const particles::VectorField& x) {
  const std::uint64_t version = system_.pattern_version(x);
  if (matrix_.particles() == system_.particles() && version == pattern_version_) return;
  particles::BlockPattern pattern(system_.particles());
  for (const particles::Energy* e : system_.energies) e->add_pattern(x, pattern);
  pattern.compress();
  if (!system_.plates.empty()) {
    const std::vector<Stand> stand = stands();
    const std::vector<std::vector<int>> rows = pattern.rows_of_column();
    for (int j = 0; j < system_.particles(); ++j)
      for (int i : rows[j]) {
        if (stand[i].count + stand[j].count == 2) continue;
        for (int a = 0; a < stand[i].count; ++a)
          for (int b = 0; b < stand[j].count; ++b)
            pattern.add(stand[i].particle[a], stand[j].particle[b]);
      }
    pattern.compress();
  }
  if (!matrix_.same_pattern(pattern)) {
    matrix_ = particles::BlockMatrix(pattern);
    of_followers_.clear();
    if (!system_.plates.empty()) {
      const std::vector<Stand> stand = stands();
      for (int j = 0; j < matrix_.particles(); ++j)
        for (int k = matrix_.column_start()[j]; k < matrix_.column_start()[j + 1]; ++k)
          if (const int i = matrix_.rows()[k]; stand[i].count + stand[j].count > 2)
            of_followers_.push_back({k, i, j});
    }
  }
  pattern_version_ = version;
}

void TangentMatrix::gather_blocks() {
  if (of_followers_.empty()) return;
  const std::vector<Stand> stand = stands();
  for (const auto& [place, row, column] : of_followers_) {
    const Mat3 block = matrix_.blocks()[place];
    matrix_.block(place).setZero();
    const Stand &r = stand[row], &c = stand[column];
    for (int a = 0; a < r.count; ++a)
      for (int b = 0; b < c.count; ++b) {
        const int i = r.particle[a], j = c.particle[b];
        const Mat3 part = r.weight[a] * c.weight[b] * block;
        // `add` puts a block and its transpose; a diagonal block of the whole has both in itself.
        if (i != j) {
          if (row != column || i > j) matrix_.add(i, j, part);
        } else {
          matrix_.add(i, i, row == column ? part : Mat3(part + part.transpose()));
        }
      }
  }
}

void TangentMatrix::assemble(const particles::VectorField& x, particles::HessianKind kind) {
  follow_pattern(x);
  matrix_.set_zero();
  for (const particles::Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
  gather_blocks();
}

void TangentMatrix::assemble(const particles::VectorField& x, particles::HessianKind kind,
                             const particles::ActiveSet& active_set) {
  follow_pattern(x);
  for (int i : active_set.particles) matrix_.set_zero(i);
  for (const particles::Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
}

}  // namespace loosefit::solver
