#include <benchmark/benchmark.h>

#include <cmath>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"

namespace loosefit {
namespace {

/// A wavy sheet with about the particles, triangles and hinges of the reference shirt at 10 mm.
struct Sheet {
  std::vector<Triangle> triangles;
  std::vector<std::array<Vec2, 3>> uv;
  particles::VectorField x;
};

Sheet wavy_sheet() {
  constexpr int kColumns = 91, kRows = 91;
  constexpr double kEdge = 0.01;
  Sheet sheet;
  std::vector<Vec2> flat;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      // Irregular as a mesher's, but the same on every machine.
      const double du = 0.2 * std::sin(12.9 * i + 78.2 * j),
                   dv = 0.2 * std::sin(39.3 * i + 11.1 * j);
      const double u = kEdge * (i + 0.5 * (j % 2) + du), v = kEdge * (0.87 * j + dv);
      flat.emplace_back(u, v);
      sheet.x.emplace_back(1.01 * u, 0.99 * v, 0.02 * std::sin(60 * u) * std::cos(45 * v));
    }
  const auto add = [&](int a, int b, int c) {
    sheet.triangles.push_back({a, b, c});
    sheet.uv.push_back({flat[a], flat[b], flat[c]});
  };
  for (int j = 0; j + 1 < kRows; ++j)
    for (int i = 0; i + 1 < kColumns; ++i) {
      const int a = j * kColumns + i, b = a + 1, c = a + kColumns, d = c + 1;
      add(a, b, j % 2 ? d : c);
      add(j % 2 ? a : b, d, c);
    }
  return sheet;
}

void value_and_gradient(benchmark::State& state, const particles::Energy& energy,
                        const particles::VectorField& x) {
  particles::VectorField g(x.size(), Vec3::Zero());
  for (auto _ : state) benchmark::DoNotOptimize(energy.value_and_gradient(x, g));
}

void value(benchmark::State& state, const particles::Energy& energy,
           const particles::VectorField& x) {
  for (auto _ : state) benchmark::DoNotOptimize(energy.value(x));
}

void hessian(benchmark::State& state, const particles::Energy& energy,
             const particles::VectorField& x, particles::HessianKind kind) {
  particles::BlockPattern pattern(static_cast<int>(x.size()));
  energy.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  for (auto _ : state) {
    energy.add_hessian(x, h, kind);
    benchmark::DoNotOptimize(h.block(0).data());
  }
}

void membrane(benchmark::State& state, int what) {
  const Sheet sheet = wavy_sheet();
  const fabric::MembraneEnergy energy(sheet.triangles, sheet.uv, {}, fabric::Material{});
  if (what == 0) value(state, energy, sheet.x);
  if (what == 1) value_and_gradient(state, energy, sheet.x);
  if (what == 2) hessian(state, energy, sheet.x, particles::HessianKind::projected);
}
BENCHMARK_CAPTURE(membrane, value, 0)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(membrane, value_and_gradient, 1)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(membrane, hessian, 2)->Unit(benchmark::kMicrosecond)->UseRealTime();

void bending(benchmark::State& state, int what, particles::HessianKind kind,
             particles::BendingTangent reach) {
  const Sheet sheet = wavy_sheet();
  fabric::BendingEnergy energy(sheet.triangles, sheet.uv, {}, fabric::Material{});
  energy.set_tangent(reach);
  if (what == 0) value(state, energy, sheet.x);
  if (what == 1) value_and_gradient(state, energy, sheet.x);
  if (what == 2) hessian(state, energy, sheet.x, kind);
}
constexpr auto kExact = particles::HessianKind::exact,
               kDefinite = particles::HessianKind::projected;
constexpr auto kNear = particles::BendingTangent::hinge, kFull = particles::BendingTangent::plate;
BENCHMARK_CAPTURE(bending, value, 0, kExact, kFull)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(bending, value_and_gradient, 1, kExact, kFull)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(bending, hessian_near_exact, 2, kExact, kNear)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(bending, hessian_near_definite, 2, kDefinite, kNear)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(bending, hessian_full_exact, 2, kExact, kFull)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(bending, hessian_full_definite, 2, kDefinite, kFull)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

}  // namespace
}  // namespace loosefit
