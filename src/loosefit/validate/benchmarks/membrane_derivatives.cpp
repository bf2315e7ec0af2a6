#include <fmt/format.h>

#include <cmath>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/io/material_file.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/membrane_specimen.h"

// M2: force = −∂E/∂x and stiffness = ∂²E/∂x² by finite differences (docs/theory/validation.md 1.1).
namespace loosefit::validate {
namespace {

constexpr double kEdge = 0.01, kStep = 1e-8;  // [m]

struct Errors {
  double gradient = 0, hessian = 0;  // relative to the largest entry
};

particles::VectorField gradient(const particles::Energy& energy, const particles::VectorField& x) {
  particles::VectorField g(x.size(), Vec3::Zero());
  energy.add_gradient(x, g);
  return g;
}

Errors derivative_errors(const particles::Energy& energy, const particles::VectorField& x) {
  particles::BlockPattern pattern(static_cast<int>(x.size()));
  energy.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  energy.add_hessian(x, h, particles::HessianKind::exact);
  const particles::VectorField g = gradient(energy, x);
  double g_scale = 0, h_scale = 0;
  for (const Vec3& f : g) g_scale = std::max(g_scale, f.cwiseAbs().maxCoeff());
  for (const Mat3& b : h.blocks()) h_scale = std::max(h_scale, b.cwiseAbs().maxCoeff());

  Errors worst;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      particles::VectorField ahead = x, behind = x;
      ahead[i][c] += kStep;
      behind[i][c] -= kStep;
      const double step = ahead[i][c] - behind[i][c];
      const double slope = (energy.value(ahead) - energy.value(behind)) / step;
      worst.gradient = std::max(worst.gradient, std::abs(slope - g[i][c]) / g_scale);
      const particles::VectorField ga = gradient(energy, ahead), gb = gradient(energy, behind);
      particles::VectorField unit(x.size(), Vec3::Zero()), column = unit;
      unit[i][c] = 1;
      h.add_product(unit, column);
      for (std::size_t j = 0; j < x.size(); ++j) {
        const Vec3 rate = (ga[j] - gb[j]) / step;
        worst.hessian = std::max(worst.hessian, (rate - column[j]).cwiseAbs().maxCoeff() / h_scale);
      }
    }
  return worst;
}

// Stretched, sheared and crumpled.
particles::VectorField crumpled(const std::vector<Vec2>& flat) {
  particles::VectorField x;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const double n = static_cast<double>(i), a = 1.7 * n, b = 2.9 * n + 1;
    x.emplace_back(1.2 * flat[i][0] + 0.1 * flat[i][1] + 0.001 * std::sin(a),
                   0.9 * flat[i][1] + 0.001 * std::sin(b), 0.002 * std::sin(a * b));
  }
  return x;
}

void tell(const std::string& name, const particles::Energy& energy, const Specimen& specimen,
          BenchmarkResult& result) {
  const Errors errors = derivative_errors(energy, crumpled(specimen.vertex_uv));
  for (const auto& [what, error] : {std::pair("force against energy", errors.gradient),
                                    std::pair("stiffness against force", errors.hessian)}) {
    Finding f;
    f.what = name + ": " + what;
    f.obtained = error;
    f.gate = Finding::Gate::absolute;
    f.limit = 1e-6;
    f.mesh = mesh_text(specimen);
    result.findings.push_back(f);
  }
}

}  // namespace

BenchmarkResult benchmark_derivatives(Effort, Progress& progress) {
  BenchmarkResult result;
  Specimen patch = cut_rectangle(0.04, 0.05, kEdge, fabric::Material{});
  roughen(patch, kEdge);
  fabric::Material limp = orthotropic_fabric(), bent = orthotropic_fabric();
  limp.bending_warp = limp.bending_weft = 1e-7;
  bent.bending_warp = 1e-5;
  bent.bending_weft = 4e-6;
  bent.bending_poisson = 0.3;
  const std::pair<const char*, fabric::Material> membranes[] = {
      {"St. Venant-Kirchhoff", orthotropic_fabric()},
      {"limp, which buckles at once", limp},
      {"measured wool", io::load_material("wool-measured").material}};
  for (const auto& [name, material] : membranes)
    for (bool viscous : {false, true}) {
      fabric::MembraneEnergy energy(patch.triangles, patch.triangle_uv, {}, material, viscous);
      particles::VectorField start;
      for (const Vec2& p : patch.vertex_uv) start.emplace_back(p[0], p[1], 0);
      energy.begin_step(start, 0.01);
      tell(fmt::format("membrane, {}{}", name, viscous ? ", viscous" : ""), energy, patch, result);
      progress.check_cancelled();
    }
  progress.update(0.7, "membrane");
  const fabric::BendingEnergy bending(patch.triangles, patch.triangle_uv, {}, bent);
  tell("bending, B_warp 1e-5, B_weft 4e-6 N m, ν 0.3", bending, patch, result);
  result.notes.push_back(fmt::format(
      "Central differences with a step of {:g} m, each coordinate of a crumpled patch; errors are "
      "relative to the largest entry.",
      kStep));
  return result;
}

}  // namespace loosefit::validate
