#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// First positions of a garment that its pattern file places [m]: its panels are arranged round
/// this body (drape/arrange_panels.h), then sewn there (close_seams). Cuts nothing of itself.
/// \throws dress::NoRoom when panels still cut each other, GeometryError when the pattern lacks a
/// panel.
std::vector<Vec3> sew_on(const garment::Garment& garment, const pattern::Pattern& pattern,
                         const body::PosedBody& body);

}  // namespace loosefit::drape
