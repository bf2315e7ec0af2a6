#pragma once
#include <string>
#include <vector>

#include "loosefit/study/analysis.h"
#include "loosefit/study/limit_difference.h"
#include "loosefit/study/population_ranking.h"

namespace loosefit::study {

/// Difference of two studies at one site and looseness, over people that both have. The score of a
/// person is the lowest over cases and donnings that both studies have (counterparts.h) and rate.
struct PairedDifference {
  std::string modality, site, level;
  int pairs = 0;
  int not_rated = 0;            ///< people of both studies of whom no donning is rated in both
  double mean = 0, median = 0;  ///< of B − A, scores clamped to 0 … 1
  Bounds interval;              ///< of the mean, by bootstrap over people
  /// Share of people with a higher score in B, clamped likewise; a tie is not higher.
  double better = 0;
  double passing_a = 0, passing_b = 0;
  /// Zero is not within the interval. Never of fewer pairs than kFewestForInterval, whose interval
  /// leaves zero out far more often than one time in ten without any difference: two pairs of one
  /// sign always do.
  bool differs() const {
    return pairs >= kFewestForInterval && (interval.low > 0 || interval.high < 0);
  }
};

struct StudyComparison {
  std::string name_a, name_b;
  bool of_people = true;  ///< else pairs are cases of one body
  std::vector<PairedDifference> differences;
  std::vector<LimitDifference> limits;  ///< where both studies tell how loose it may be
  int cases_a = 0, cases_b = 0;         ///< all of them
  int paired_a = 0, paired_b = 0;       ///< those with a counterpart in the other study
  std::vector<std::string> notes;       ///< what one of them lacks, with counts
};

/// Pairs cases by what they have in common (counterparts.h), sites by name. What passes is what the
/// scorecard of A says, also in B.
/// \throws InvalidInput when nothing can be paired, or people of one name measure otherwise.
StudyComparison compare_studies(const StudyData& a, const StudyData& b,
                                const BootstrapOptions& options = {});

std::string comparison_text(const StudyComparison& comparison);
/// Of the differences of scores; of the limits.
std::string comparison_csv(const StudyComparison& comparison);
std::string limits_csv(const StudyComparison& comparison);
std::string comparison_json(const StudyComparison& comparison);

}  // namespace loosefit::study
