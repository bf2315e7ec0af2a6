#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// Consecutive edges of the same non-empty name become one edge if their seams allow it: all parts
/// sewn, in order, to all parts of one other edge, or none sewn. Otherwise they stay apart as
/// name_1, name_2, …. Afterwards every edge and stitch has a unique name.
void merge_named_edges(pattern::Pattern& pattern);

}  // namespace loosefit::io
