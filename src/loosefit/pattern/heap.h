#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Whether the panels of a pattern lie in a heap instead of round somebody: several of them, all at
/// the origin, or more than half of them in one plane, each with more than half of its box on that
/// of another one there. Pockets, facings and linings that lie on fronts and backs are no heap.
bool lies_in_a_heap(const Pattern& pattern);

}  // namespace loosefit::pattern
