#include "loosefit/flesh/skin_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/law_checker.h"

namespace loosefit::flesh {
namespace {

constexpr double kTension = 40, kStiffness = 25;  // [N/m]

/// Grid of unit squares cut in two.
std::vector<Triangle> grid(int columns, int rows) {
  std::vector<Triangle> triangles;
  const auto id = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return triangles;
}

TEST(SkinSprings, ForceIsTheDerivativeOfTheEnergy) {
  SkinSprings springs(grid(2, 1), {1, 2, 3, 4, 5, 6}, kTension);
  particles::VectorField target, x;
  for (int i = 0; i < 6; ++i) {
    target.push_back(Vec3(i % 3, i / 3, 0.1 * i));
    x.push_back(target.back() + 0.1 * Vec3(std::sin(i), std::cos(3 * i), std::sin(2 * i)));
  }
  springs.set_target(target);
  support::expect_derivatives(springs, x);
}

// A front of displacement that runs along x: k u = 2 t Δu, for the edges along x and the diagonals.
TEST(SkinSprings, DisplacementsDieOutAsInAStringOnAFoundation) {
  constexpr int kColumns = 8, kRows = 4;
  constexpr int kVertices = (kColumns + 1) * (kRows + 1);
  SkinSprings springs(grid(kColumns, kRows), std::vector<double>(kVertices, kStiffness), kTension);
  const double c = 1 + kStiffness / (4 * kTension);  // λ + 1/λ = 2 c
  const double decay = c - std::sqrt(c * c - 1);
  particles::VectorField target(kVertices, Vec3(1, 2, 3)), x = target, g(kVertices, Vec3::Zero());
  for (int v = 0; v < kVertices; ++v) x[v][2] += std::pow(decay, v % (kColumns + 1));
  springs.set_target(target);
  springs.add_gradient(x, g);
  for (int j = 1; j < kRows; ++j)
    for (int i = 1; i < kColumns; ++i) EXPECT_LT(g[j * (kColumns + 1) + i].norm(), 1e-11);
}

}  // namespace
}  // namespace loosefit::flesh
