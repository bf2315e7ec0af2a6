#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// First positions of a garment that its pattern file places [m]: its panels are arranged round
/// this body (drape/arrange_panels.h), then sewn there (close_seams). Cuts nothing of itself.
/// has_wider: whether the wearer can hold the limbs farther apart; if not, a seam that would go
/// through a limb is left there, for what follows to free or to certify. \throws dress::NoRoom when
/// panels still cut each other, or seams would go through a limb of a wearer who has wider
/// postures; GeometryError when the pattern lacks a panel.
std::vector<Vec3> sew_on(const garment::Garment& garment, const pattern::Pattern& pattern,
                         const body::PosedBody& body, bool has_wider = false);

}  // namespace loosefit::drape
