#pragma once
#include <string>

#include "loosefit/study/bootstrap.h"

// Figures as the page of a study writes them; a dash for what is not known.
namespace loosefit::study {

/// Cut off at 0 and 1.
std::string score(double value);
std::string score_bounds(const Bounds& b);
std::string bounds(const Bounds& b, int decimals);
/// "58 %" of a share.
std::string percent(double share);
/// The words of a metric; its name where it has none.
std::string metric_words(const std::string& metric);

}  // namespace loosefit::study
