#include "loosefit/lines/course.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/geometry/path_graph.h"
#include "loosefit/geometry/straighten_path.h"

namespace loosefit::lines {
namespace {

using placement::GarmentPoint;

constexpr double kSamePlace = 1e-6;  ///< [m]

Vec2 flat_place(const garment::Garment& garment, int triangle, const Vec3& w) {
  const auto& uv = garment.triangle_uv[triangle];
  return w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2];
}

double cut_length(const garment::Garment& garment, const geometry::PathPiece& piece) {
  return (flat_place(garment, piece.triangle, piece.to) -
          flat_place(garment, piece.triangle, piece.from))
      .norm();
}

/// One piece of the pattern by itself, cut open at its seams, also those with itself.
struct OpenPanel {
  std::vector<int> triangles;  ///< of the garment
  std::vector<int> own;        ///< per triangle of the garment; −1: of another piece
  geometry::PathSurface surface;
};

OpenPanel open_panel(const garment::Garment& garment, int panel) {
  std::vector<int> triangles, own(garment.triangles.size(), -1);
  std::vector<Triangle> corners;
  std::vector<geometry::FlatCorners> flat;
  std::map<std::pair<double, double>, int> vertex;  // by its place in the pattern
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (garment.triangle_panel[t] != panel) continue;
    own[t] = static_cast<int>(triangles.size());
    triangles.push_back(t);
    flat.push_back(garment.triangle_uv[t]);
    Triangle& corner = corners.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Vec2& at = garment.triangle_uv[t][k];
      corner[k] =
          vertex.try_emplace({at.x(), at.y()}, static_cast<int>(vertex.size())).first->second;
    }
  }
  return {triangles, own, geometry::PathSurface(corners, flat)};
}

geometry::SurfacePath straight_way(const garment::Garment& garment, const GarmentPoint& from,
                                   const GarmentPoint& to) {
  const int panel = garment.triangle_panel[from.triangle];
  const std::string& name = garment.panel_names[panel];
  if (garment.triangle_panel[to.triangle] != panel)
    throw InvalidInput({"", 0, "course"},
                       "a straight line from panel " + name + " to panel " +
                           garment.panel_names[garment.triangle_panel[to.triangle]],
                       "stops in one panel", "course = \"shortest\" goes across seams");
  const OpenPanel piece = open_panel(garment, panel);
  const auto way = geometry::cheapest_path(
      piece.surface, {piece.own[from.triangle], from.barycentric},
      {piece.own[to.triangle], to.barycentric},
      [&](const geometry::PathPiece& p) { return piece.surface.length(p); });
  const double straight =
      (placement::pattern_place(garment, to) - placement::pattern_place(garment, from)).norm();
  if (way) {
    geometry::SurfacePath taut = geometry::straighten_path(piece.surface, *way);
    for (geometry::PathPiece& p : taut) p.triangle = piece.triangles[p.triangle];
    double length = 0;
    for (const geometry::PathPiece& p : taut) length += cut_length(garment, p);
    if (length <= straight + kSamePlace) return taut;
  }
  throw InvalidInput({"", 0, "course"}, "a straight line that leaves panel " + name,
                     "one that stays in it", "a stop on the way leads round the outline");
}

geometry::SurfacePath shortest_way(const geometry::PathSurface& surface, const GarmentPoint& from,
                                   const GarmentPoint& to) {
  const auto way = geometry::cheapest_path(
      surface, {from.triangle, from.barycentric}, {to.triangle, to.barycentric},
      [&](const geometry::PathPiece& piece) { return surface.length(piece); });
  if (!way)
    throw InvalidInput({"", 0, "to"}, "a place to which no cloth leads",
                       "stops on cloth that hangs together", "");
  return geometry::straighten_path(surface, *way);
}

}  // namespace

geometry::PathSurface flat_surface(const garment::Garment& garment) {
  return {garment.triangles, garment.triangle_uv};
}

LineCourse course_along(const garment::Garment& garment, const geometry::SurfacePath& path,
                        const std::vector<GarmentPoint>& stops, double part) {
  LineCourse course;
  course.stops = stops;
  for (const geometry::PathPiece& piece : path) course.length += cut_length(garment, piece);
  if (!(course.length > kSamePlace))
    throw InvalidInput({"", 0, "to"}, "a line without length", "stops that are apart", "");
  course.parts = std::max(1, static_cast<int>(std::lround(course.length / part)));
  // Pieces are cut where a part ends.
  const double step = course.part_length();
  double begin = 0;
  int now = 0;
  for (geometry::PathPiece piece : path) {
    double left = cut_length(garment, piece);
    while (now + 1 < course.parts && begin + left > (now + 1) * step) {
      const double first = std::max(0.0, (now + 1) * step - begin), share = first / left;
      const Vec3 border = piece.from + share * (piece.to - piece.from);
      if (first > 0) course.pieces.push_back({{piece.triangle, piece.from, border}, first, now});
      piece.from = border;
      begin += first;
      left -= first;
      ++now;
    }
    if (left > 0) course.pieces.push_back({piece, left, now});
    begin += left;
  }
  return course;
}

LineCourse lay_course(const garment::Garment& garment, const geometry::PathSurface& surface,
                      const std::vector<GarmentPoint>& stops, placement::LineSpec::Course course,
                      double part) {
  geometry::SurfacePath whole;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const geometry::SurfacePath leg = course == placement::LineSpec::Course::straight
                                          ? straight_way(garment, stops[i], stops[i + 1])
                                          : shortest_way(surface, stops[i], stops[i + 1]);
    whole.insert(whole.end(), leg.begin(), leg.end());
  }
  return course_along(garment, whole, stops, part);
}

std::vector<PanelStretch> stretches(const garment::Garment& garment, const LineCourse& course) {
  constexpr double kBend = 1e-6;  ///< aside of a straight line [m]
  std::vector<PanelStretch> all;
  for (const CoursePiece& piece : course.pieces) {
    const int panel = garment.triangle_panel[piece.triangle];
    const Vec2 from = flat_place(garment, piece.triangle, piece.from),
               to = flat_place(garment, piece.triangle, piece.to);
    const bool goes_on = !all.empty() && all.back().panel == panel &&
                         (all.back().points.back() - from).norm() < 10 * kSamePlace;
    if (!goes_on) all.push_back({panel, {from}});
    std::vector<Vec2>& points = all.back().points;
    if (points.size() >= 2) {
      const Vec2 before = points[points.size() - 2], along = (to - before).normalized();
      if (std::abs(geometry::cross(along, points.back() - before)) < kBend &&
          along.dot(points.back() - before) >= 0)
        points.pop_back();
    }
    points.push_back(to);
  }
  return all;
}

std::vector<Vec3> in_space(const garment::Garment& garment, const LineCourse& course,
                           const std::vector<Vec3>& positions) {
  std::vector<Vec3> points;
  for (const CoursePiece& piece : course.pieces) {
    const GarmentPoint from{piece.triangle, piece.from}, to{piece.triangle, piece.to};
    if (points.empty()) points.push_back(placement::at(garment, from, positions));
    points.push_back(placement::at(garment, to, positions));
  }
  return points;
}

}  // namespace loosefit::lines
