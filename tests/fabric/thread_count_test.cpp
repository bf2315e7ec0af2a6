#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "support/flat_garment.h"
#include "support/law_checker.h"

namespace loosefit::fabric {
namespace {

struct Answer {
  double value;
  particles::VectorField gradient;
  std::vector<Mat3> blocks;
};

Answer ask(const particles::Energy& energy, const particles::VectorField& x,
           particles::HessianKind kind) {
  Answer a;
  a.gradient.assign(x.size(), Vec3::Zero());
  a.value = energy.value_and_gradient(x, a.gradient);
  EXPECT_EQ(a.value, energy.value(x));
  particles::BlockPattern pattern(static_cast<int>(x.size()));
  energy.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  energy.add_hessian(x, h, kind);
  a.blocks = h.blocks();
  return a;
}

void expect_same_bits(const particles::Energy& energy, const particles::VectorField& x,
                      particles::HessianKind kind) {
  const Answer many = ask(energy, x, kind);
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  const Answer one = ask(energy, x, kind);
  EXPECT_EQ(many.value, one.value);
  EXPECT_EQ(many.gradient, one.gradient);
  EXPECT_EQ(many.blocks, one.blocks);
}

TEST(FabricEnergies, GiveTheSameBitsWithOneThread) {
  const geometry::TriangleMesh mesh = support::sheet(0.4, 0.4, 0.01, 0.2);
  ASSERT_GT(mesh.triangles.size(), 2048u);  // enough for several parts
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x) p[2] += 0.01 * std::sin(90 * p[0]) * std::cos(70 * p[1]);
  Material m;
  m.bending_hysteresis_warp = m.bending_hysteresis_weft = 1e-4;
  const auto uv = support::flat_uv(mesh);
  MembraneEnergy membrane(mesh.triangles, uv, {}, m, true);
  BendingEnergy bending(mesh.triangles, uv, {}, m, true);
  membrane.begin_step(mesh.vertices, 0.01);
  bending.begin_step(mesh.vertices, 0.01);
  for (particles::HessianKind kind :
       {particles::HessianKind::exact, particles::HessianKind::projected}) {
    expect_same_bits(membrane, x, kind);
    for (particles::BendingTangent tangent :
         {particles::BendingTangent::plate, particles::BendingTangent::hinge}) {
      bending.set_tangent(tangent);
      expect_same_bits(bending, x, kind);
    }
  }
}

}  // namespace
}  // namespace loosefit::fabric
