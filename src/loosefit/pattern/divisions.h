#pragma once
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Number of mesh segments of every edge of every panel for a wanted edge length [m]: the two sides
/// of a seam get the count of the longer one, free edges their own, all at least 1. Raised where a
/// small piece needs more to keep a simple outline.
/// \throws InvalidInput edge length not positive or far too small for the pattern;
///         GeometryError when an outline is not simple, or an edge is sewn twice.
std::vector<std::vector<int>> edge_divisions(const Pattern& pattern, double edge_length);
/// The same with a wanted edge length for each panel: a seam has the count of the finer one.
std::vector<std::vector<int>> edge_divisions(const Pattern& pattern,
                                             const std::vector<double>& edge_lengths);

/// Outline points of a panel, each edge divided evenly in arc length; first point = start of edge
/// 0.
std::vector<Vec2> divided_outline(const Panel& panel, const std::vector<int>& divisions);

}  // namespace loosefit::pattern
