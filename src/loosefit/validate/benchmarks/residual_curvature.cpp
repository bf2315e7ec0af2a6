#include <fmt/format.h>

#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/io/material_file.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {
namespace {

/// docs/theory/validation.md 2.3, from B and 2HB of Matsudaira et al. 2015.
struct Fabric {
  const char* card;
  double residual;  ///< κ_res = 2HB/(2B) [1/m]
};
constexpr Fabric kFabrics[] = {
    {"cotton-broad", 52.54}, {"wool-tropical", 24.63}, {"polyester-faille", 18.42}};

/// A strip rolled to `tight` [1/m] along its warp and let go; the curvature it keeps [1/m].
double released_curvature(const fabric::Material& material, double tight, Progress& progress,
                          std::string& mesh) {
  const double length = std::min(4.0 / tight, 0.05), width = 0.5 * length;
  Bench bench(cut_rectangle(width, length, length / 16, material), material,
              [&](const Vec2& p) {
                return Vec3(p[0], std::sin(tight * p[1]) / tight,
                            (std::cos(tight * p[1]) - 1) / tight);
              },
              {0.0, false});
  // Not held: the first step of the solver stores the bend as the place the yarns have slid to.
  settle_bench(bench, progress, 1e-8);
  const fabric::BendingEnergy shape(bench.specimen().triangles, bench.specimen().triangle_uv, {},
                                    material);
  const std::vector<double> area = geometry::flat_areas(bench.specimen().triangle_uv);
  double sum = 0, covered = 0;
  const double margin = 1.5 * length / 16;  // a border triangle sees only part of its curvature
  for (std::size_t t = 0; t < area.size(); ++t) {
    Vec2 centre = Vec2::Zero();
    for (const Vec2& p : bench.specimen().triangle_uv[t]) centre += p / 3;
    if ((centre.array() < margin).any() || width - centre[0] < margin ||
        length - centre[1] < margin)
      continue;
    sum += area[t] * shape.curvature(static_cast<int>(t), bench.x)[1];
    covered += area[t];
  }
  mesh = mesh_text(bench.specimen());
  return sum / covered;
}

}  // namespace

BenchmarkResult benchmark_residual_curvature(Effort effort, Progress& progress) {
  BenchmarkResult result;
  report::Plot plot{"Curvature kept after release",
                    "curvature before [1/m]",
                    "curvature after [1/m]",
                    false,
                    false,
                    {}};
  const std::vector<double> tightness =
      effort == Effort::quick ? std::vector<double>{4} : std::vector<double>{0.8, 1.5, 2.5, 4, 6};
  int done = 0;
  for (const Fabric& fabric : kFabrics) {
    fabric::Material material = io::load_material(fabric.card).material;
    report::Plot::Series law{std::string(fabric.card) + ", law", {}, {}, true};
    report::Plot::Series found{std::string(fabric.card) + ", obtained", {}, {}, false};
    for (double tight : tightness) {
      // Below κ_res the strip stays where the slider, not the bend, has its limit.
      const double before = tight * fabric.residual;
      const double expected = std::min(fabric.residual, before);
      law.x.push_back(before);
      law.y.push_back(expected);
      std::string mesh;
      const double kept = released_curvature(material, before, progress, mesh);
      found.x.push_back(before);
      found.y.push_back(kept);
      if (tight > 1)
        result.findings.push_back({fmt::format("{}: κ kept after {:.0f} 1/m", fabric.card, before),
                                   "1/m", expected, kept, Finding::Gate::relative, 0.02, mesh});
      progress.update(++done / (3.0 * static_cast<double>(tightness.size())), fabric.card);
    }
    plot.series.push_back(law);
    plot.series.push_back(found);
  }
  result.plots.push_back(plot);
  result.notes.push_back(
      "An elastic sheet would spring back to 0. Whoever measures B by the cantilever test measures "
      "this friction with it: B_app ≈ B + HB/κ (docs/theory/validation.md 2.3).");
  return result;
}

}  // namespace loosefit::validate
