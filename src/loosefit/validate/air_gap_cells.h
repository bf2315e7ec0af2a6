#pragma once
#include <string>
#include <vector>

#include "loosefit/validate/benchmark.h"

namespace loosefit::validate {

/// One figure of a published table beside that of a drape.
struct AirGapCell {
  std::string source;                   ///< paper and table: cells of one are judged together
  std::string quantity;                 ///< "gap" or "contact"
  std::string unit;                     ///< "mm", "%"
  double published = 0, deviation = 0;  ///< standard deviation; 0: not told
  double draped = 0;
};

/// Verdict on the cells of each source and quantity, in their order: Spearman's rank over the cells
/// (four or more), share of the cells within published mean ± 2 deviations (of those that tell
/// one), mean difference. The bands were set before any table was opened (docs/theory/air_gap.md
/// 4).
std::vector<Finding> judge_cells(const std::vector<AirGapCell>& cells, const std::string& mesh);

}  // namespace loosefit::validate
