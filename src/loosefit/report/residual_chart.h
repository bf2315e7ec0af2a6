#pragma once
#include <string>
#include <vector>

#include "loosefit/drape/drape.h"

namespace loosefit::report {

/// Residual over the seconds of settling on a logarithmic scale with the tolerance as a line;
/// empty for a history of less than two samples. Inline SVG.
std::string residual_chart(const std::vector<drape::SettleSample>& history, double tolerance);

}  // namespace loosefit::report
