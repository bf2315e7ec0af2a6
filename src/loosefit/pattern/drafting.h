#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/pattern/curve_chain.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// A panel of a draft from its edges in order, counter-clockwise, each beginning where the last one
/// ends; name and part of panel and edges are the same.
Panel draft_panel(const std::string& name, const std::string& label,
                  const std::vector<std::pair<std::string, CurveChain>>& loop);

/// Adds the seam between two edges by name; the end of one meets the start of the other.
void sew_edges(Pattern& pattern, const std::string& name, const std::string& panel_a,
               const std::string& edge_a, const std::string& panel_b, const std::string& edge_b);

}  // namespace loosefit::pattern
