#include "loosefit/validate/beam_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/garment/assemble.h"

namespace loosefit::validate {
namespace {

/// Sides of a rectangular panel, counter-clockwise from the lower one.
enum Side { below, right, above, left };

pattern::Panel rectangle(const std::string& name, double from, double to, double width) {
  pattern::Panel panel;
  panel.name = name;
  panel.vertices = {{from, 0}, {to, 0}, {to, width}, {from, width}};
  const char* const names[] = {"below", "right", "above", "left"};
  for (int i = 0; i < 4; ++i) {
    pattern::PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % 4;
    edge.name = names[i];
    panel.edges.push_back(edge);
  }
  return panel;
}

void sew(pattern::Pattern& pattern, int first, int second) {
  pattern::Stitch stitch;
  stitch.first = {first, Side::right};
  stitch.second = {second, Side::left};
  stitch.name = fmt::format("seam_{}_{}", first, second);
  pattern.stitches.push_back(stitch);
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

fabric::Material beam_fabric() {
  fabric::Material m;
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

double clamp_depth(Ends ends, double edge_length) {
  return ends == Ends::one_clamp ? 0.05 * edge_length : 2 * edge_length;
}

ClampedStrip cut_clamped_strip(double length, double width, double edge_length,
                               const fabric::Material& material, Ends ends, int panels) {
  pattern::Pattern pattern;
  pattern.name = "clamped strip";
  for (int i = 0; i < panels; ++i)
    pattern.panels.push_back(rectangle(fmt::format("strip_{}", i), length * i / panels,
                                       length * (i + 1) / panels, width));
  const int clamp = panels, end_clamp = panels + 1;
  const double depth = clamp_depth(ends, edge_length);
  pattern.panels.push_back(rectangle("clamp", -depth, 0, width));
  if (ends == Ends::clamped)
    pattern.panels.push_back(rectangle("end_clamp", length, length + depth, width));
  for (int i = 0; i + 1 < panels; ++i) sew(pattern, i, i + 1);
  sew(pattern, clamp, 0);
  if (ends == Ends::clamped) sew(pattern, panels - 1, end_clamp);
  if (ends == Ends::one_clamp) sew(pattern, panels - 1, clamp);
  for (std::size_t i = 0; i < pattern.panels.size(); ++i)
    pattern.panel_order.push_back(static_cast<int>(i));

  ClampedStrip strip;
  strip.specimen = garment::assemble(pattern, edge_length, material);
  const Specimen& s = strip.specimen;
  for (const int panel : s.triangle_panel)
    strip.specimen.triangle_built_in.push_back(panel >= clamp);
  strip.width = width;
  strip.length = length;
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
                  const particles::VectorField& x) {
  const std::vector<double> weight = line_weights(line, flat);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < line.size(); ++i) mean += weight[i] * x[line[i]];
  return mean;
}

}  // namespace loosefit::validate
