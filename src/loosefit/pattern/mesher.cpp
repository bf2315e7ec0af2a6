#include "loosefit/pattern/mesher.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/outline.h"

namespace loosefit {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexInfo = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel, VertexInfo>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;

// Largest edge over wanted edge: with it the mean edge of the smoothed mesh is the wanted one.
constexpr double kLargestEdge = 1.5;
constexpr double kShapeBound = 0.125;  // asks for angles above 20.7°
constexpr int kSmoothingSteps = 30;
constexpr double kBoundaryGap = 0.5;  // interior points keep this share of an edge from the outline

/// Constrained Delaunay triangulation of the outline and the points inside it.
struct Triangulation {
  Cdt cdt;
  std::vector<Triangle> triangles;

  Triangulation(const std::vector<Vec2>& points, int outline) {
    std::vector<Cdt::Vertex_handle> handles;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto near = handles.empty() ? Cdt::Face_handle() : handles.back()->face();
      handles.push_back(cdt.insert({points[i].x(), points[i].y()}, near));
      handles.back()->info() = static_cast<int>(i);
    }
    for (int i = 0; i < outline; ++i) cdt.insert_constraint(handles[i], handles[(i + 1) % outline]);
    mark_inside();
    for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
      if (f->is_in_domain())
        triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

 private:
  /// Faces reached from infinity without crossing the outline are outside.
  void mark_inside() {
    for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f) f->set_in_domain(true);
    std::vector<Cdt::Face_handle> open{cdt.infinite_face()};
    cdt.infinite_face()->set_in_domain(false);
    while (!open.empty()) {
      const Cdt::Face_handle face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Cdt::Face_handle other = face->neighbor(i);
        if (!other->is_in_domain() || cdt.is_constrained({face, i})) continue;
        other->set_in_domain(false);
        open.push_back(other);
      }
    }
  }
};

/// Interior points of a refined triangulation; those it put on the outline are left out.
std::vector<Vec2> refined_interior(const std::vector<Vec2>& outline, double edge_length) {
  Triangulation start(outline, static_cast<int>(outline.size()));
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(start.cdt,
                                                Criteria(kShapeBound, kLargestEdge * edge_length));
  mesher.init();
  mesher.refine_mesh();
  std::vector<Vec2> interior;
  for (auto v = start.cdt.finite_vertices_begin(); v != start.cdt.finite_vertices_end(); ++v) {
    if (start.cdt.are_there_incident_constraints(v)) continue;
    interior.emplace_back(v->point().x(), v->point().y());
  }
  return interior;
}

/// Interior points closer than this share of an edge to the outline make flat triangles there.
void drop_points_near_outline(std::vector<Vec2>& interior, const std::vector<Vec2>& outline,
                              double edge_length) {
  std::erase_if(interior, [&](const Vec2& p) {
    return !inside_polygon(outline, p) ||
           (closest_on_polygon(outline, p) - p).norm() < kBoundaryGap * edge_length;
  });
}

/// Inner edges between two outline points would join two seams, and weld twice where both panels
/// have one; an extra point in their middle avoids it. Cut-off corners (one outline point skipped)
/// are harmless. Returns true when points were added.
bool break_chords(std::vector<Vec2>& points, const std::vector<Triangle>& triangles, int outline) {
  const std::size_t before = points.size();
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (a > b || b >= outline) continue;  // an inner edge is seen from both sides: take one
      const int apart = std::min(b - a, outline - (b - a));
      if (apart > 2) points.push_back((points[a] + points[b]) / 2);
    }
  return points.size() > before;
}

/// One sweep: every interior point to the area centroid of its triangles, unless one would flip.
void smooth(std::vector<Vec2>& points, const std::vector<Triangle>& triangles, int outline) {
  const auto twice_area = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  };
  std::vector<std::vector<int>> around(points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int v : triangles[t])
      if (v >= outline) around[v].push_back(static_cast<int>(t));
  for (std::size_t v = outline; v < points.size(); ++v) {
    Vec2 sum = Vec2::Zero();
    double weight = 0;
    for (const int t : around[v]) {
      const auto [a, b, c] = triangles[t];
      const double w = twice_area(points[a], points[b], points[c]);
      sum += w * (points[a] + points[b] + points[c]) / 3;
      weight += w;
    }
    if (!(weight > 0)) continue;
    const Vec2 old = points[v];
    points[v] = sum / weight;
    for (const int t : around[v]) {
      const auto [a, b, c] = triangles[t];
      if (twice_area(points[a], points[b], points[c]) > 0) continue;
      points[v] = old;
      break;
    }
  }
}

}  // namespace

PanelMesh mesh_panel(const Panel& panel, const std::vector<int>& divisions, double edge_length) {
  const std::vector<Vec2> outline = divided_outline(panel, divisions);
  const int n = static_cast<int>(outline.size());
  if (n < 3 || first_self_crossing(outline).first >= 0)
    throw GeometryError(InputPlace{{}, 0, "panel " + panel.name},
                        fmt::format("an outline of {} points that is not simple", n),
                        "a simple outline");

  std::vector<Vec2> interior = refined_interior(outline, edge_length);
  drop_points_near_outline(interior, outline, edge_length);
  std::vector<Vec2> points = outline;
  points.insert(points.end(), interior.begin(), interior.end());
  std::vector<Triangle> triangles = Triangulation(points, n).triangles;
  for (int step = 0; step < kSmoothingSteps; ++step) {
    // Chords are broken between sweeps, too, so that the new points find their place.
    if (step % 5 == 0)
      break_chords(points, triangles, n);
    else
      smooth(points, triangles, n);
    triangles = Triangulation(points, n).triangles;
  }
  for (int round = 0; round < 8 && break_chords(points, triangles, n); ++round)
    triangles = Triangulation(points, n).triangles;

  PanelMesh mesh{points, triangles, {}};
  int first = 0;
  for (const int count : divisions) {
    std::vector<int> chain;
    for (int i = 0; i <= count; ++i) chain.push_back((first + i) % n);
    mesh.edge_vertices.push_back(chain);
    first += count;
  }
  if (!(mesh_quality(mesh).smallest_angle > 1e-6))
    throw GeometryError(InputPlace{{}, 0, "panel " + panel.name}, "a triangle without area",
                        "a panel wide enough to be meshed");
  return mesh;
}

}  // namespace loosefit
