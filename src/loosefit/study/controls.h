#pragma once
#include <string>
#include <vector>

#include "loosefit/study/case_record.h"

// Cases that are content with certificate grade B are controlled: one in twenty of them also goes
// on to grade A, and what that changes is told. Which ones hangs on the plan alone: not on what has
// run in its folder before, nor in which order.
namespace loosefit::study {

/// Which of these addresses are controls: by the address alone one in twenty, so that a study that
/// grows keeps them, and the least one where that picks none.
std::vector<std::string> control_addresses(const std::vector<std::string>& addresses);

/// What grade A changes of a case. Angles (metrics in degrees) change by 180° at most. A sample
/// whose score is there at one grade alone has no difference: it is counted.
Control compared(const CaseRecord& b, const CaseRecord& a);

/// Over the controls of a study.
struct ControlSummary {
  int cases = 0, failed = 0;
  std::map<std::string, double> largest;  ///< as Control
  int counted = 0;                        ///< controls that count their scores
  ScoreChanges scores;                    ///< of these
};
void add(const Control& control, ControlSummary& summary);

}  // namespace loosefit::study
