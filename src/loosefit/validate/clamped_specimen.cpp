#include "loosefit/validate/clamped_specimen.h"

#include "loosefit/garment/assemble.h"

namespace loosefit::validate {
namespace {

pattern::Panel rectangle(const std::string& name, double x0, double x1, double width) {
  pattern::Panel panel;
  panel.name = name;
  panel.vertices = {{x0, 0}, {x1, 0}, {x1, width}, {x0, width}};
  for (int i = 0; i < 4; ++i) {
    pattern::PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % 4;
    edge.name = "side_" + std::to_string(i);
    panel.edges.push_back(edge);
  }
  return panel;
}

}  // namespace

Specimen cut_clamped_rectangle(double length, double width, double clamp, double edge_length,
                               const fabric::Material& material) {
  pattern::Pattern pattern;
  pattern.name = "clamped specimen";
  pattern.panels = {rectangle("free", 0, length, width), rectangle("clamp", -clamp, 0, width)};
  pattern.panel_order = {0, 1};
  pattern::Stitch seam;
  seam.first = {0, 3};
  seam.second = {1, 1};
  seam.name = "clamp line";
  pattern.stitches = {seam};
  Specimen specimen = garment::assemble(pattern, edge_length, material);
  for (const auto& corners : specimen.triangle_uv)
    specimen.triangle_built_in.push_back((corners[0] + corners[1] + corners[2])[0] < 0);
  return specimen;
}

std::vector<int> clamped_vertices(const Specimen& specimen) {
  return vertices_where(specimen, [](const Vec2& p) { return p[0] < 1e-9; });
}

}  // namespace loosefit::validate
