#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::dress {

/// First positions of a garment of no kind that is laid round the body [m]: the placement that its
/// pattern file gives to the panels, seams closed at the mean of their sides. Panels that cut each
/// other or lie in the body are moved along their outside normals, by up to 0.3 m, until none does
/// (of two that look the same way, the later one); seams that then still pass through the body are
/// left to contact.
/// \throws GeometryError when that does not part them, or the pattern lacks a panel.
std::vector<Vec3> dress_as_placed(const garment::Garment& garment, const pattern::Pattern& pattern,
                                  const body::PosedBody& body);

}  // namespace loosefit::dress
