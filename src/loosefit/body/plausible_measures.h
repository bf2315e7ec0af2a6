#pragma once
#include <string>
#include <vector>

namespace loosefit::body {

/// What living people of 3 years and more measure, with a margin [m].
struct PlausibleMeasure {
  std::string name;  ///< one of measure_names()
  double low, high;
};

/// One for each of measure_names(). Scenarios, studies, the command line and Python ask here.
const std::vector<PlausibleMeasure>& plausible_measures();

/// \throws InvalidInput for an unknown name, with a did-you-mean.
const PlausibleMeasure& plausible_measure(const std::string& name);

}  // namespace loosefit::body
