#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Index of the panel of that name. \throws InvalidInput without a place: no such panel, with the
/// nearest name that there is.
int named_panel(const Pattern& pattern, const std::string& name);

/// The edge that a file or scenario calls "PANEL.EDGE". Names of panels may have dots; the last one
/// ends them. \throws InvalidInput without a place: no such text, panel or edge, with the nearest
/// name that there is.
Stitch::Side named_edge(const Pattern& pattern, const std::string& name);

/// An elastic and the edges that it is sewn to.
struct NamedElastic {
  std::vector<std::string> edges;
  EdgeElastic elastic;
  bool operator==(const NamedElastic&) const = default;
};

/// Sews it on, each edge with a tape of its own. \throws as named_edge, and for an edge that has
/// one.
void add_elastic(Pattern& pattern, const NamedElastic& named);

}  // namespace loosefit::pattern
