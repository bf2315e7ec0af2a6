#include <gtest/gtest.h>

#include "loosefit/contact/body_contact.h"
#include "support/shapes.h"

namespace loosefit::contact {
namespace {

constexpr double kStiffness = 2e7, kOffset = 2.5e-4;

TEST(CompressLayer, PressureIsTheSlopeOfTheEnergyAndStiffnessThatOfThePressure) {
  // Below the onset of hardening, in it, and beyond full compression.
  for (double share : {0.05, 0.3, 0.59, 0.61, 0.8, 0.84, 0.86, 1.5, 3.0}) {
    const double d = share * kOffset, h = 1e-5 * kOffset;
    const LayerResponse r = compress_layer(kStiffness, kOffset, d);
    const LayerResponse up = compress_layer(kStiffness, kOffset, d + h);
    const LayerResponse down = compress_layer(kStiffness, kOffset, d - h);
    EXPECT_NEAR((up.energy - down.energy) / (2 * h), r.pressure, 1e-6 * r.pressure) << share;
    EXPECT_NEAR((up.pressure - down.pressure) / (2 * h), r.stiffness, 1e-6 * r.stiffness) << share;
  }
}

TEST(CompressLayer, HardensMonotonicallyAndContinuously) {
  LayerResponse last = compress_layer(kStiffness, kOffset, 0);
  EXPECT_EQ(last.energy, 0);
  EXPECT_EQ(last.pressure, 0);
  const int n = 4000;
  for (int i = 1; i <= n; ++i) {
    const LayerResponse r = compress_layer(kStiffness, kOffset, 2 * kOffset * i / n);
    EXPECT_GT(r.pressure, last.pressure);
    EXPECT_GE(r.stiffness, last.stiffness * (1 - 1e-12));
    EXPECT_LT(r.stiffness - last.stiffness, 0.02 * r.stiffness);  // no jump
    last = r;
  }
}

TEST(CompressLayer, CarriesTheStatedPressureAtHalfCompressionAndWhereItIsHardest) {
  EXPECT_NEAR(compress_layer(kStiffness, kOffset, 0.5 * kOffset).pressure,
              0.5 * kStiffness * kOffset, 1e-9);
  // 0.85 k o + (20 k / o) (0.25 o)² / 0.375³ where it is hardest
  EXPECT_NEAR(compress_layer(kStiffness, kOffset, 0.85 * kOffset).pressure,
              (0.85 + 1.25 / 0.052734375) * kStiffness * kOffset, 1e-6);
}

TEST(ContactPoints, ShareTheAreaOfTheirTriangles) {
  const geometry::TriangleMesh mesh = support::sheet(0.1, 0.07, 0.015, 0.2);
  std::vector<double> area;
  double total = 0;
  for (const Triangle& t : mesh.triangles) {
    area.push_back(
        geometry::triangle_area(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
    total += area.back();
  }
  const int n = static_cast<int>(mesh.vertices.size());
  const auto points = contact_points(mesh.triangles, area, n, kOffset);
  double sum = 0;
  Vec3 moment = Vec3::Zero(), centroid = Vec3::Zero();
  for (const ContactPoint& p : points) {
    sum += p.area;
    moment += p.area * p.position(mesh.vertices);
    double weights = 0;
    for (int k = 0; k < p.count; ++k) weights += p.weight[k];
    EXPECT_NEAR(weights, 1, 1e-15);
  }
  for (std::size_t t = 0; t < area.size(); ++t)
    for (int v : mesh.triangles[t]) centroid += area[t] / 3 * mesh.vertices[v];
  EXPECT_NEAR(sum, total, 1e-15);
  EXPECT_LT((moment - centroid).norm(), 1e-12);
}

}  // namespace
}  // namespace loosefit::contact
