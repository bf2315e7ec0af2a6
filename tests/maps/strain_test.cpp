#include "loosefit/maps/strain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "loosefit/maps/catalogue.h"
#include "loosefit/maps/vertex_reader.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

/// The flat panel of a tube laid out, its seam open: one vertex per corner of every triangle.
garment::Garment loose_triangles() {
  garment::Garment g = testing::tube_garment(0.4, 0.3, 10, 8);
  g.vertex_count = 0;
  g.vertex_uv.clear();
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      g.triangles[t][k] = g.vertex_count++;
      g.vertex_uv.push_back(g.triangle_uv[t][k]);
    }
  g.vertex_panel.assign(g.vertex_count, 0);
  return g;
}

std::vector<Vec3> mapped(const garment::Garment& g, const Eigen::Matrix<double, 3, 2>& gradient) {
  std::vector<Vec3> positions;
  for (const Vec2& uv : g.vertex_uv) positions.push_back(gradient * uv + Vec3(0.1, -0.2, 1.3));
  return positions;
}

TEST(Strain, RigidMotionGivesZero) {
  const garment::Garment g = loose_triangles();
  Eigen::Matrix<double, 3, 2> flat = Eigen::Matrix<double, 3, 2>::Zero();
  flat(0, 0) = flat(2, 1) = 1;
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  const auto positions = mapped(g, turn * flat);
  for (const TriangleStrain& s : triangle_strains(g, positions))
    for (double value : {s.warp, s.weft, s.max, s.min}) EXPECT_NEAR(value, 0, 1e-12);
  for (double value : vertical_strain(g, positions)) EXPECT_NEAR(value, 0, 1e-12);
}

TEST(Strain, HomogeneousStretchAndShearAreExact) {
  const garment::Garment g = loose_triangles();
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << 1.20, 0.30,  //
      0.00, 0.95,          //
      0.10, -0.20;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> svd(gradient);
  for (const TriangleStrain& s : triangle_strains(g, mapped(g, gradient))) {
    EXPECT_NEAR(s.weft, gradient.col(0).norm() - 1, 1e-12);
    EXPECT_NEAR(s.warp, gradient.col(1).norm() - 1, 1e-12);
    EXPECT_NEAR(s.max, svd.singularValues()[0] - 1, 1e-12);
    EXPECT_NEAR(s.min, svd.singularValues()[1] - 1, 1e-12);
  }
}

TEST(Strain, SimpleShearHasItsKnownPrincipalStretches) {
  const garment::Garment g = loose_triangles();
  const double gamma = 0.4;  // stretches (√(γ²+4) ± γ)/2
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << 1, gamma, 0, 1, 0, 0;
  for (const TriangleStrain& s : triangle_strains(g, mapped(g, gradient))) {
    EXPECT_NEAR(s.max, 0.5 * (std::sqrt(gamma * gamma + 4) + gamma) - 1, 1e-12);
    EXPECT_NEAR(s.min, 0.5 * (std::sqrt(gamma * gamma + 4) - gamma) - 1, 1e-12);
  }
}

TEST(Strain, VerticalStrainWeighsEdgesByTheGrain) {
  const garment::Garment g = loose_triangles();
  // Warp stretched by λ: an edge at angle a to the grain grows by √(λ²cos²a + sin²a) − 1.
  const double lambda = 1.3;
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << 1, 0, 0, 0, 0, lambda;
  const double w = 0.04, h = 0.3 / 8;  // legs of the right-angled triangles
  const double cos2 = h * h / (w * w + h * h);
  const double upright = lambda - 1;
  const double slant = std::sqrt(lambda * lambda * cos2 + (1 - cos2)) - 1;
  const auto strain = vertical_strain(g, mapped(g, gradient));
  // The second corner of the lower triangle meets the upright and the level edge.
  EXPECT_NEAR(strain[1], upright, 1e-12);
  // The third corner meets the upright edge (weight 1) and the slanted one (weight cos²).
  EXPECT_NEAR(strain[2], (upright + cos2 * slant) / (1 + cos2), 1e-12);
}

TEST(Strain, EvenStretchIsExactOnEdgesToo) {
  const garment::Garment g = loose_triangles();
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << 1.07, 0, 0, 0, 0, 1.07;
  for (double value : vertical_strain(g, mapped(g, gradient))) EXPECT_NEAR(value, 0.07, 1e-12);
}

TEST(Strain, SeamEdgesAreLeftOut) {
  // Two triangles of two panels share an edge that is longer in one of them.
  garment::Garment g;
  g.vertex_count = 4;
  g.panel_names = {"a", "b"};
  g.triangles = {{0, 1, 2}, {0, 2, 3}};
  g.triangle_panel = {0, 1};
  g.triangle_uv = {{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {Vec2(0, 0), Vec2(0, 1.1), Vec2(-1, 0)}};
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 5}, {-1, 0, 0}};
  const auto strain = vertical_strain(g, positions);
  EXPECT_TRUE(std::isnan(strain[0]));  // left with level edges only
  EXPECT_NEAR(strain[1], std::sqrt(26.0) / std::sqrt(2.0) - 1, 1e-12);
}

TEST(Strain, AFlatlessTriangleHasNone) {
  garment::Garment g;
  g.vertex_count = 3;
  g.panel_names = {"a"};
  g.triangles = {{0, 1, 2}};
  g.triangle_panel = {0};
  g.triangle_uv = {{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0)}};
  const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const double value = triangle_strains(g, positions)[0].max;
  EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(std::isnan(to_vertices(g, {value})[0]));
}

TEST(Strain, AreasSumToTheCloth) {
  const garment::Garment g = testing::tube_garment(0.8, 0.6, 30, 20);
  double sum = 0;
  for (double a : vertex_areas(g)) sum += a;
  EXPECT_NEAR(sum, 0.48, 1e-12);
}

TEST(Strain, AlongADirectionIsThatOfTheStretchedPatch) {
  const garment::Garment g = loose_triangles();
  Eigen::Matrix<double, 3, 2> gradient = Eigen::Matrix<double, 3, 2>::Zero();
  gradient(0, 0) = 1.10;  // weft
  gradient(2, 1) = 0.96;  // warp
  const auto positions = mapped(g, gradient);
  for (const double angle : {0.0, 30.0, 45.0, 90.0, 120.0}) {
    const Vec2 d(std::cos(radians(angle)), std::sin(radians(angle)));
    const double expected = std::hypot(1.10 * d.x(), 0.96 * d.y()) - 1;
    for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t)
      EXPECT_NEAR(strain_along(garment_gradient(g, t, positions), d), expected, 1e-12);
  }
}

TEST(Strain, SlackIsTheShareOfBuckledCloth) {
  garment::Garment g = loose_triangles();
  // The upper half shortened by 0.6 % along the warp, the lower by 0.4 %.
  std::vector<Vec3> positions(g.vertex_count);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    double height = 0;
    for (const Vec2& uv : g.triangle_uv[t]) height += uv.y() / 3;
    for (int k = 0; k < 3; ++k) {
      const Vec2& uv = g.triangle_uv[t][k];
      positions[g.triangles[t][k]] = Vec3(uv.x(), 0, (height > 0.15 ? 0.994 : 0.996) * uv.y());
    }
  }
  const auto slack_share = [&] {
    const WornGarment worn;
    const fabric::Material cloth;
    const MapInput input{g, positions, worn, &cloth};
    VertexReader reader(input);
    return reader.values(*find_map_array("slack"));
  };
  const std::vector<double> slack = slack_share();
  for (int v = 0; v < g.vertex_count; ++v) {
    double height = 0;
    for (const Vec2& uv : g.triangle_uv[v / 3]) height += uv.y() / 3;
    EXPECT_EQ(slack[v], height > 0.15 ? 1 : 0);
  }
  g.triangle_uv[0] = {Vec2(0, 0), Vec2(1, 0), Vec2(2, 0)};  // no area: no strain, no verdict
  EXPECT_TRUE(std::isnan(strain_along(garment_gradient(g, 0, positions), Vec2(0, 1))));
}

}  // namespace
}  // namespace loosefit::maps
