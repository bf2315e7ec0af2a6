#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// Finds out which panel and edge of a pattern is which part of `draft`, all of whose panels hang
/// together by seams, and notes it in Panel::part and PanelEdge::part. It goes by how the pieces
/// are sewn to each other and by the free edges, not by names: panels map to panels with as many
/// edges in the same order, sewn edges to edges sewn to the same part. Of several such maps (front
/// and back, hem and neck may be sewn alike) it takes the one whose panels look the same way and
/// have their edges where the draft has them. False, with the pattern unchanged, when there is
/// none. Sewn like a draft is not yet drafted by us: the caller must know that from elsewhere.
bool match_parts(const pattern::Pattern& draft, pattern::Pattern& pattern);

}  // namespace loosefit::kinds
