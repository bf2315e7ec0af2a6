#pragma once
#include <string>
#include <vector>

#include "loosefit/study/plan.h"

namespace loosefit::study {

/// Criteria of a modality that no case of a plan can tell, since their metrics need several
/// postures or donnings (tellable in study/measure_case.h).
struct UntoldModality {
  std::string modality;              ///< name of its scorecard
  std::vector<std::string> metrics;  ///< with what they need: "slip_mm (several postures)"
  bool rated = false;  ///< by the other criteria, in some case: such scores are upper bounds
};

/// Those of the modalities of a plan that have such criteria. \throws what load_scorecard throws.
std::vector<UntoldModality> untold_modalities(const Plan& plan);

/// "imu-inclination: no case can tell coe_rms_deg (several postures): nothing will be rated"
std::string untold_text(const UntoldModality& untold);

}  // namespace loosefit::study
