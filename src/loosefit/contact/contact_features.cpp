#include "loosefit/contact/contact_features.h"

#include <algorithm>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::contact {
namespace {

void expect_length(const char* key, std::size_t found, std::size_t expected,
                   const char* of = "triangles") {
  if (found != expected)
    throw InvalidInput(InputPlace{"", 0, key}, std::to_string(found) + " numbers",
                       "one for each of " + std::to_string(expected) + " " + of);
}

/// Adds a third of a triangle to a feature at it.
void share(const ContactFeatures::Properties& triangle, ContactFeatures::Properties& feature,
           bool is_first) {
  const double part = triangle.area / 3;
  if (is_first) feature.layer = triangle.layer;
  const double area = feature.area + part;
  // Without any area the mean is that of the first triangle.
  feature.thickness = is_first ? triangle.thickness
                      : area > 0
                          ? (feature.area * feature.thickness + part * triangle.thickness) / area
                          : feature.thickness;
  feature.area = area;
}

constexpr double kRestShare = 0.5;    ///< of the distance at rest, at which features repel [–]
constexpr double kLeastReach = 1e-4;  ///< of features that touch at rest [m]

}  // namespace

double ContactFeatures::reach(const FeaturePair& pair) const {
  const bool edges_meet = pair.kind == PairKind::edge_edge;
  const Properties& first = edges_meet ? of_edge[pair.first] : of_vertex[pair.first];
  const Properties& second = edges_meet ? of_edge[pair.second] : of_triangle[pair.second];
  const double thickness = 0.5 * (first.thickness + second.thickness);
  if (rest_positions.empty()) return thickness;
  const double at_rest = pair_distance(pair.kind, pair.points(rest_positions)).distance;
  return std::min(thickness, std::max(kRestShare * at_rest, kLeastReach));
}

ContactFeatures::ContactFeatures(const std::vector<Triangle>& all,
                                 const std::vector<double>& triangle_area, int particles,
                                 double thickness, const std::vector<double>& triangle_thickness,
                                 const std::vector<int>& triangle_layer, std::vector<Vec3> rest)
    : triangles(all),
      of_triangle(all.size()),
      of_vertex(particles),
      rest_positions(std::move(rest)) {
  expect_length("triangle_area", triangle_area.size(), all.size());
  if (!triangle_thickness.empty())
    expect_length("triangle_thickness", triangle_thickness.size(), all.size());
  if (!triangle_layer.empty()) expect_length("triangle_layer", triangle_layer.size(), all.size());
  if (!rest_positions.empty()) expect_length("rest", rest_positions.size(), particles, "particles");
  for (std::size_t t = 0; t < all.size(); ++t) {
    Properties& p = of_triangle[t];
    p.area = triangle_area[t];
    p.thickness = triangle_thickness.empty() ? thickness : triangle_thickness[t];
    p.layer = triangle_layer.empty() ? 0 : triangle_layer[t];
    if (!(p.thickness > 0))
      throw InvalidInput(InputPlace{"", 0, "thickness"}, std::to_string(p.thickness),
                         "a positive length in metres");
    if (p.layer < 0)
      throw InvalidInput(InputPlace{"", 0, "triangle_layer"}, std::to_string(p.layer),
                         "0 or a positive number");
    max_thickness = std::max(max_thickness, p.thickness);
  }

  const std::array<int, 3> none{-1, -1, -1};
  owned_vertices.assign(all.size(), none);
  owned_edges.assign(all.size(), none);
  const geometry::MeshTopology topology(all);
  edges = topology.edges();
  of_edge.resize(edges.size());
  std::vector<char> vertex_met(particles, 0), edge_met(edges.size(), 0);
  for (std::size_t t = 0; t < all.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = all[t][k], e = topology.edge(static_cast<int>(t), k);
      share(of_triangle[t], of_vertex[v], !vertex_met[v]);
      share(of_triangle[t], of_edge[e], !edge_met[e]);
      if (!vertex_met[v]) owned_vertices[t][k] = v;
      if (!edge_met[e]) owned_edges[t][k] = e;
      vertex_met[v] = edge_met[e] = 1;
    }
  for (auto& owned : owned_vertices)
    for (int& v : owned)
      if (v >= 0 && !(of_vertex[v].area > 0)) v = -1;
}

}  // namespace loosefit::contact
