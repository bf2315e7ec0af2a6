#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/validate/beam_strip.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/contact_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kLength = 0.5, kWidth = 0.02, kEdge = 0.006;  ///< [m]
constexpr double kRigidity = 1e-2;                             ///< B [N m]
constexpr double kRough = 10;                                  ///< friction that never slips here
constexpr double kSlip = 1e-3;  ///< way of the tip that counts as slip [m]

/// A row of the table of docs/theory/validation.md 4.6.
struct Row {
  double shortening, force, critical;  ///< ε, P L²/B, μ_c
};
constexpr Row kTable[] = {{0.001, 20.198325, 0.014086}, {0.005, 20.228735, 0.031594},
                          {0.01, 20.266799, 0.044854},  {0.02, 20.343092, 0.063930},
                          {0.05, 20.573093, 0.103545},  {0.1, 20.958642, 0.152793},
                          {0.15, 21.343322, 0.195916},  {0.2, 21.721196, 0.237774},
                          {0.25, 22.083580, 0.280705},  {0.3, 22.417725, 0.326491}};

fabric::Material sheet(double friction) {
  fabric::Material m;
  m.thickness = 1e-4;
  m.stiffness_warp = m.stiffness_weft = 1e5;
  m.stiffness_shear = 5e4;
  m.poisson = 0;
  m.bending_warp = m.bending_weft = kRigidity;
  m.bending_poisson = 0;
  m.friction_body = friction;
  return m;
}

/// Depth z and sideways way y of a clamped–hinged column that has buckled, at s ∈ [0, 1]; first
/// buckling mode with finite slopes, drawn straight so that the hinge lies below the clamp.
struct Buckled {
  std::vector<double> depth{0}, side{0};
  Buckled(double shortening) {
    double low = 0, high = 3;
    for (int k = 0; k < 60; ++k) {
      const double a = 0.5 * (low + high);
      integrate(a);
      (1 - depth.back() < shortening ? low : high) = a;
    }
    const double last = side.back();
    for (std::size_t i = 0; i < side.size(); ++i)
      side[i] -= last * static_cast<double>(i) / (side.size() - 1);
  }
  void integrate(double amplitude) {
    constexpr int n = 400;
    constexpr double k = 4.493409458;  // tan k = k
    depth.assign(1, 0);
    side.assign(1, 0);
    for (int i = 0; i < n; ++i) {
      const double s = (i + 0.5) / n;
      const double slope = amplitude * (std::cos(k * s) + k * std::sin(k * s) - 1) / k;
      depth.push_back(depth.back() + std::cos(slope) / n);
      side.push_back(side.back() + std::sin(slope) / n);
    }
  }
  static double at(const std::vector<double>& v, double s) {
    const double t = std::clamp(s, 0.0, 1.0) * (v.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(t), v.size() - 2);
    return v[i] + (t - i) * (v[i + 1] - v[i]);
  }
};

/// The strip hangs from its clamp down to the floor z = 0 and stands on it with its lower edge.
class PressedStrip {
 public:
  PressedStrip(double shortening, Progress& progress)
      : strip_(cut_clamped_strip(kLength, kWidth, kEdge, sheet(kRough))), progress_(progress) {
    const double length = strip_.length;
    const Buckled shape(shortening);
    const double tip = 0.5 * sheet(0).thickness;  // mid-surface of the standing edge
    place_ = [=, this](const Vec2& p) {
      const double s = p[0] / length;
      const double down = s < 0 ? s : Buckled::at(shape.depth, s);
      return Vec3(s < 0 ? 0 : length * Buckled::at(shape.side, s), p[1] - 0.5 * kWidth,
                  tip + length * (1 - shortening - down));
    };
    auto pinned = bench(kRough);
    pinned->hold(strip_.end);
    settle_bench(*pinned, progress_, 1e-6);
    auto rough = bench(kRough);
    rough->x = pinned->x;
    for (int v : strip_.end) rough->x[v][2] -= 0.1 * tip;  // in touch, so that it sticks at once
    settle_bench(*rough, progress_, 1e-6);
    stuck_ = rough->x;
    for (const Vec3& f : body_force(*rough)) floor_ += f;
  }

  double pressing() const { return floor_[2] / kWidth; }             ///< P [N/m]
  double needed() const { return std::abs(floor_[0]) / floor_[2]; }  ///< |Q|/P
  double length() const { return strip_.length; }
  std::string mesh() const { return mesh_text(strip_.specimen); }

  bool holds(double friction) {
    auto b = bench(friction);
    b->x = stuck_;
    const auto travel = [&] {
      double way = 0;
      for (int v : strip_.end) way = std::max(way, std::abs(b->x[v][0] - stuck_[v][0]));
      return way;
    };
    return try_grip(*b, travel, kSlip, 1e-6, progress_).holds;
  }

 private:
  std::unique_ptr<Bench> bench(double friction) {
    Bench::Options options;
    options.gravity = 0;
    auto b = std::make_unique<Bench>(strip_.specimen, sheet(friction), place_, options);
    geometry::TriangleMesh floor = rigid_box({1, 0.2, 0.05});
    for (Vec3& p : floor.vertices) p[2] -= 0.05;
    b->touch(std::move(floor));
    b->hold(strip_.clamp);
    return b;
  }

  ClampedStrip strip_;
  Progress& progress_;
  std::function<Vec3(const Vec2&)> place_;
  particles::VectorField stuck_;
  Vec3 floor_ = Vec3::Zero();
};

}  // namespace

BenchmarkResult benchmark_stick_slip(Effort effort, Progress& progress) {
  BenchmarkResult result;
  // The plot and its exact curve, over all rows even in a quick run.
  report::Plot plot;
  plot.title = "Stick-slip of a pressed strip";
  plot.x_label = "lowering ε of the clamp";
  plot.y_label = "critical friction";
  plot.log_x = plot.log_y = true;
  report::Plot::Series exact{"clamped–hinged elastica", {}, {}, true};
  report::Plot::Series bisected{"least μ that holds", {}, {}},
      needed{"|Q|/P while it sticks", {}, {}};
  for (const Row& row : kTable) {
    exact.x.push_back(row.shortening);
    exact.y.push_back(row.critical);
  }
  // Each row is a strip of its own, which bends and sticks before anything is asked.
  for (const Row& row : kTable) {
    progress.update(static_cast<double>(bisected.x.size()) / std::size(kTable),
                    fmt::format("ε = {}", row.shortening));
    if (effort == Effort::quick && row.shortening != 0.1) continue;
    PressedStrip strip(row.shortening, progress);
    const auto add = [&](const std::string& what, double expected, double obtained) {
      Finding f;
      f.what = fmt::format("{} at ε = {}", what, row.shortening);
      f.expected = expected;
      f.obtained = obtained;
      f.limit = 0.03;
      f.mesh = strip.mesh();
      result.findings.push_back(f);
    };
    // Bisection about the exact value, and the same told from forces as a second witness.
    const FrictionLimit found = least_friction(0.95 * row.critical, 1.05 * row.critical, 0.004,
                                               [&](double mu) { return strip.holds(mu); });
    add(fmt::format("least μ that holds, known to ± {:.1g},", found.resolution()), row.critical,
        found.value());
    add("|Q|/P while it sticks", row.critical, strip.needed());
    add("P L²/B", row.force, strip.pressing() * strip.length() * strip.length() / kRigidity);
    bisected.x.push_back(row.shortening);
    bisected.y.push_back(found.value());
    needed.x.push_back(row.shortening);
    needed.y.push_back(strip.needed());
  }
  plot.series = {exact, bisected, needed};
  result.plots.push_back(plot);
  result.notes = {
      "A sheet of B = 0.01 N m, 500 × 20 mm, without weight, is bent with its lower edge held "
      "below the clamp, then the edge is released on a floor too rough to slip on: |Q|/P is the "
      "ratio of the floor's forces. From that state it is let go on floors of lower friction; "
      "slipping is a way of the edge of more than 1 mm. Bisection to 0.4 %.",
      "The edge may creep by up to 0.1 mm before it slips (the elastic reach of friction), "
      "0.02 % of the length; this is what remains at ε = 0.001, where the strip stands almost "
      "straight."};
  return result;
}

}  // namespace loosefit::validate
