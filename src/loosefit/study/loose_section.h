#pragma once
#include <string>

#include "loosefit/study/analysis.h"

namespace loosefit::study {

/// The section of a study's page that answers how loose it may be for one kind of sensor: curves of
/// the sites that may be loosest, the interval of the first, a table of all, and the comfort limit.
/// Empty without an axis of looseness.
std::string loose_section(const StudyAnalysis& analysis, const ModalityAnalysis& modality);

}  // namespace loosefit::study
