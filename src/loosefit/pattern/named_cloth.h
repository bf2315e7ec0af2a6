#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// What some panels of a pattern are made of: a rib knit, a folded band, an interfaced collar.
struct NamedCloth {
  std::vector<std::string> panels;
  PanelCloth cloth;
  bool operator==(const NamedCloth&) const = default;
};

/// Makes the panels of it, in place of what the pattern says. \throws InvalidInput without a place:
/// no such panel, with the nearest name that there is.
void set_cloth(Pattern& pattern, const NamedCloth& named);

/// Cloth of so many layers, `stiffness` times as stiff in its plane as one layer of the garment's
/// fabric. In bending it is never softer than that: a mesh has no hinges softer than the fabric's.
PanelCloth cloth_of_layers(double layers, double stiffness);

}  // namespace loosefit::pattern
