#pragma once
#include <string>

#include "loosefit/study/analysis.h"
#include "loosefit/study/gallery.h"

namespace loosefit::study {

/// The page of a study: one self-contained HTML without scripts. First how loose it may be, as
/// sentence, curve and table; then ranking, distributions, choice of sensors, what the sensors
/// meet, sensitivity, and what failed; last the gallery, where there is one.
std::string study_html(const StudyAnalysis& analysis, const Gallery& gallery = {});

/// One row per site: the range from 5th to 95th percentile as a line, the median as a bar, each
/// person as a dot; inline SVG. \param pass drawn as a dashed line
std::string distribution_svg(const std::vector<SiteScores>& sites, double pass);

}  // namespace loosefit::study
