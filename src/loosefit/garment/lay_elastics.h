#pragma once
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::garment {

/// Adds the elastics along the edges of the panels (PanelEdge::elastic) to Garment::bands. Their
/// weight is left out: that of a tape is a tenth of that of the cloth it gathers (judgement).
void lay_elastics(Garment& garment, const pattern::Pattern& pattern);

}  // namespace loosefit::garment
