#pragma once
#include <string>
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/path_surface.h"
#include "loosefit/placement/address_garment.h"
#include "loosefit/placement/line_spec.h"

namespace loosefit::lines {

/// What of a line lies in one triangle of the garment and in one part of the line.
struct CoursePiece : geometry::PathPiece {
  double cut = 0;  ///< length in the flat cloth [m]
  int part = 0;
};

/// The way of a line on a garment: the same stretch of cloth in every drape.
struct LineCourse {
  std::vector<CoursePiece> pieces;             ///< from its begin to its end
  std::vector<placement::GarmentPoint> stops;  ///< as asked for, in their order
  double length = 0;                           ///< in the flat cloth [m]
  int parts = 1;                               ///< of equal length there
  double part_length() const { return length / parts; }
};

/// A stretch of a line in one piece of the pattern.
struct PanelStretch {
  int panel = 0;
  std::vector<Vec2> points;  ///< in the pattern, only where it bends [m]
};

/// Lays a line from stop to stop (LineSpec::Course). Shortest ways are geodesics of the flat pieces
/// as they are sewn together, exact once the triangles are found that they pass
/// (geometry/straighten_path.h): straight in every piece, and straight across a seam when the
/// pieces are laid edge to edge. Cut into round(length / part) parts, at least one. \throws
/// InvalidInput, key "course", for a straight line between two pieces or across the outline of one;
/// key "to" for stops with no way between them, or in one place.
LineCourse lay_course(const garment::Garment& garment, const geometry::PathSurface& surface,
                      const std::vector<placement::GarmentPoint>& stops,
                      placement::LineSpec::Course course, double part);

/// The same of a way that is known.
LineCourse course_along(const garment::Garment& garment, const geometry::SurfacePath& path,
                        const std::vector<placement::GarmentPoint>& stops, double part);

/// The surface on which ways are measured: of the garment's flat pieces.
geometry::PathSurface flat_surface(const garment::Garment& garment);

/// A line piece by piece of the pattern, in its order.
std::vector<PanelStretch> stretches(const garment::Garment& garment, const LineCourse& course);

/// A line as points in space, in a drape [m].
std::vector<Vec3> in_space(const garment::Garment& garment, const LineCourse& course,
                           const std::vector<Vec3>& positions);

}  // namespace loosefit::lines
