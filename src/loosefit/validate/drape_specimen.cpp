#include "loosefit/validate/drape_specimen.h"

#include <algorithm>
#include <cmath>

#include "loosefit/garment/assemble.h"

namespace loosefit::validate {
namespace {

pattern::EdgeCurve arc(double radius, bool counter_clockwise) {
  pattern::EdgeCurve curve;
  curve.kind = pattern::EdgeCurve::Kind::circle;
  curve.radius = radius;
  curve.sweep = counter_clockwise;
  return curve;
}

void add_edge(pattern::Panel& panel, const std::string& name,
              const pattern::EdgeCurve& curve = {}) {
  pattern::PanelEdge edge;
  edge.start = static_cast<int>(panel.edges.size());
  edge.end = (edge.start + 1) % static_cast<int>(panel.vertices.size());
  edge.curves = {curve};
  edge.name = name;
  panel.edges.push_back(edge);
}

/// Half of the ring between disc and rim, on the side y > 0 (side = 1) or y < 0 (side = −1).
pattern::Panel half_ring(const DrapeTester& tester, double side, const std::string& name) {
  const double a = side * tester.disc_radius, b = side * tester.specimen_radius;
  pattern::Panel panel;
  panel.name = name;
  panel.vertices = {{a, 0}, {b, 0}, {-b, 0}, {-a, 0}};
  add_edge(panel, "right");
  add_edge(panel, "rim", arc(tester.specimen_radius, true));
  add_edge(panel, "left");
  add_edge(panel, "inner", arc(tester.disc_radius, false));
  return panel;
}

pattern::Stitch sew(int panel_a, int edge_a, int panel_b, int edge_b, const std::string& name) {
  pattern::Stitch stitch;
  stitch.first = {panel_a, edge_a};
  stitch.second = {panel_b, edge_b};
  stitch.name = name;
  return stitch;
}

}  // namespace

Specimen cut_drape_specimen(const DrapeTester& tester, double edge_length,
                            const fabric::Material& material) {
  const double a = tester.disc_radius;
  pattern::Panel disc;
  disc.name = "disc";
  disc.vertices = {{a, 0}, {-a, 0}};
  add_edge(disc, "back", arc(a, true));
  add_edge(disc, "front", arc(a, true));
  pattern::Pattern pattern;
  pattern.name = "drape specimen";
  pattern.panels = {disc, half_ring(tester, 1, "ring_back"), half_ring(tester, -1, "ring_front")};
  pattern.panel_order = {0, 1, 2};
  pattern.stitches = {sew(0, 0, 1, 3, "disc_back"), sew(0, 1, 2, 3, "disc_front"),
                      sew(1, 2, 2, 0, "ring_left"), sew(1, 0, 2, 2, "ring_right")};
  Specimen specimen = garment::assemble(pattern, edge_length, material);
  for (int panel : specimen.triangle_panel) specimen.triangle_built_in.push_back(panel == 0);
  return specimen;
}

std::function<Vec3(const Vec2&)> folded_start(const DrapeTester& tester, int folds, double lean,
                                              double swing) {
  return [=](const Vec2& p) -> Vec3 {
    const double r = p.norm(), beyond = r - tester.disc_radius;
    if (beyond <= 0) return {p[0], p[1], 0};
    const double down = lean + swing * std::cos(folds * std::atan2(p[1], p[0]));
    const double now = tester.disc_radius + beyond * std::cos(down);
    return {p[0] * now / r, p[1] * now / r, -beyond * std::sin(down)};
  };
}

std::vector<int> on_disc(const Specimen& specimen, const DrapeTester& tester) {
  return vertices_where(specimen,
                        [&](const Vec2& p) { return p.norm() < tester.disc_radius + 1e-6; });
}

DrapeReading read_drape(const Bench& bench, const DrapeTester& tester) {
  const Specimen& specimen = bench.specimen();
  particles::VectorField flat;
  for (const Vec2& p : bench.flat()) flat.emplace_back(p[0], p[1], 0);
  std::vector<Triangle> carried;
  for (std::size_t i = 0; i < specimen.triangles.size(); ++i)
    if (specimen.panel_names[specimen.triangle_panel[i]] == "disc")
      carried.push_back(specimen.triangles[i]);
  DrapeReading reading;
  reading.coefficient =
      drape_coefficient(shadow_area(bench.x, specimen.triangles), shadow_area(flat, carried),
                        shadow_area(flat, specimen.triangles));
  reading.energy = bench.energy();

  std::vector<std::pair<double, int>> rim;
  for (int v : vertices_where(
           specimen, [&](const Vec2& p) { return p.norm() > tester.specimen_radius - 1e-6; }))
    rim.emplace_back(std::atan2(bench.flat()[v][1], bench.flat()[v][0]), v);
  std::sort(rim.begin(), rim.end());
  std::vector<Vec3> points;
  std::vector<double> angles;
  for (const auto& [angle, v] : rim) angles.push_back(angle), points.push_back(bench.x[v]);
  reading.folds = count_folds(points, angles);
  return reading;
}

}  // namespace loosefit::validate
