#include <fmt/format.h>

#include <cmath>

#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/contact_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kRadius = 0.05, kWidth = 0.02, kEdge = 0.005;
constexpr double kGrip = 0.05;  ///< free cloth between the cylinder and a clamp [m]
constexpr double kTurn = kPi * kRadius;
constexpr double kLight = 4 * kRadius;  ///< L1 of the heavy strip [m]

fabric::Material ribbon(double friction) {
  fabric::Material m;
  m.thickness = 2e-4;
  m.stiffness_warp = m.stiffness_weft = 500;
  m.stiffness_shear = 200;
  m.poisson = 0;
  m.bending_warp = m.bending_weft = 1e-9;
  m.friction_body = friction;
  return m;
}

/// A strip laid over the upper half of a cylinder: `light` hangs at −x, `heavy` at +x [m].
/// The cylinder's skin lies half a cloth thickness inside kRadius.
struct Belt {
  std::unique_ptr<Bench> bench;
  std::vector<int> light_end, heavy_end;

  Belt(double light, double heavy, double friction, bool has_weight) {
    const fabric::Material m = ribbon(friction);
    Bench::Options options;
    if (!has_weight) options.gravity = 0;
    const double length = light + kTurn + heavy;
    bench = std::make_unique<Bench>(
        cut_rectangle(length, kWidth, kEdge, m), m,
        [&](const Vec2& p) { return over_cylinder(p[0] - light, p[1], kRadius); }, options);
    bench->touch(lying_cylinder(kRadius - 0.5 * m.thickness, -0.05, kWidth + 0.05), 0.01);
    light_end = vertices_where(bench->specimen(), [](const Vec2& p) { return p[0] < 1e-9; });
    heavy_end =
        vertices_where(bench->specimen(), [&](const Vec2& p) { return p[0] > length - 1e-9; });
  }

  /// Draws the heavy end down by `way` [m] in equal steps, each settled.
  void pull(double way, int steps, double tolerance, Progress& progress) {
    for (int k = 0; k < steps; ++k) {
      for (int v : heavy_end) bench->x[v][2] -= way / steps;
      settle_bench(*bench, progress, tolerance);
    }
  }

  /// Mean depth of a row below the axis of the cylinder [m].
  double depth(const std::vector<int>& row) const {
    double sum = 0;
    for (int v : row) sum -= bench->x[v][2];
    return sum / static_cast<double>(row.size());
  }
};

Finding ratio(const std::string& what, double expected, double obtained, const Belt& belt) {
  Finding f;
  f.what = what;
  f.expected = expected;
  f.obtained = obtained;
  f.limit = 0.02;
  f.mesh = mesh_text(belt.bench->specimen());
  return f;
}

/// T2/T1 of a weightless strip that slips everywhere: both ends are clamped, one is drawn out.
Finding tension_ratio(double friction, Progress& progress) {
  Belt belt(kGrip, kGrip, friction, false);
  Bench& b = *belt.bench;
  b.hold(belt.light_end);
  b.hold(belt.heavy_end);
  belt.pull(0.03, 10, 1e-6, progress);
  return ratio(fmt::format("T2/T1 over half a turn, μ = {}", friction), std::exp(kPi * friction),
               b.reaction(belt.heavy_end)[2] / b.reaction(belt.light_end)[2], belt);
}

/// L2/L1 for R = L1/4 (docs/theory/validation.md 3.2).
double length_ratio(double friction) {
  const double b = 2 * friction * kRadius / (1 + friction * friction);
  return ((kLight + b) * std::exp(kPi * friction) + b) / kLight;
}

/// L2/L1 at which a heavy strip begins to slip: the heavy side is clamped a little below the
/// cylinder and drawn down until all slips; the pull of the clamp is the weight of the missing
/// length. The light side, longer at first by what is drawn, ends at kLight.
Finding slipping_length(double friction, Progress& progress) {
  const double way = 0.005;
  Belt belt(kLight + way, kGrip, friction, true);
  Bench& b = *belt.bench;
  b.hold(belt.heavy_end);
  belt.pull(way, 5, 1e-5, progress);
  const double weight = b.material().areal_density * kGravity * kWidth;  // per length
  const double heavy = belt.depth(belt.heavy_end) - b.reaction(belt.heavy_end)[2] / weight;
  return ratio(fmt::format("L2/L1 of a heavy strip, R = L1/4, μ = {}", friction),
               length_ratio(friction), heavy / belt.depth(belt.light_end), belt);
}

/// Least L2/L1 that slips, by letting go strips of both lengths.
Finding released_length(double friction, Progress& progress) {
  const double expected = length_ratio(friction);
  double holds = 0.95 * expected, slips = 1.05 * expected;
  const auto does_hold = [&](double share, Finding* f) {
    Belt belt(kLight, share * kLight, friction, true);
    Bench& b = *belt.bench;
    const particles::VectorField start = b.x;
    b.system().held.assign(b.x.size(), 0);
    const double before = belt.depth(belt.heavy_end);
    const Grip grip = try_grip(
        b, [&] { return belt.depth(belt.heavy_end) - before; }, 0.003, 1e-4, progress);
    if (f) f->mesh = mesh_text(b.specimen());
    return grip.holds;
  };
  Finding f = ratio(fmt::format("least L2/L1 that slips when let go, μ = {}", friction), expected,
                    expected, Belt(kLight, kLight, friction, true));
  if (!does_hold(holds, &f)) slips = holds, holds = 0;
  if (does_hold(slips, nullptr)) holds = slips;
  while (holds > 0 && slips - holds > 0.005 * expected) {
    const double middle = 0.5 * (holds + slips);
    (does_hold(middle, nullptr) ? holds : slips) = middle;
  }
  f.obtained = 0.5 * (holds + slips);
  return f;
}

}  // namespace

BenchmarkResult benchmark_capstan(Effort effort, Progress& progress) {
  BenchmarkResult result;
  std::vector<double> frictions = {0.3};
  if (effort == Effort::full) frictions = {0.1, 0.2, 0.3, 0.5};
  // Exact curves of the weightless and the heavy strip.
  report::Plot plot;
  plot.title = "Belt over half a turn";
  plot.x_label = "friction μ";
  plot.y_label = "ratio";
  report::Plot::Series e{"T2/T1 = exp(πμ)", {}, {}, true}, l{"L2/L1, R = L1/4", {}, {}, true};
  report::Plot::Series tension{"T2/T1 obtained", {}, {}}, length{"L2/L1 obtained", {}, {}};
  for (double mu = 0; mu < 0.505; mu += 0.01) {
    e.x.push_back(mu);
    e.y.push_back(std::exp(kPi * mu));
    l.x.push_back(mu);
    l.y.push_back(length_ratio(mu));
  }
  // Both strips at each friction; their shares of the progress leave a fifth for letting go.
  double done = 0;
  for (double mu : frictions) {
    progress.update(done, fmt::format("μ = {}", mu));
    result.findings.push_back(tension_ratio(mu, progress));
    tension.x.push_back(mu);
    tension.y.push_back(result.findings.back().obtained);
    progress.update(done += 0.4 / frictions.size(), fmt::format("heavy strip, μ = {}", mu));
    result.findings.push_back(slipping_length(mu, progress));
    length.x.push_back(mu);
    length.y.push_back(result.findings.back().obtained);
    done += 0.4 / frictions.size();
  }
  // Letting go bisects over whole drapes: too slow for a quick run.
  if (effort == Effort::full) {
    progress.update(0.8, "letting go");
    result.findings.push_back(released_length(0.3, progress));
  }
  plot.series = {e, l, tension, length};
  result.plots.push_back(plot);
  result.notes = {
      "Massless strip: both ends are clamped 50 mm below the axis and one is drawn out by 30 mm in "
      "ten settled steps, so that the whole turn slips; T1 and T2 are the forces at the clamps.",
      "Heavy strip: the heavy side is held by a clamp just below the cylinder and drawn down "
      "5 mm; L2 is the free length there plus the clamp's pull over the weight per length. The "
      "last row of the full run needs no clamp: strips of different L2 are let go, and the least "
      "length that slips 3 mm is found by bisection to 0.5 %.",
      "The cylinder's skin lies half a cloth thickness (0.1 mm) inside R = 50 mm; the bending "
      "length is 1 mm; no Poisson contraction, because sliding inwards would turn part of the "
      "friction across the strip."};
  return result;
}

}  // namespace loosefit::validate
