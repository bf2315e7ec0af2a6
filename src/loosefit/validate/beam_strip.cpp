#include "loosefit/validate/beam_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/garment/assemble.h"

namespace loosefit {
namespace {

/// Sides of a rectangular panel, counter-clockwise from the lower one.
enum Side { below, right, above, left };

Panel rectangle(const std::string& name, double from, double to, double width) {
  Panel panel;
  panel.name = name;
  panel.vertices = {{from, 0}, {to, 0}, {to, width}, {from, width}};
  const char* const names[] = {"below", "right", "above", "left"};
  for (int i = 0; i < 4; ++i) {
    PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % 4;
    edge.name = names[i];
    panel.edges.push_back(edge);
  }
  return panel;
}

void sew(Pattern& pattern, int first, int second) {
  Stitch stitch;
  stitch.first = {first, Side::right};
  stitch.second = {second, Side::left};
  stitch.name = fmt::format("seam_{}_{}", first, second);
  pattern.stitches.push_back(stitch);
}

/// Mean height of the clamp's triangles over the mesh line x = at.
double height_over_line(const Specimen& s, int panel, double at) {
  double area = 0, base = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    if (s.triangle_panel[t] != panel) continue;
    const auto& p = s.triangle_uv[t];
    for (int k = 0; k < 3; ++k) {
      const Vec2 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
      if (std::abs(a[0] - at) > 1e-9 || std::abs(b[0] - at) > 1e-9) continue;
      area += 0.5 * std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
      base += (b - a).norm();
    }
  }
  return 2 * area / base;
}

std::vector<int> vertices_of_panel(const Specimen& s, int panel) {
  std::vector<char> in(s.vertex_count, 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (s.triangle_panel[t] == panel)
      for (int v : s.triangles[t]) in[v] = 1;
  std::vector<int> list;
  for (int v = 0; v < s.vertex_count; ++v)
    if (in[v]) list.push_back(v);
  return list;
}

}  // namespace

Material beam_fabric() {
  Material m;
  m.name = "beam";
  m.source = "cotton of the paper, without contraction, thin";
  m.areal_density = 0.12;
  m.thickness = 1e-5;
  m.stiffness_warp = m.stiffness_weft = 2000;
  m.poisson = 0;
  m.stiffness_shear = 1000;
  m.bending_warp = m.bending_weft = 4.41e-6;
  m.bending_poisson = 0;
  m.damping = 0;
  return m;
}

ClampedStrip cut_clamped_strip(double length, double width, double edge_length,
                               const Material& material, Ends ends, int panels) {
  const double row = 0.5 * std::sqrt(3.0) * edge_length;  // height of an equilateral triangle
  const double reach = 0.5 * row;                         // by which a clamp line lies inside
  const bool far_clamp = ends != Ends::free;
  const double from = reach, to = length - (far_clamp ? reach : 0);
  Pattern pattern;
  pattern.name = "clamped strip";
  for (int i = 0; i < panels; ++i)
    pattern.panels.push_back(rectangle(fmt::format("strip_{}", i), from + (to - from) * i / panels,
                                       from + (to - from) * (i + 1) / panels, width));
  const int clamp = panels, end_clamp = panels + 1;
  const double depth = ends == Ends::one_clamp ? row : 2 * row;
  pattern.panels.push_back(rectangle("clamp", from - depth, from, width));
  if (ends == Ends::clamped)
    pattern.panels.push_back(rectangle("end_clamp", to, to + depth, width));
  for (int i = 0; i + 1 < panels; ++i) sew(pattern, i, i + 1);
  sew(pattern, clamp, 0);
  if (ends == Ends::clamped) sew(pattern, panels - 1, end_clamp);
  if (ends == Ends::one_clamp) sew(pattern, panels - 1, clamp);
  for (std::size_t i = 0; i < pattern.panels.size(); ++i)
    pattern.panel_order.push_back(static_cast<int>(i));

  ClampedStrip strip;
  strip.specimen = assemble(pattern, edge_length, material);
  const Specimen& s = strip.specimen;
  strip.width = width;
  strip.x0 = from - 0.5 * height_over_line(s, clamp, from);
  double end = to;
  if (ends == Ends::clamped) end += 0.5 * height_over_line(s, end_clamp, to);
  if (ends == Ends::one_clamp) end += 0.5 * height_over_line(s, clamp, from - depth);
  strip.length = end - strip.x0;
  strip.clamp = vertices_of_panel(s, clamp);
  if (ends == Ends::clamped) strip.end_clamp = vertices_of_panel(s, end_clamp);
  strip.end = s.find_chain(pattern.panels[panels - 1].name, "right")->vertices;
  return strip;
}

std::vector<double> line_weights(const std::vector<int>& line, const std::vector<Vec2>& flat) {
  std::vector<double> weight(line.size(), 0.0);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double piece = (flat[line[i + 1]] - flat[line[i]]).norm();
    weight[i] += 0.5 * piece;
    weight[i + 1] += 0.5 * piece;
    sum += piece;
  }
  for (double& w : weight) w /= sum;
  return weight;
}

Vec3 mean_of_line(const std::vector<int>& line, const std::vector<Vec2>& flat,
                  const VectorField& x) {
  const std::vector<double> weight = line_weights(line, flat);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < line.size(); ++i) mean += weight[i] * x[line[i]];
  return mean;
}

}  // namespace loosefit
