#pragma once
#include <Eigen/Core>
#include <random>
#include <vector>

#include "loosefit/particles/block_matrix.h"

namespace loosefit::support {

/// Random symmetric blocks, the diagonal ones larger by `diagonal`.
inline particles::BlockMatrix filled(particles::BlockPattern pattern, double diagonal,
                                     unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  pattern.compress();
  particles::BlockMatrix m(pattern);
  for (int j = 0; j < m.particles(); ++j)
    for (int i : pattern.rows_of_column()[j]) {
      Mat3 block;
      for (int k = 0; k < 9; ++k) block(k / 3, k % 3) = u(rng);
      if (i == j) block = (block + block.transpose() + diagonal * Mat3::Identity()).eval();
      m.add(i, j, block);
    }
  return m;
}

/// A chain with some far couplings.
inline particles::BlockMatrix random_matrix(int n, double diagonal, unsigned seed) {
  particles::BlockPattern pattern(n);
  for (int i = 1; i < n; ++i) pattern.add(i, i - 1);
  for (int i = 0; i < n; i += 3) pattern.add(i, (7 * i + 5) % n);
  return filled(std::move(pattern), diagonal, seed);
}

inline std::vector<Vec3> random_field(int n) {
  std::mt19937 rng(9);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> f(n);
  for (Vec3& v : f) v = Vec3(u(rng), u(rng), u(rng));
  return f;
}

inline Eigen::VectorXd flat(const std::vector<Vec3>& f) {
  Eigen::VectorXd v(3 * static_cast<long>(f.size()));
  for (std::size_t i = 0; i < f.size(); ++i) v.segment<3>(3 * static_cast<long>(i)) = f[i];
  return v;
}

/// Two cliques and a third that both of them touch: fronts that are shared out in blocks, and pass
/// their borders on.
inline particles::BlockMatrix cliques(double diagonal, unsigned seed) {
  constexpr int kClique = 110, kShared = 50;
  particles::BlockPattern pattern(2 * kClique + kShared);
  for (int first : {0, kClique}) {
    std::vector<int> clique;
    for (int i = 0; i < kClique; ++i) clique.push_back(first + i);
    for (int i = 0; i < kShared; ++i) clique.push_back(2 * kClique + i);
    for (int a : clique)
      for (int b : clique)
        if (b < a) pattern.add(a, b);
  }
  return filled(std::move(pattern), diagonal, seed);
}

/// A sheet of n x n particles, each coupled to its eight neighbours and the next but one, as the
/// Hessian of a cloth is.
inline particles::BlockMatrix sheet(int n, double diagonal, unsigned seed) {
  particles::BlockPattern pattern(n * n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      for (int dy = 0; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
          if (y + dy < n && x + dx >= 0 && x + dx < n && (dy > 0 || dx > 0))
            pattern.add((y + dy) * n + x + dx, y * n + x);
  return filled(std::move(pattern), diagonal, seed);
}

}  // namespace loosefit::support
