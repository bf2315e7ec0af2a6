#pragma once
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// Rectangle [0, length] × [0, width] clamped along x = 0: it continues to x = −clamp, where every
/// vertex is held, and x = 0 is a line of the mesh (a seam), so that the free length is exact.
/// The triangles in the clamp are built in (Garment::triangle_built_in).
Specimen cut_clamped_rectangle(double length, double width, double clamp, double edge_length,
                               const fabric::Material& material);
/// The vertices in the clamp, x ≤ 0.
std::vector<int> clamped_vertices(const Specimen& specimen);

}  // namespace loosefit::validate
