#pragma once
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Edges of a panel from one corner that sticks out to the next: a side, a hem, a neckline.
struct Section {
  int first = 0, count = 1;  ///< edges, in the order of the outline, over its end if need be
  double length = 0;         ///< along the edges [m]
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< its ends [m]
  double bulge = 0;  ///< area between it and its chord / chord², positive where it bulges outwards

  double chord() const { return (to - from).norm(); }
  /// Its edges as sides of a seam.
  std::vector<Stitch::Side> sides(const Panel& panel, int panel_index) const;
};

/// Sections of an outline in order. Corners that stick out by more than 30 degrees part them;
/// others (the tip of a V-neck, points where a curve was cut) lie within. An outline with fewer
/// than two such corners has one section per edge.
std::vector<Section> outline_sections(const Panel& panel);

/// Points along a section, ends included; its edges sampled.
std::vector<Vec2> section_points(const Panel& panel, const Section& section);
/// How far it lies off its chord, at most [m].
double section_depth(const Panel& panel, const Section& section);

}  // namespace loosefit::pattern
