#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// Finds out which panel and edge of a pattern is which part of the shirt draft (shirt_draft.h) and
/// notes it in Panel::part and PanelEdge::part. It goes by how the pieces are sewn to each other,
/// by the free edges and by which piece is placed in front, not by names: two pieces of eight edges
/// with hem and neck free, joined at sides and shoulders, and two half sleeves of four edges on
/// each side. False, with the pattern unchanged, when it is not sewn like that. Sewn like the shirt
/// is not yet drafted by us: the caller must know that from elsewhere.
bool note_shirt_parts(Pattern& pattern);

/// Whether every piece and edge is noted as a part of the shirt draft.
bool has_shirt_parts(const Pattern& pattern);

/// Whether all pieces and edges are called as the draft calls its parts; after note_shirt_parts.
bool called_like_shirt_parts(const Pattern& pattern);

}  // namespace loosefit
