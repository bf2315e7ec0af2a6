#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <random>

#include "loosefit/contact/self_contact.h"

namespace loosefit {
namespace {

constexpr double kTurn = 2.1;  ///< steepest angle of the meanders [rad]

/// A sheet of 0.9 m x 0.78 m with as many vertices as the reference shirt at 10 mm, in meanders
/// (sine-generated curves, Langbein and Leopold 1966) whose loops nearly close: where the sheet
/// bends back on itself layers touch, elsewhere they lie up to centimetres apart.
struct WrinkledSheet {
  particles::VectorField x;
  std::vector<Triangle> triangles;
  std::vector<double> areas;
  particles::VectorField direction;  ///< random, smooth over a few edges, longest 1

  explicit WrinkledSheet(double turn = kTurn) {
    constexpr int kColumns = 90, kRows = 90, kParts = 20;
    constexpr double kEdge = 0.01, kFold = 0.18;
    for (int i = 0; i <= kRows; ++i) {
      const double most = turn + 0.01 * std::sin(0.2 * i);
      Vec3 p(0, kEdge * std::sqrt(0.75) * i, 0);
      for (int k = 0; k <= kParts * kColumns; ++k) {
        if (k % kParts == 0) x.push_back(p);
        const double s = kEdge * ((k + 0.5) / kParts + 0.5 * (i % 2));
        const double angle = most * std::sin(2 * kPi * s / kFold);
        p += kEdge / kParts * Vec3(std::cos(angle), 0, std::sin(angle));
      }
    }
    const auto at = [&](int i, int j) { return i * (kColumns + 1) + j; };
    for (int i = 0; i < kRows; ++i)
      for (int j = 0; j < kColumns; ++j) {
        const int a = at(i, j), b = at(i, j + 1), c = at(i + 1, j), d = at(i + 1, j + 1);
        if (i % 2 == 0) {
          triangles.push_back({a, b, c});
          triangles.push_back({b, d, c});
        } else {
          triangles.push_back({a, b, d});
          triangles.push_back({a, d, c});
        }
      }
    areas.assign(triangles.size(), 0.5 * kEdge * kEdge * std::sqrt(0.75));
    std::mt19937 rng(1);
    std::uniform_real_distribution<double> u(-1, 1);
    const double px = u(rng), py = u(rng), pz = u(rng);
    for (const Vec3& p : x)
      direction.emplace_back(0.5 * std::sin(90 * p[1] + 40 * p[2] + px),
                             0.5 * std::sin(70 * p[2] + 30 * p[0] + py),
                             0.5 * std::sin(110 * p[0] + 50 * p[1] + pz));
  }

  contact::SelfContact contact() const {
    return contact::SelfContact(triangles, areas, static_cast<int>(x.size()), {});
  }
  particles::VectorField way(double length) const {
    particles::VectorField dx = direction;
    for (Vec3& d : dx) d *= length;
    return dx;
  }
};

/// Continuous detection for a move of up to range(0) micrometres, the sheet creeping on between the
/// calls by a hundredth of that.
void self_contact_max_step(benchmark::State& state) {
  const WrinkledSheet sheet;
  contact::SelfContact contact = sheet.contact();
  const double length = 1e-6 * static_cast<double>(state.range(0));
  const particles::VectorField dx = sheet.way(length);
  particles::VectorField x = sheet.x;
  int call = 0;
  for (auto _ : state) {
    const double share = ++call % 20 < 10 ? 0.01 : -0.01;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * dx[i];
    benchmark::DoNotOptimize(contact.max_step(x, dx));
  }
  state.counters["active"] = contact.active(x);
}
BENCHMARK(self_contact_max_step)
    ->Arg(10)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void self_contact_begin_step(benchmark::State& state) {
  const WrinkledSheet sheet;
  contact::SelfContact contact = sheet.contact();
  const double infinity = std::numeric_limits<double>::infinity();
  for (auto _ : state) contact.begin_step(sheet.x, infinity);
  state.counters["active"] = contact.active(sheet.x);
}
BENCHMARK(self_contact_begin_step)->Unit(benchmark::kMillisecond)->UseRealTime();

void self_contact_gradient(benchmark::State& state) {
  const WrinkledSheet sheet;
  contact::SelfContact contact = sheet.contact();
  contact.max_step(sheet.x, sheet.way(1e-3));
  particles::VectorField g(sheet.x.size(), Vec3::Zero());
  for (auto _ : state) benchmark::DoNotOptimize(contact.value_and_gradient(sheet.x, g));
}
BENCHMARK(self_contact_gradient)->Unit(benchmark::kMillisecond)->UseRealTime();

void self_contact_hessian(benchmark::State& state) {
  const WrinkledSheet sheet;
  contact::SelfContact contact = sheet.contact();
  contact.begin_step(sheet.x, std::numeric_limits<double>::infinity());
  particles::BlockPattern pattern(static_cast<int>(sheet.x.size()));
  contact.add_pattern(sheet.x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  for (auto _ : state) contact.add_hessian(sheet.x, h, particles::HessianKind::exact);
}
BENCHMARK(self_contact_hessian)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace loosefit
