#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/body/body.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/io/material_file.h"
#include "loosefit/maps/gap.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/strain.h"
#include "loosefit/maps/worn_garment.h"
#include "loosefit/pipeline/ease_on_mesh.h"
#include "loosefit/scenario/scenario.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/contact_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kHeight = 0.06, kFineEdge = 0.005;
constexpr double kEases[] = {-0.3, -0.2, -0.1, 0.0, 0.1};
constexpr const char* kFabrics[] = {"cotton-jersey", "compression-knit", "cotton-rib"};

/// A part of the body as a cylinder of its mean girth.
struct Place {
  const char* name;
  double radius;  ///< [m]
};
constexpr Place kPlaces[] = {
    {"chest", 0.145}, {"upper arm", 0.045}, {"wrist", 0.026}, {"thigh", 0.085}};

/// Edge that a run takes there: that of a scenario, on close limbs finer (limb_fineness).
double default_edge(double radius) {
  const double wanted = scenario::ScenarioSimulation{}.edge_length;
  return wanted *
         std::clamp(pipeline::kLimbEdge * radius / wanted, pipeline::kFinestLimb, 1.0);
}

/// What the maps say of a band away from its rims.
struct Worn {
  double pressure = 0;  ///< [kPa]
  double laplace = 0;   ///< hoop tension as worn over its radius [kPa]
  double gap = 0;       ///< [mm]
  std::string mesh;
};

body::Body upright_cylinder(double radius) {
  body::Body body;
  body.surface = rigid_cylinder(radius, -0.05, kHeight + 0.05, 20, 480);
  for (const Vec3& p : body.surface.vertices) {
    const Vec3 radial(p[0], p[1], 0);
    const bool cap_centre = radial.norm() < 0.5 * radius;
    body.normals.push_back(cap_centre ? Vec3(0, 0, p[2] < 0 ? -1 : 1) : Vec3(radial.normalized()));
  }
  body.segment.assign(body.normals.size(), body::Segment::torso);
  body.side.assign(body.normals.size(), 0);
  return body;
}

Worn wear(double radius, double ease, double edge, const fabric::Material& m, Progress& progress) {
  const double girth = 2 * kPi * radius * (1 + ease);
  const double start = std::max(radius + m.thickness, girth / (2 * kPi));
  Bench::Options options;
  options.gravity = 0;
  Bench bench(
      cut_rectangle(girth, kHeight, edge, m, true), m,
      [&](const Vec2& p) {
        const double a = 2 * kPi * p[0] / girth;
        return Vec3(start * std::cos(a), start * std::sin(a), p[1]);
      },
      options);
  const body::Body body = upright_cylinder(radius);
  bench.touch(body.surface);
  settle_bench(bench, progress, 1e-5);

  const Specimen& s = bench.specimen();
  const maps::WornGarment worn = maps::relate(s, bench.x, body);
  const std::vector<Mat3> tension = maps::membrane_tension(s, bench.x, m);
  const particles::VectorField push = body_force(bench);
  const auto inner = [](double v) { return v > 0.2 * kHeight && v < 0.8 * kHeight; };
  Worn result;
  result.mesh = mesh_text(s);
  double area = 0, force = 0, gap = 0, flat = 0;
  std::vector<double> worn_area(bench.x.size(), 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const Triangle& c = s.triangles[t];
    const double here = geometry::triangle_area(bench.x[c[0]], bench.x[c[1]], bench.x[c[2]]);
    for (const int v : c) worn_area[v] += here / 3;
    const Vec3 middle = (bench.x[c[0]] + bench.x[c[1]] + bench.x[c[2]]) / 3;
    if (!inner((s.triangle_uv[t][0][1] + s.triangle_uv[t][1][1] + s.triangle_uv[t][2][1]) / 3))
      continue;
    const Vec3 hoop = Vec3(-middle[1], middle[0], 0).normalized();
    result.laplace += here * hoop.dot(tension[t] * hoop);
    flat += here;
  }
  double pressed = 0;
  for (std::size_t v = 0; v < bench.x.size(); ++v) {
    if (!inner(s.vertex_uv[v][1])) continue;
    force += push[v].dot(Vec3(bench.x[v][0], bench.x[v][1], 0).normalized());
    pressed += worn_area[v];
    gap += worn.areas[v] * maps::gap_of(worn.distances[v], m);
    area += worn.areas[v];
  }
  result.gap = 1e3 * gap / area;
  result.pressure = 1e-3 * force / pressed;
  result.laplace *= 1e-3 / flat / (radius + 0.5 * m.thickness + 1e-3 * result.gap);
  return result;
}

Finding finding(const std::string& what, const std::string& unit, double expected, double obtained,
                Finding::Gate gate, double limit, const std::string& mesh) {
  Finding f;
  f.what = what, f.unit = unit, f.expected = expected, f.obtained = obtained;
  f.gate = gate, f.limit = limit, f.mesh = mesh;
  return f;
}

}  // namespace

BenchmarkResult benchmark_close_bands(Effort effort, Progress& progress) {
  constexpr double kFromFine = 0.15, kFromLaplace = 0.20, kGap = 0.15, kNothing = 0.03;
  BenchmarkResult result;
  double done = 0;
  for (const char* fabric : kFabrics) {
    fabric::Material m = io::load_material(fabric).material;
    m.friction_body = 0;
    for (const Place& place : kPlaces)
      for (const double ease : kEases) {
        const bool sample = place.radius == 0.026 && fabric == kFabrics[0] && ease <= 0;
        progress.update(done++ / (std::size(kFabrics) * std::size(kPlaces) * std::size(kEases)),
                        fmt::format("{}, {}, ease {:+.0f} %", fabric, place.name, 100 * ease));
        if (effort == Effort::quick && !sample) continue;
        const Worn coarse = wear(place.radius, ease, default_edge(place.radius), m, progress),
                   fine = wear(place.radius, ease, kFineEdge, m, progress);
        const auto name = [&](const char* what) {
          return fmt::format("{} of a band round the {}, {}, ease {:+.0f} %", what, place.name,
                             fabric, 100 * ease);
        };
        if (ease < 0) {
          result.findings.push_back(finding(name("pressure"), "kPa", fine.pressure, coarse.pressure,
                                            Finding::Gate::relative, kFromFine, coarse.mesh));
          result.findings.push_back(finding(name("pressure against T(e)/R"), "kPa", coarse.laplace,
                                            coarse.pressure, Finding::Gate::relative, kFromLaplace,
                                            coarse.mesh));
        } else {
          result.findings.push_back(finding(name("pressure"), "kPa", 0, coarse.pressure,
                                            Finding::Gate::absolute, kNothing, coarse.mesh));
        }
        result.findings.push_back(finding(name("gap"), "mm", fine.gap, coarse.gap,
                                          Finding::Gate::absolute, kGap, coarse.mesh));
      }
  }
  result.notes = {
      "A band of 60 mm without weight or friction on a rigid cylinder of the mean girth of each part "
      "of the body. The mesh is the one that a run has there; the expected pressure and gap are those "
      "of the same band at 5 mm.",
      "T(e)/R takes the membrane tension of the maps along the girth and the radius of the cloth's "
      "middle surface, both as worn, away from the rims."};
  return result;
}

}  // namespace loosefit::validate
