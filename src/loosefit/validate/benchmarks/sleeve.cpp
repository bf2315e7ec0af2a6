#include <fmt/format.h>

#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/maps/strain.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/contact_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kRadius = 0.05, kStiffness = 200, kPoisson = 0.3, kHeight = 0.06;

/// A row of the table of docs/theory/validation.md 6.2.
struct Row {
  double stretch, free_axial, free_tension, free_pressure, held_tension, held_pressure;
};
constexpr Row kTable[] = {{1.05, 0.984505, 10.931890, 218.638, 11.826923, 236.538},
                          {1.1, 0.967988, 23.863942, 477.279, 25.384615, 507.692},
                          {1.2, 0.931665, 56.672720, 1133.454, 58.021978, 1160.440},
                          {1.3, 0.890505, 100.729308, 2014.586, 98.571429, 1971.429},
                          {1.5, 0.790569, 237.170825, 4743.417, 206.043956, 4120.879}};

fabric::Material knit() {
  fabric::Material m;
  m.thickness = 1e-4;
  m.stiffness_warp = m.stiffness_weft = kStiffness;
  m.poisson = kPoisson;
  m.stiffness_shear = kStiffness / (2 * (1 + kPoisson));
  m.bending_warp = m.bending_weft = 1e-8;
  m.friction_body = 0;
  return m;
}

/// A tube of rest girth 2πR/stretch on a cylinder whose skin lies half a cloth thickness inside R.
std::unique_ptr<Bench> sleeve(double stretch, bool held, double edge) {
  const fabric::Material m = knit();
  const double girth = 2 * kPi * kRadius / stretch;
  Bench::Options options;
  options.gravity = 0;
  auto bench = std::make_unique<Bench>(
      cut_rectangle(girth, kHeight, edge / stretch, m, true), m,
      [&](const Vec2& p) {
        const double a = 2 * kPi * p[0] / girth;
        return Vec3(kRadius * std::cos(a), kRadius * std::sin(a), p[1]);
      },
      options);
  bench->touch(rigid_cylinder(kRadius - 0.5 * m.thickness, -0.05, kHeight + 0.05, 20, 480));
  if (held)
    bench->hold(vertices_where(bench->specimen(),
                               [](const Vec2& p) { return p[1] < 1e-9 || p[1] > kHeight - 1e-9; }));
  return bench;
}

struct Measured {
  double hoop = 0, axial = 0;  ///< stretch away from the rims [–]
  double tension = 0;          ///< along the girth, per current axial length [N/m]
  double pressure = 0;         ///< mean over the current area [Pa]
  double normal_force = 0;     ///< of all contacts [N]
};

Measured measure(Bench& bench) {
  Measured r;
  const Specimen& s = bench.specimen();
  const auto strain = maps::triangle_strains(s, bench.x);
  const auto area = geometry::flat_areas(s.triangle_uv);
  double sum = 0;
  for (std::size_t t = 0; t < strain.size(); ++t) {
    const double v = (s.triangle_uv[t][0][1] + s.triangle_uv[t][1][1] + s.triangle_uv[t][2][1]) / 3;
    if (v < 0.15 * kHeight || v > 0.85 * kHeight) continue;
    r.hoop += area[t] * (1 + strain[t].weft);
    r.axial += area[t] * (1 + strain[t].warp);
    sum += area[t];
  }
  r.hoop /= sum;
  r.axial /= sum;
  double low = 1, high = -1;
  for (const Vec3& p : bench.x) low = std::min(low, p[2]), high = std::max(high, p[2]);
  const double length = high - low;

  // Half of the tube is pulled towards the other half by two cuts of the cloth.
  particles::VectorField inner(bench.x.size(), Vec3::Zero());
  for (const particles::Energy* e : bench.system().energies) e->add_gradient(bench.x, inner);
  const particles::VectorField body = body_force(bench);
  double cut = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Vec3 radial = Vec3(bench.x[i][0], bench.x[i][1], 0).normalized();
    r.normal_force += body[i].dot(radial);
    if (bench.x[i][1] > 0) cut += (inner[i] + body[i])[1];
  }
  r.tension = cut / (2 * length);
  const auto vertex_area = maps::vertex_areas(s);
  double force = 0, pressed = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const double v = s.vertex_uv[i][1];
    if (v < 0.15 * kHeight || v > 0.85 * kHeight) continue;
    force += body[i].dot(Vec3(bench.x[i][0], bench.x[i][1], 0).normalized());
    pressed += vertex_area[i];
  }
  r.pressure = force / (pressed * r.hoop * r.axial);
  return r;
}

Finding finding(const std::string& what, const std::string& unit, double expected, double obtained,
                double limit, const std::string& mesh) {
  Finding f;
  f.what = what;
  f.unit = unit;
  f.expected = expected;
  f.obtained = obtained;
  f.limit = limit;
  f.mesh = mesh;
  return f;
}

}  // namespace

BenchmarkResult benchmark_sleeve(Effort effort, Progress& progress) {
  BenchmarkResult result;
  const double edge = 0.003;
  report::Plot plot;
  plot.title = "Pressure of a sleeve on a cylinder of 50 mm";
  plot.x_label = "stretch λ";
  plot.y_label = "pressure (Pa)";
  report::Plot::Series free_line{"axially free", {}, {}, true},
      held_line{"axially held", {}, {}, true};
  report::Plot::Series free_marks{"obtained, free", {}, {}}, held_marks{"obtained, held", {}, {}};
  for (double l = 1; l < 1.505; l += 0.01) {
    const double e = (l * l - 1) / 2;
    free_line.x.push_back(l);
    free_line.y.push_back(l * kStiffness * e / std::sqrt(1 - 2 * kPoisson * e) / kRadius);
    held_line.x.push_back(l);
    held_line.y.push_back(l * kStiffness * e / (1 - kPoisson * kPoisson) / kRadius);
  }
  int done = 0;
  for (const Row& row : kTable)
    for (bool held : {false, true}) {
      progress.update(0.1 * done++,
                      fmt::format("stretch {}, {}", row.stretch, held ? "held" : "free"));
      if (effort == Effort::quick && (row.stretch != 1.2 || held)) continue;
      auto bench = sleeve(row.stretch, held, edge);
      settle_bench(*bench, progress, 1e-6);
      const Measured m = measure(*bench);
      const std::string mesh = mesh_text(bench->specimen());
      const auto name = [&](const char* what) {
        return fmt::format("{} at λ = {}, axially {}", what, row.stretch, held ? "held" : "free");
      };
      const double strain = row.stretch - 1, axial = held ? 1 : row.free_axial;
      const double pressure = held ? row.held_pressure : row.free_pressure;
      result.findings.push_back(finding(name("hoop strain"), "", strain, m.hoop - 1, 0.005, mesh));
      result.findings.push_back(finding(name("axial stretch"), "", axial, m.axial, 0.005, mesh));
      result.findings.push_back(finding(name("hoop tension"), "N/m",
                                        held ? row.held_tension : row.free_tension, m.tension, 0.01,
                                        mesh));
      result.findings.push_back(finding(name("pressure"), "Pa", pressure, m.pressure, 0.01, mesh));
      if (!held)
        result.findings.push_back(finding(name("total normal force"), "N",
                                          pressure * 2 * kPi * kRadius * kHeight * axial,
                                          m.normal_force, 0.01, mesh));
      (held ? held_marks : free_marks).x.push_back(row.stretch);
      (held ? held_marks : free_marks).y.push_back(m.pressure);
    }
  plot.series = {free_line, held_line, free_marks, held_marks};
  result.plots.push_back(plot);
  result.notes = {
      "The cylinder's skin lies half a cloth thickness (0.05 mm) inside R = 50 mm, so that the "
      "middle surface of the uncompressed cloth would lie at R. What remains is the rise of the "
      "chords above the skin (up to 0.02 mm) against the compression of the layer (from 4 % of its "
      "half thickness at λ = 1.05 to two thirds at 1.5).",
      "Hoop strain is the weft strain of the maps, averaged away from the rims; tension is the "
      "inner force through two opposite cuts along the sleeve over their present length; pressure "
      "is the contact force over the present area away from the rims, total normal force that of "
      "all contacts. The rims of the axially held sleeve are clamped at R."};
  return result;
}

}  // namespace loosefit::validate
