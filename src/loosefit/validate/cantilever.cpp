#include "loosefit/validate/cantilever.h"

#include <algorithm>
#include <cmath>

#include "loosefit/validate/beam_strip.h"

namespace loosefit::validate {

double CantileverShape::chord_angle() const { return std::atan2(h, w); }

int cantilever_elements(double gravity_number) {
  return std::max(40, static_cast<int>(std::lround(5 * std::sqrt(gravity_number))));
}

CantileverShape settle_cantilever(const CantileverCase& problem, Progress& progress) {
  constexpr double kEdgesAcross = 6;
  const fabric::Material fabric = beam_fabric();
  const double b = fabric.bending_weft;  // along x of the pattern
  const double bending_length = std::cbrt(b / (fabric.areal_density * kGravity));
  const double l =
      problem.length > 0 ? problem.length : bending_length * std::cbrt(problem.gravity_number);
  const double edge = l / problem.elements;
  const ClampedStrip strip = cut_clamped_strip(l, kEdgesAcross * edge, edge, fabric);
  Bench::Options options;
  options.gravity = problem.gravity_number * b / (l * l * l * fabric.areal_density);
  const double force = problem.force_number * b / (l * l) * strip.width;  // [N]

  Bench bench(
      strip.specimen, fabric, [](const Vec2& p) { return Vec3(p[0], p[1], 0); }, options);
  bench.hold(strip.clamp);
  const std::vector<double> weight = line_weights(strip.end, bench.flat());
  for (std::size_t i = 0; i < strip.end.size(); ++i)
    if (force > 0) bench.loads().force[strip.end[i]] = Vec3(0, 0, -force * weight[i]);
  // Without weight the residual is in newtons.
  settle_bench(bench, progress, options.gravity > 0 ? kBenchTolerance : kBenchTolerance * force);
  const Vec3 tip = mean_of_line(strip.end, bench.flat(), bench.x);
  return {tip[0] / l, -tip[2] / l, mesh_text(bench.specimen())};
}

}  // namespace loosefit::validate
