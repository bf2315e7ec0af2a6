#include <fmt/format.h>

#include <cmath>

#include "loosefit/body/body.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/maps/strain.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/contact_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kRadius = 0.12, kHeight = 0.1;

/// A row of the table of docs/theory/validation.md 8, in degrees and millimetres.
struct Row {
  double mobility, largest_angle, mean_angle, mean_gap, largest_gap;
};
constexpr Row kTable[] = {{0.05, 2.72940, 1.73737, 6.07144, 12},
                          {0.1, 5.21591, 3.31902, 12.27287, 24},
                          {0.2, 9.59407, 6.09822, 25.00175, 48},
                          {0.3, 13.34236, 8.46824, 38.08393, 72},
                          {0.5, 19.47122, 12.31502, 65.03573, 120}};

/// The lying cylinder as a body that the maps understand: one trunk, smooth normals on the wall.
body::Body cylinder_body(double radius) {
  body::Body body;
  body.surface = lying_cylinder(radius, -0.1, kHeight + 0.1);
  for (const Vec3& p : body.surface.vertices) {
    const Vec3 radial(p[0], 0, p[2]);
    const bool cap_centre = radial.norm() < 0.5 * radius;
    body.normals.push_back(cap_centre ? Vec3(0, p[1] < 0 ? -1 : 1, 0) : Vec3(radial.normalized()));
  }
  body.segment.assign(body.normals.size(), body::Segment::torso);
  body.side.assign(body.normals.size(), 0);
  return body;
}

struct Gap {
  maps::MapStatistics distance, angle;  ///< away from the rims
};

/// Distance and angular deviation of the maps, over the tube without a strip at either rim.
Gap measure(const Specimen& tube, const std::vector<Vec3>& positions, const body::Body& body,
            double rim) {
  drape::Drape drape;
  drape.positions = positions;
  const auto maps =
      maps::compute_maps(tube, drape, body, {"distance", "angular-deviation"},
                         {.allow_unsettled = true});  // judged by settle_bench instead
  auto weight = maps::vertex_areas(tube);
  for (std::size_t i = 0; i < weight.size(); ++i)
    if (tube.vertex_uv[i][1] < rim || tube.vertex_uv[i][1] > kHeight - rim) weight[i] = 0;
  Gap gap;
  for (const maps::PerformanceMap& map : maps) {
    if (map.array == "distance_mm") gap.distance = maps::statistics(map.values, weight);
    if (map.array == "angular_deviation_deg") gap.angle = maps::statistics(map.values, weight);
  }
  return gap;
}

/// A tube of radius r(1 + mobility), its axis e = r·mobility below that of the body, so that it
/// touches along the top; seam at the side.
std::unique_ptr<Bench> tube(double mobility, double edge, const fabric::Material& m,
                            double gravity) {
  const double radius = kRadius * (1 + mobility);
  Bench::Options options;
  options.gravity = gravity;
  return std::make_unique<Bench>(
      cut_rectangle(2 * kPi * radius, kHeight, edge, m, true), m,
      [&](const Vec2& p) {
        const double a = p[0] / radius;
        return Vec3(radius * std::cos(a), kHeight - p[1],
                    radius * std::sin(a) - kRadius * mobility);
      },
      options);
}

}  // namespace

BenchmarkResult benchmark_eccentric_tube(Effort effort, Progress& progress) {
  BenchmarkResult result;
  const double edge = 0.006;
  const body::Body body = cylinder_body(kRadius);
  // The exact curve, finer than the rows that are measured.
  report::Plot plot;
  plot.title = "Largest angular deviation of an eccentric tube";
  plot.x_label = "body-garment mobility";
  plot.y_label = "angle (°)";
  report::Plot::Series exact{"sin AD = BGM/(1 + BGM)", {}, {}, true}, marks{"obtained", {}, {}};
  for (double m = 0.01; m < 0.505; m += 0.01) {
    exact.x.push_back(m);
    exact.y.push_back(degrees(std::asin(m / (1 + m))));
  }
  // Nothing settles: the tube is measured as it is placed, without gravity.
  for (const Row& row : kTable) {
    if (effort == Effort::quick && row.mobility != 0.2) continue;
    progress.update(row.mobility / 0.6, fmt::format("mobility {}", row.mobility));
    progress.check_cancelled();
    const auto bench = tube(row.mobility, edge, fabric::Material{}, 0);
    const Gap gap = measure(bench->specimen(), bench->x, body, 1.5 * edge);
    // Limits are absolute: degrees and millimetres, as the maps give them.
    const auto add = [&](const char* what, const char* unit, double expected, double obtained,
                         double limit) {
      Finding f;
      f.what = fmt::format("{} at mobility {}", what, row.mobility);
      f.unit = unit;
      f.expected = expected;
      f.obtained = obtained;
      f.gate = Finding::Gate::absolute;
      f.limit = limit;
      f.mesh = mesh_text(bench->specimen());
      result.findings.push_back(f);
    };
    add("largest angular deviation", "°", row.largest_angle, gap.angle.max, 0.5);
    add("mean angular deviation", "°", row.mean_angle, gap.angle.area_mean, 0.1);
    add("mean gap", "mm", row.mean_gap, gap.distance.area_mean, 0.1);
    add("largest gap", "mm", row.largest_gap, gap.distance.max, 0.1);
    marks.x.push_back(row.mobility);
    marks.y.push_back(gap.angle.max);
  }
  plot.series = {exact, marks};
  result.plots.push_back(plot);
  result.notes = {
      "A tube cut and meshed like a garment is placed as a circle that touches the body, a "
      "cylinder of 120 mm radius with smooth normals, along one line; distance and angular "
      "deviation come from the maps. This tests the maps, not the drape.",
      "A strip of one and a half edges at either rim is left out: a vertex normal there leans by "
      "up "
      "to half a triangle. The largest angle is that of the worst vertex of an irregular mesh, "
      "hence mostly above the exact one."};
  return result;
}

}  // namespace loosefit::validate
