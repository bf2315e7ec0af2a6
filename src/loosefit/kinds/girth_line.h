#pragma once
#include <optional>
#include <vector>

namespace loosefit::kinds {

/// Girth of a body at a place along a limb [m].
struct GirthAt {
  double along = 0, girth = 0;
  bool operator==(const GirthAt&) const = default;
};

/// Girths down a limb, in the order of `along`.
using GirthLine = std::vector<GirthAt>;

/// Girths of one person. Trunk: by length of a tape down the back from the high point shoulder.
/// Arm: from the shoulder point, bent as it is. Leg: down from the crotch. Empty: not known.
struct GirthsAlong {
  GirthLine trunk, arm, leg;
};

/// Girth between the places of a line, even from one to the next; nothing beyond its ends.
std::optional<double> girth_at(const GirthLine& line, double along);

}  // namespace loosefit::kinds
