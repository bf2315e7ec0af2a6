#pragma once
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::garment {

/// Lays the elastics along the edges of the panels (PanelEdge::elastic): the tapes into
/// Garment::bands, the cloth under them into triangle_gathered, for cloth that pushed would carry a
/// tape's tension by itself and keep it from the body. The weight of tapes is left out.
void lay_elastics(Garment& garment, const pattern::Pattern& pattern);

}  // namespace loosefit::garment
