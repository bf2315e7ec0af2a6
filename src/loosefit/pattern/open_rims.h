#pragma once
#include <utility>
#include <vector>

namespace loosefit::pattern {

/// Sides of panels are numbered in the order of the outlines, panel by panel. Two that are sewn
/// together, the end of one to the start of the other.
using SidePair = std::pair<int, int>;
/// Open sides round one opening, or round the edge of one sheet, each where the one before ends.
using Rim = std::vector<int>;

/// What stays open. \param panels of every side
std::vector<Rim> rims_of(const std::vector<int>& panels, const std::vector<SidePair>& pairs);

/// Takes pairs away that shut what a limb has to go through: one between level sides of two panels
/// whose sides before and behind are sewn to each other too, as hem to hem where the sides are
/// sewn; then, as long as panels that are sewn together have fewer than two rims, the longest pair
/// of level sides without which they have more. \param level of every side: its length, 0 of a
/// steep one
void keep_open(const std::vector<int>& panels, const std::vector<double>& level,
               std::vector<SidePair>& pairs);

}  // namespace loosefit::pattern
