#pragma once
#include "loosefit/geometry/path_surface.h"

namespace loosefit::geometry {

/// The shortest path that can be had from this one by pulling it taut, between the same ends: a
/// geodesic. In the triangles that it passes, laid flat, it is pulled taut by a funnel (Lee and
/// Preparata 1984). Where it then bends round a vertex on whose other side the surface measures
/// less than π, it is led round there, and pulled taut again (Xin and Wang 2007; the same as
/// flipping edges, Sharp and Crane 2020), until it bends nowhere but at vertices where both sides
/// measure π or more, or at the border. Each turn makes it shorter, so it ends.
///
/// `inside`: triangles that it may be led through; empty: all. Ends are moved into their triangle
/// by a millionth of it. \pre the path crosses edges, not vertices
SurfacePath straighten_path(const PathSurface& surface, const SurfacePath& path,
                            const std::vector<char>& inside = {});

}  // namespace loosefit::geometry
