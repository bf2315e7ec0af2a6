#include "loosefit/pattern/shirt_kinds.h"

namespace loosefit {

const std::vector<std::string>& shirt_kinds() {
  static const std::vector<std::string> kKinds = {"long-sleeve-shirt", "t-shirt"};
  return kKinds;
}

ShirtFit usual_fit(const std::string& kind) {
  ShirtFit fit{.chest = 0.10, .waist = {}, .hip = 0.08, .sleeve = 0.15, .wrist = 0.20};
  if (kind == "t-shirt") fit.wrist = 0.12, fit.sleeve_length = 0.36;
  return fit;
}

}  // namespace loosefit
