#pragma once
#include <string>

#include "loosefit/study/analysis.h"

namespace loosefit::study {

/// The figures of a study as JSON: what its page shows, and no less (docs/studies.md 6).
std::string analysis_json(const StudyAnalysis& analysis);

}  // namespace loosefit::study
