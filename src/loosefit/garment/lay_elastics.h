#pragma once
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::garment {

/// Lays the elastics along the edges of the panels (PanelEdge::elastic) into Garment::bands. The
/// cloth under them gathers by its own crimp (fabric/crimp_law.h).
void lay_elastics(Garment& garment, const pattern::Pattern& pattern);

}  // namespace loosefit::garment
