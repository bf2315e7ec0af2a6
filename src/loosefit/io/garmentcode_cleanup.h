#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// Edges must follow each other by vertex index; where a file lists a position twice, the second
/// index is replaced by the first. \throws GeometryError naming panel and edge where a loop is
/// open.
void close_loops(pattern::Pattern& pattern);

/// A clockwise panel is mirrored (x → −x) and turned half round y, which leaves it where it is in
/// space and its outside outside.
void make_counter_clockwise(pattern::Panel& panel);

/// Order by the names given; the rest by GarmentCode's rule: 3D top-middle point by x, y, z (file
/// frame), values closer than 10 cm counting as equal.
void set_panel_order(pattern::Pattern& pattern, const std::vector<std::string>& names);

}  // namespace loosefit::io
