#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/semi_implicit_euler.h"
#include "loosefit/validate/beam_strip.h"
#include "loosefit/validate/catalogue.h"

namespace loosefit::validate {
namespace {

// ω √(L/g) of a hanging flexible strip: half the zeros of the Bessel function J0 (Bernoulli 1738;
// docs/theory/validation.md 7).
constexpr double kSwing = 1.20241278;

/// A strip that hangs from its upper edge, pushed out of its plane along its first mode.
class Pendulum {
 public:
  static constexpr double kLength = 0.5, kPush = 0.01;  ///< [m]

  explicit Pendulum(int elements) {
    const double edge = kLength / elements;
    const fabric::Material fabric = beam_fabric();
    Specimen specimen = cut_rectangle(4 * edge, kLength, edge, fabric);
    mesh_ = mesh_text(specimen);
    Bench::Options options;
    options.dynamic = true;
    bench_ = std::make_unique<Bench>(
        std::move(specimen), fabric, [](const Vec2& p) { return Vec3(p[0], 0, p[1] - kLength); },
        options);
    bench_->hold(
        vertices_where(bench_->specimen(), [](const Vec2& p) { return p[1] > kLength - 1e-9; }));
    for (int v = 0; v < bench_->specimen().vertex_count; ++v)
      mode_.push_back(std::cyl_bessel_j(0, 2 * kSwing * std::sqrt(bench_->flat()[v][1] / kLength)));
  }

  Bench& bench() { return *bench_; }
  const std::string& mesh() const { return mesh_; }

  void push() {
    for (std::size_t i = 0; i < mode_.size(); ++i) bench_->x[i][1] += kPush * mode_[i];
  }
  /// Amplitude of the first mode, by projection with the masses [m].
  double amplitude() const {
    double moment = 0, norm = 0;
    for (std::size_t i = 0; i < mode_.size(); ++i) {
      const double m = bench_->specimen().vertex_mass[i] * mode_[i];
      moment += m * bench_->x[i][1];
      norm += m * mode_[i];
    }
    return moment / norm;
  }

 private:
  std::string mesh_;
  std::unique_ptr<Bench> bench_;
  std::vector<double> mode_;
};

/// Times of the zero crossings of a signal that is handed over sample by sample.
class Crossings {
 public:
  void add(double time, double value) {
    times.push_back(time);
    values.push_back(value);
    const std::size_t n = values.size();
    if (n < 2 || (values[n - 2] > 0) == (values[n - 1] > 0)) return;
    const double share = values[n - 2] / (values[n - 2] - values[n - 1]);
    at.push_back(times[n - 2] + share * (times[n - 1] - times[n - 2]));
  }
  /// ω from the first to the last crossing, half a period each [rad/s].
  double frequency() const {
    if (at.size() < 2) return std::nan("");
    return kPi * static_cast<double>(at.size() - 1) / (at.back() - at.front());
  }
  std::vector<double> times, values, at;
};

/// Largest stable step of the semi-implicit scheme is 2/ω; the highest frequency of the mesh is
/// that of a membrane wave across its shortest height.
double stable_step(const Bench& bench) {
  const fabric::Material& m = bench.material();
  return 0.3 * geometry::shortest_height(bench.specimen().triangle_uv) /
         std::sqrt(m.stiffness_warp / m.areal_density);
}

Finding swing_finding(const std::string& scheme, double omega, double dt, const std::string& mesh) {
  Finding f;
  f.what = fmt::format("ω √(L/g), {}, dt = {:.2g} ms", scheme, 1e3 * dt);
  f.expected = kSwing;
  f.obtained = omega * std::sqrt(Pendulum::kLength / kGravity);
  f.limit = 0.01;
  f.mesh = mesh;
  return f;
}

constexpr double kQuarterPeriods = 5;

double swing_time() {
  return kQuarterPeriods * 0.5 * kPi / (kSwing * std::sqrt(kGravity / Pendulum::kLength)) * 1.03;
}

Crossings swing_semi_implicit(Pendulum& p, double dt, Progress& progress) {
  Crossings crossings;
  particles::VectorField v(p.bench().x.size(), Vec3::Zero());
  const int steps = static_cast<int>(swing_time() / dt);
  for (int i = 0; i <= steps; ++i) {
    if (i % 20 == 0) crossings.add(i * dt, p.amplitude());
    if (i % 500 == 0) {
      progress.check_cancelled();
      progress.update(0.5 + 0.5 * i / steps, "semi-implicit Euler");
    }
    solver::semi_implicit_euler_step(p.bench().system(), p.bench().x, v, dt);
  }
  return crossings;
}

Crossings swing_implicit(Pendulum& p, double dt, Progress& progress) {
  Crossings crossings;
  solver::SettleOptions options;
  options.tolerance = 0;  // goes on swinging
  options.first_dt = dt;
  options.max_iterations = static_cast<int>(swing_time() / dt);
  options.watch = [&](int step, double) {
    progress.check_cancelled();
    progress.update(0.5 * step / options.max_iterations, "implicit Euler");
    crossings.add(step * dt, p.amplitude());
    return false;
  };
  const solver::SettleOutcome outcome =
      solver::make_implicit_euler(p.bench().system())->settle(p.bench().x, options);
  if (outcome.reason != solver::SettleOutcome::Reason::iteration_limit)
    throw SolverFailure("the swing ended early: " + outcome.text());
  return crossings;
}

}  // namespace

BenchmarkResult benchmark_free_fall(Effort, Progress& progress) {
  constexpr int kSteps = 1000;
  const fabric::Material fabric = beam_fabric();
  Bench::Options options;
  options.dynamic = true;
  Bench bench(
      cut_rectangle(0.05, 0.05, 0.01, fabric), fabric,
      [](const Vec2& p) { return Vec3(p[0], p[1], 0); }, options);
  particles::VectorField v(bench.x.size(), Vec3::Zero());
  const double dt = stable_step(bench);
  for (int n = 1; n <= kSteps; ++n) {
    progress.check_cancelled();
    solver::semi_implicit_euler_step(bench.system(), bench.x, v, dt);
  }
  const double exact = -kGravity * dt * dt * kSteps * (kSteps + 1) / 2;
  double found = exact;
  for (const Vec3& p : bench.x)
    if (std::abs(p[2] - exact) >= std::abs(found - exact)) found = p[2];
  Finding f;
  f.what = fmt::format("height after {} steps of {:.2g} ms, particle farthest from the law", kSteps,
                       1e3 * dt);
  f.unit = "m";
  f.expected = exact;
  f.obtained = found;
  f.limit = 1e-12;
  f.mesh = mesh_text(bench.specimen());
  BenchmarkResult result;
  result.findings.push_back(f);
  result.notes = {
      "The scheme of the paper, v += a dt, then x += v dt, falls by g dt² n(n+1)/2 in n steps; a "
      "sheet that falls freely must do so in every particle, without strain or contact forces."};
  return result;
}

BenchmarkResult benchmark_hanging_swing(Effort effort, Progress& progress) {
  BenchmarkResult result;
  report::Plot plot{
      "Swing of a hanging strip", "time [s]", "amplitude of the first mode [mm]", false, false, {}};
  const double omega = kSwing * std::sqrt(kGravity / Pendulum::kLength);
  report::Plot::Series law{"undamped, ω √(L/g) = 1.2024", {}, {}, true};
  for (int i = 0; i <= 200; ++i) {
    law.x.push_back(swing_time() * i / 200);
    law.y.push_back(1e3 * Pendulum::kPush * std::cos(omega * law.x.back()));
  }
  plot.series.push_back(law);
  const auto add = [&](const std::string& name, const Crossings& crossings) {
    report::Plot::Series series{name, {}, {}, false};
    const std::size_t stride = std::max<std::size_t>(1, crossings.times.size() / 40);
    for (std::size_t i = 0; i < crossings.times.size(); i += stride) {
      series.x.push_back(crossings.times[i]);
      series.y.push_back(1e3 * crossings.values[i]);
    }
    plot.series.push_back(series);
  };
  const int elements = effort == Effort::full ? 40 : 20;
  {
    Pendulum p(elements);
    settle_bench(p.bench(), progress);
    p.push();
    const double dt = 2e-3;
    const Crossings crossings = swing_implicit(p, dt, progress);
    result.findings.push_back(swing_finding("implicit Euler", crossings.frequency(), dt, p.mesh()));
    add("implicit Euler", crossings);
  }
  if (effort == Effort::full) {
    Pendulum p(elements);
    settle_bench(p.bench(), progress);
    p.push();
    const double dt = stable_step(p.bench());
    const Crossings crossings = swing_semi_implicit(p, dt, progress);
    result.findings.push_back(
        swing_finding("semi-implicit Euler", crossings.frequency(), dt, p.mesh()));
    add("semi-implicit Euler (the paper's)", crossings);
  }
  result.plots.push_back(plot);
  result.notes = {
      "A strip of 500 mm held along its upper edge, free to turn there, released at rest from its "
      "first mode with 10 mm at its lower end (1.1° on the average). ω is taken from the first to "
      "the last zero crossing. Its rigidity adds less than 0.01 % (Γ = 3e4).",
      "Implicit Euler damps the swing, as its amplitude shows; it shifts ω by (ω dt)²/3, here less "
      "than 0.01 %. No viscosity."};
  return result;
}

}  // namespace loosefit::validate
