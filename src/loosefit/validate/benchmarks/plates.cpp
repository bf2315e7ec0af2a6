#include <fmt/format.h>

#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/clamped_specimen.h"
#include "loosefit/validate/stability.h"

namespace loosefit::validate {
namespace {

/// Isotropic sheet of rigidity D in which tension and bending share one Poisson ratio.
fabric::Material isotropic_plate(double rigidity, double poisson, double stiffness) {
  fabric::Material m;
  m.name = "isotropic plate";
  m.bending_warp = m.bending_weft = rigidity;
  m.poisson = m.bending_poisson = poisson;
  m.stiffness_warp = m.stiffness_weft = stiffness;
  m.stiffness_shear = stiffness / (2 * (1 + poisson));
  return m;
}

Vec3 lying(const Vec2& p) { return {p[0], p[1], 0}; }

// --- B6 ---------------------------------------------------------------------------------------

/// Deflection of the loaded corner over that of the plate, P a²/(2 D (1 − ν)).
Finding twist_finding(double poisson, double edge_length, Progress& progress) {
  const double side = 0.2, rigidity = 1e-4, wanted = 2e-5;
  // Membrane so soft, and deflection so small, that twisting does not stretch: w² ≪ D/K.
  const fabric::Material m = isotropic_plate(rigidity, poisson, 100);
  Bench bench(cut_rectangle(side, side, edge_length, m), m, lying, {0.0, false});
  const auto corner = [&](double u, double v) {
    return vertices_where(bench.specimen(),
                          [&](const Vec2& p) { return (p - Vec2(u, v)).norm() < 1e-6; });
  };
  bench.hold(corner(0, 0));
  bench.hold(corner(side, 0));
  bench.hold(corner(0, side));
  const int loaded = corner(side, side).at(0);
  const double force = wanted * 2 * rigidity * (1 - poisson) / (side * side);
  bench.loads().force[loaded] = Vec3(0, 0, force);
  settle_bench(bench, progress, 1e-5 * force);
  return {fmt::format("corner deflection over P a²/(2D(1−ν)), ν = {:.2g}", poisson),
          "",
          1.0,
          bench.x[loaded][2] / wanted,
          Finding::Gate::relative,
          0.02,
          mesh_text(bench.specimen())};
}

}  // namespace

BenchmarkResult benchmark_twist_plate(Effort effort, Progress& progress) {
  BenchmarkResult result;
  report::Plot plot{"Deflection of the corner in pure twist",
                    "edge length [mm]",
                    "obtained / Kirchhoff plate",
                    false,
                    false,
                    {}};
  report::Plot::Series exact{"Kirchhoff plate", {4, 25}, {1, 1}, true};
  plot.series.push_back(exact);
  const std::vector<double> edges =
      effort == Effort::quick ? std::vector<double>{0.01} : std::vector<double>{0.02, 0.01, 0.005};
  for (double nu : {0.0, 0.3}) {
    report::Plot::Series series{fmt::format("ν = {:.2g}", nu), {}, {}, false};
    for (double edge : edges) {
      const Finding f = twist_finding(nu, edge, progress);
      result.findings.push_back(f);
      series.x.push_back(1e3 * edge);
      series.y.push_back(f.obtained);
    }
    plot.series.push_back(series);
  }
  result.plots.push_back(plot);
  result.notes.push_back(
      "A hinge energy (ν = −1/3) would give 0.75 and 0.525 of the two deflections, a "
      "mean-curvature "
      "energy (ν = 1) no stiffness at all.");
  return result;
}

namespace {

// --- B7 ---------------------------------------------------------------------------------------

struct BucklingRow {
  double width_over_length;
  double gamma[4];  ///< ν = 0, 0.15, 0.3, 0.35
};
// docs/theory/validation.md 4.8
constexpr BucklingRow kBuckling[] = {
    {0.1, {19.348, 17.751, 15.668, 14.871}}, {0.3, {22.025, 20.505, 18.452, 17.647}},
    {0.5, {24.963, 23.553, 21.595, 20.809}}, {1.0, {32.516, 31.424, 29.817, 29.149}},
    {2.0, {40.274, 38.793, 36.834, 36.051}},
};
constexpr double kPoissons[] = {0, 0.15, 0.3, 0.35};

/// A plate on edge, warp along the gravity, for Γ = q L³/D: at rest in its plane, or about to be
/// let go with its tip out of it [m].
std::unique_ptr<Bench> plate_on_edge(double width_over_length, double poisson, double gamma,
                                     Progress& progress, double tip = 0) {
  const double length = 0.2, width = width_over_length * length;
  const double edge = std::clamp(width / 14, 0.001, 0.01);
  const double rigidity = 1e-5;
  fabric::Material m = isotropic_plate(rigidity, poisson, 2e4);
  m.areal_density = gamma * rigidity / (kGravity * length * length * length);
  auto bench = std::make_unique<Bench>(
      cut_clamped_rectangle(length, width, 1.5 * edge, edge, m), m,
      [&](const Vec2& p) { return Vec3(p[0], tip * std::pow(p[0] / length, 2), p[1]); });
  const auto clamp = clamped_vertices(bench->specimen());
  for (int v : clamp) bench->x[v][1] = 0;
  bench->hold(clamp);
  if (tip == 0) settle_bench(*bench, progress, 1e-4);
  return bench;
}

double critical_gamma(double width_over_length, double poisson, double expected, Progress& progress,
                      std::string& mesh) {
  return critical_factor(
      [&](double gamma) {
        progress.check_cancelled();
        const auto bench = plate_on_edge(width_over_length, poisson, gamma, progress);
        mesh = mesh_text(bench->specimen());
        return is_stable(*bench);
      },
      0.85 * expected, 1.15 * expected, 5e-3);
}

/// How far a plate that starts with its tip 1e-4 L out of the plane leaves it [share of L].
double left_plane(double width_over_length, double poisson, double gamma, Progress& progress) {
  const auto bench = plate_on_edge(width_over_length, poisson, gamma, progress, 2e-5);
  settle_bench(*bench, progress, 1e-5);
  double farthest = 0;
  for (const Vec3& p : bench->x) farthest = std::max(farthest, std::abs(p[1]));
  return farthest / 0.2;
}

}  // namespace

BenchmarkResult benchmark_lateral_buckling(Effort effort, Progress& progress) {
  BenchmarkResult result;
  report::Plot plot{"Lateral buckling of a cantilever plate on edge",
                    "width / length",
                    "critical Γ",
                    false,
                    false,
                    {}};
  int done = 0;
  for (int n : {0, 2, 1, 3}) {
    const bool wanted = effort == Effort::full || n == 0 || n == 2;
    report::Plot::Series exact{fmt::format("ν = {:.2g}, exact", kPoissons[n]), {}, {}, true};
    report::Plot::Series found{fmt::format("ν = {:.2g}, obtained", kPoissons[n]), {}, {}, false};
    for (const BucklingRow& row : kBuckling) {
      exact.x.push_back(row.width_over_length);
      exact.y.push_back(row.gamma[n]);
      const bool chosen = effort == Effort::quick
                              ? row.width_over_length == 0.5
                              : n == 0 || n == 2 || row.width_over_length == 0.5;
      if (!wanted || !chosen) continue;
      std::string mesh;
      const double gamma =
          critical_gamma(row.width_over_length, kPoissons[n], row.gamma[n], progress, mesh);
      result.findings.push_back(
          {fmt::format("critical Γ, b/L = {:.3g}, ν = {:.2g}", row.width_over_length, kPoissons[n]),
           "", row.gamma[n], gamma, Finding::Gate::relative, 0.05, mesh});
      found.x.push_back(row.width_over_length);
      found.y.push_back(gamma);
      progress.update(std::min(1.0, ++done / (effort == Effort::quick ? 2.0 : 12.0)),
                      fmt::format("b/L = {:.3g}", row.width_over_length));
    }
    if (wanted) {
      plot.series.push_back(exact);
      plot.series.push_back(found);
    }
  }
  result.plots.push_back(plot);
  if (effort == Effort::full) {
    const BucklingRow& row = kBuckling[2];
    for (double share : {0.9, 1.1})
      result.findings.push_back(
          {fmt::format("out of plane from a start with the tip at 1e-4 L, Γ = {} Γ_c, "
                       "b/L = 0.5, ν = 0.3",
                       share),
           "L", share < 1 ? 0.0 : 0.3, left_plane(0.5, 0.3, share * row.gamma[2], progress),
           Finding::Gate::reported, 0, ""});
  }
  result.notes.push_back(
      "Critical load: the plate settles in its plane, then the exact second derivative of the "
      "energy "
      "is factorised; bisection to 0.5 % of the load at which it stops being positive definite.");
  result.notes.push_back(
      "K = 2e4 N/m, so that the sag in the plane does not shift the load; narrower "
      "plates than b/L = 0.1 would need edges under 1.5 mm.");
  return result;
}

// --- B8 ---------------------------------------------------------------------------------------

BenchmarkResult benchmark_bending_direction(Effort effort, Progress& progress) {
  BenchmarkResult result;
  const double side = 0.2, kappa = 8;
  std::vector<double> edges{0.01};
  if (effort == Effort::full) edges = {0.01, 0.005};
  for (double nu : {0.0, 0.3})
    for (double edge : edges) {
      progress.check_cancelled();
      const fabric::Material m = isotropic_plate(1e-5, nu, 100);
      const Specimen sheet = cut_rectangle(side, side, edge, m);
      const fabric::BendingEnergy bending(sheet.triangles, sheet.triangle_uv, {}, m);
      const std::vector<double> area = geometry::flat_areas(sheet.triangle_uv);
      for (double direction : {0.0, 22.5, 45.0, 90.0, 135.0}) {
        const double c = std::cos(radians(direction)), s = std::sin(radians(direction));
        particles::VectorField x;
        for (const Vec2& p : sheet.vertex_uv) {
          const double along = c * p[0] + s * p[1], across = -s * p[0] + c * p[1];
          x.emplace_back(std::sin(kappa * along) / kappa, across,
                         (1 - std::cos(kappa * along)) / kappa);
        }
        // Triangles whose neighbours all exist: a free border would unbend.
        double energy = 0, covered = 0;
        for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
          Vec2 centre = Vec2::Zero();
          for (const Vec2& p : sheet.triangle_uv[t]) centre += p / 3;
          if ((centre.array() < 1.5 * edge).any() || (centre.array() > side - 1.5 * edge).any())
            continue;
          const Vec3 k = bending.curvature(static_cast<int>(t), x);
          energy += 0.5 * area[t] * k.dot(fabric::plate_rigidity(m) * k);
          covered += area[t];
        }
        result.findings.push_back(
            {fmt::format("energy per area over Bκ²/2 at {}°, ν = {:.2g}", direction, nu), "", 1.0,
             energy / covered / (0.5 * m.bending_warp * kappa * kappa), Finding::Gate::relative,
             0.02, mesh_text(sheet)});
      }
    }
  result.notes.push_back(
      "The sheet is laid on a cylinder of radius 125 mm in five directions; border triangles left "
      "out. A right-triangle grid of hinges would read 3.0 at 45° and 1.0 at 135° "
      "(docs/theory/validation.md "
      "2.1).");
  return result;
}

}  // namespace loosefit::validate
