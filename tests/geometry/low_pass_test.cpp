#include "loosefit/geometry/low_pass.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::geometry {
namespace {

/// A flat square sheet of 1 m, 5 mm between its vertices in x and 10 mm in y.
TriangleMesh sheet() {
  TriangleMesh mesh;
  const int columns = 200, rows = 100;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.vertices.emplace_back(0.005 * i, 0.01 * j, 0);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  return mesh;
}

TEST(LowPass, KeepsOfAWaveWhatTheFormulaSays) {
  const TriangleMesh mesh = sheet();
  const double spread = 0.03;
  for (const double length : {0.04, 0.1, 0.12, 0.2, 0.5}) {
    const double k = 2 * kPi / length;
    std::vector<Vec3> wave;
    for (const Vec3& p : mesh.vertices) wave.emplace_back(0, 0, std::cos(k * p.x()));
    const std::vector<Vec3> smooth =
        low_passed(wave, mesh, std::vector<double>(wave.size(), spread));
    const double s = std::pow(1 + 0.5 * k * k * spread * spread, -2);
    // In the middle of the sheet, away from its borders.
    double product = 0, square = 0;
    for (std::size_t v = 0; v < wave.size(); ++v)
      if (std::abs(mesh.vertices[v].x() - 0.5) < 0.2) {
        product += wave[v].z() * smooth[v].z();
        square += wave[v].z() * wave[v].z();
      }
    EXPECT_NEAR(product / square, 1 - std::pow(1 - s, 3), 0.02) << length;
  }
}

TEST(LowPass, HoldsVerticesWithoutSpreadAndKeepsWhatIsEven) {
  const TriangleMesh mesh = sheet();
  std::vector<Vec3> values(mesh.vertices.size(), Vec3(1, 2, 3));
  std::vector<double> spreads(values.size(), 0.03);
  for (const Vec3& p : low_passed(values, mesh, spreads)) EXPECT_TRUE(p.isApprox(Vec3(1, 2, 3)));
  const std::size_t held = 50 * 201 + 100;
  spreads[held] = 0;
  values[held] = Vec3(7, 7, 7);
  EXPECT_EQ(low_passed(values, mesh, spreads)[held], Vec3(7, 7, 7));
  std::ranges::fill(spreads, 0.0);
  EXPECT_EQ(low_passed(values, mesh, spreads), values);
}

}  // namespace
}  // namespace loosefit::geometry
