#include "loosefit/pattern/mesher.h"

// The same order whatever standard library sorts it.
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"

namespace loosefit::pattern {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<
    bool, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;  // info: inside the panel
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

// Shares of the wanted edge length. An equilateral triangle of that edge has circumradius 0.577;
// with 0.78 the mean edge of the smoothed mesh is the wanted one.
constexpr double kLargestRadius = 0.78;
constexpr double kSpacing = 0.75;     // between interior points
constexpr double kBoundaryGap = 0.5;  // from interior points to the outline
constexpr int kMostRounds = 60;
constexpr int kSmoothingSteps = 30;

/// The rims of a panel: its outline, counter-clockwise, then its holes, likewise.
using Rims = std::vector<std::vector<Vec2>>;

int points_of(const Rims& rims) {
  std::size_t count = 0;
  for (const std::vector<Vec2>& rim : rims) count += rim.size();
  return static_cast<int>(count);
}

bool is_on_cloth(const Rims& rims, const Vec2& p) {
  return inside_polygon(rims[0], p) &&
         std::none_of(rims.begin() + 1, rims.end(),
                      [&](const std::vector<Vec2>& hole) { return inside_polygon(hole, p); });
}

double distance_to_rims(const Rims& rims, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& rim : rims)
    least = std::min(least, (closest_on_polygon(rim, p) - p).norm());
  return least;
}

/// What the mesh has to follow: the rims, then lines on the cloth.
struct Frame {
  Rims rims;
  InsetLines insets;
  MeshSizes sizes;

  double distance(const Vec2& p) const {
    return std::min(distance_to_rims(rims, p), insets.distance(p));
  }
};

/// Constrained Delaunay triangulation of the frame and the points on the cloth. The points begin
/// with those of the frame.
struct Triangulation {
  Cdt cdt;
  std::vector<Triangle> triangles;

  Triangulation(const std::vector<Vec2>& points, const Frame& frame) {
    const Rims& rims = frame.rims;
    std::vector<Cdt::Vertex_handle> handles;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto near = handles.empty() ? Cdt::Face_handle() : handles.back()->face();
      handles.push_back(cdt.insert({points[i].x(), points[i].y()}, near));
      handles.back()->info() = static_cast<int>(i);
    }
    std::size_t first = 0;
    for (const std::vector<Vec2>& rim : rims) {
      for (std::size_t i = 0; i < rim.size(); ++i)
        cdt.insert_constraint(handles[first + i], handles[first + (i + 1) % rim.size()]);
      first += rim.size();
    }
    for (const auto& [a, b] : frame.insets.segments)
      cdt.insert_constraint(handles[first + a], handles[first + b]);
    for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f) f->info() = true;
    // Faces reached from infinity, or from within a hole, without crossing a rim are no cloth.
    clear_from(cdt.infinite_face());
    first = rims[0].size();
    for (std::size_t r = 1; r < rims.size(); first += rims[r++].size())
      clear_from(left_of(handles[first], handles[first + 1]));
    for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
      if (f->info())
        triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

 private:
  void clear_from(Cdt::Face_handle start) {
    std::vector<Cdt::Face_handle> open{start};
    start->info() = false;
    while (!open.empty()) {
      const Cdt::Face_handle face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Cdt::Face_handle other = face->neighbor(i);
        if (!other->info() || cdt.is_constrained({face, i})) continue;
        other->info() = false;
        open.push_back(other);
      }
    }
  }

  /// The face on the left of an edge of the triangulation.
  Cdt::Face_handle left_of(Cdt::Vertex_handle a, Cdt::Vertex_handle b) const {
    Cdt::Face_handle face;
    int opposite = 0;
    require(cdt.is_edge(a, b, face, opposite), "the rim of a hole runs along edges of its mesh");
    const bool left = face->vertex(Cdt::ccw(opposite)) == a;
    return left ? face : face->neighbor(opposite);
  }
};

double circumradius(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double twice_area = std::abs(geometry::cross(b - a, c - a));
  return twice_area > 0 ? (b - a).norm() * (c - b).norm() * (a - c).norm() / (2 * twice_area)
                        : std::numeric_limits<double>::infinity();
}

Vec2 circumcentre(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  const double d = 2 * geometry::cross(u, v);
  return a + Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                  u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                 d;
}

/// A triangle that is too large and where it would be split.
struct Candidate {
  double radius;  ///< times the largest wanted edge length by that wanted here [m]
  Vec2 centre, centroid;
};

/// Points with a least distance, in a grid of the largest such distance.
class SpacedPoints {
 public:
  explicit SpacedPoints(double largest) : distance_(largest) {}
  /// \pre distance ≤ the largest
  bool free(const Vec2& p, double distance) const {
    const auto [i, j] = cell(p);
    for (long long di = -1; di <= 1; ++di)
      for (long long dj = -1; dj <= 1; ++dj) {
        const auto found = cells_.find({i + di, j + dj});
        if (found == cells_.end()) continue;
        for (const Vec2& q : found->second)
          if ((q - p).norm() < distance) return false;
      }
    return true;
  }
  void add(const Vec2& p) { cells_[cell(p)].push_back(p); }

 private:
  std::pair<long long, long long> cell(const Vec2& p) const {
    return {static_cast<long long>(std::floor(p.x() / distance_)),
            static_cast<long long>(std::floor(p.y() / distance_))};
  }
  double distance_;  ///< size of a cell
  std::map<std::pair<long long, long long>, std::vector<Vec2>> cells_;
};

/// Adds circumcentres of triangles that are too large until there are none left. Points keep their
/// distance from each other and from the frame, which is why this ends, however thin the panel. The
/// first `fixed` are those of the frame.
void refine(std::vector<Vec2>& points, int fixed, const Frame& frame) {
  const MeshSizes& sizes = frame.sizes;
  SpacedPoints spaced(kSpacing * sizes.largest());
  for (std::size_t i = fixed; i < points.size(); ++i) spaced.add(points[i]);
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<Candidate> candidates;
    for (const auto& [a, b, c] : Triangulation(points, frame).triangles) {
      const double radius = circumradius(points[a], points[b], points[c]);
      const Vec2 centroid = (points[a] + points[b] + points[c]) / 3;
      const double size = sizes.at(centroid);
      if (radius <= kLargestRadius * size) continue;
      const Vec2 centre = circumcentre(points[a], points[b], points[c]);
      const bool near = centre.allFinite() && (centre - centroid).norm() < 1e3 * size;
      candidates.push_back({radius * (sizes.largest() / size), near ? centre : centroid, centroid});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& p, const auto& q) { return p.radius > q.radius; });
    const std::size_t before = points.size();
    for (const auto& [radius, centre, centroid] : candidates) {
      if (!spaced.free(centre, kSpacing * sizes.at(centre))) continue;
      // A flat triangle at the outline has its circumcentre outside: its own centre will do.
      const Vec2& p = is_on_cloth(frame.rims, centre) ? centre : centroid;
      if (!spaced.free(p, kSpacing * sizes.at(p)) || frame.distance(p) < kBoundaryGap * sizes.at(p))
        continue;
      spaced.add(p);
      points.push_back(p);
    }
    if (points.size() == before) return;
  }
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
/// Areas count by the wanted ones, so that points stay as close together as they were put.
void smooth(std::vector<Vec2>& points, const std::vector<Triangle>& triangles, int fixed,
            const MeshSizes& sizes) {
  const auto twice_area = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return geometry::cross(b - a, c - a);
  };
  std::vector<std::vector<int>> around(points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int v : triangles[t])
      if (v >= fixed) around[v].push_back(static_cast<int>(t));
  for (std::size_t v = fixed; v < points.size(); ++v) {
    Vec2 sum = Vec2::Zero();
    double weight = 0;
    for (const int t : around[v]) {
      const auto [a, b, c] = triangles[t];
      const Vec2 centroid = (points[a] + points[b] + points[c]) / 3;
      const double w = twice_area(points[a], points[b], points[c]) * sizes.density(centroid);
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

/// Neighbours in the panel become neighbours in the list: by their centroids along a Hilbert curve.
void sort_along_curve(std::vector<Triangle>& triangles, const std::vector<Vec2>& points) {
  using Points = std::vector<Kernel::Point_2>;
  using Traits =
      CGAL::Spatial_sort_traits_adapter_2<Kernel,
                                          CGAL::Pointer_property_map<Points::value_type>::type>;
  Points centroids;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 centroid = (points[a] + points[b] + points[c]) / 3;
    centroids.emplace_back(centroid.x(), centroid.y());
  }
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(centroids)));
  std::vector<Triangle> sorted;
  for (const std::size_t t : order) sorted.push_back(triangles[t]);
  triangles.swap(sorted);
}

}  // namespace

PanelMesh mesh_panel(const Panel& panel, const std::vector<int>& divisions, double edge_length,
                     const std::vector<MeshInset>& insets) {
  const std::vector<Vec2> outline = divided_outline(panel, divisions);
  const int n = static_cast<int>(outline.size());
  if (n < 3 || first_self_crossing(outline).first >= 0)
    throw GeometryError(InputPlace{{}, 0, "panel " + panel.name},
                        fmt::format("an outline of {} points that is not simple", n),
                        "a simple outline");

  Frame frame{{outline}, {}, MeshSizes(edge_length, insets)};
  Rims& rims = frame.rims;
  std::vector<PanelHole> cut;
  PanelMesh mesh;
  for (const PanelHole& hole : panel.holes) {
    DividedHole divided = divided_hole(hole, edge_length);
    const PanelHole as_divided{hole.name, divided.points};
    if (const std::string fault = hole_place_fault(as_divided, outline, cut); !fault.empty())
      throw GeometryError(InputPlace{{}, 0, "panel " + panel.name + " hole " + hole.name}, fault,
                          "a hole within the outline, apart from it and from other holes",
                          "take a smaller edge_length");
    cut.push_back(as_divided);
    std::vector<int> chain(divided.points.size());
    std::iota(chain.begin(), chain.end(), points_of(rims));
    mesh.holes.push_back({std::move(chain), std::move(divided.along)});
    rims.push_back(std::move(divided.points));
  }
  std::vector<Vec2> points;
  for (const std::vector<Vec2>& rim : rims) points.insert(points.end(), rim.begin(), rim.end());
  for (const MeshInset& inset : insets)
    frame.insets.add(inset, kBoundaryGap, [&](const Vec2& p) {
      return is_on_cloth(rims, p) ? distance_to_rims(rims, p) : 0.0;
    });
  points.insert(points.end(), frame.insets.points.begin(), frame.insets.points.end());
  const int fixed = static_cast<int>(points.size());
  std::vector<Triangle> triangles;
  // Smoothing takes points to where they are wanted close together; what is missing then elsewhere
  // is added, and smoothed once more.
  for (int pass = 0; pass < (insets.empty() ? 1 : 2); ++pass) {
    refine(points, fixed, frame);
    triangles = Triangulation(points, frame).triangles;
    for (int step = 0; step < kSmoothingSteps; ++step) {
      // Chords are broken between sweeps, too, so that the new points find their place.
      if (step % 5 == 0)
        break_chords(points, triangles, n);
      else
        smooth(points, triangles, fixed, frame.sizes);
      triangles = Triangulation(points, frame).triangles;
    }
  }
  for (int round = 0; round < 8 && break_chords(points, triangles, n); ++round)
    triangles = Triangulation(points, frame).triangles;

  sort_along_curve(triangles, points);

  mesh.vertices = points;
  mesh.triangles = triangles;
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

}  // namespace loosefit::pattern
