#pragma once
#include <string>
#include <vector>

#include "loosefit/study/analysis.h"

namespace loosefit::study {

/// Difference of two studies at one site and looseness, over people that both have.
struct PairedDifference {
  std::string modality, site, level;
  int pairs = 0;
  double mean = 0, median = 0;  ///< of B − A, scores clamped to 0 … 1
  Bounds interval;              ///< of the mean, by bootstrap over people
  double better = 0;            ///< share of people with a higher score in B
  double passing_a = 0, passing_b = 0;
  bool differs() const { return interval.low > 0 || interval.high < 0; }
};

struct StudyComparison {
  std::string name_a, name_b;
  std::vector<PairedDifference> differences;
  std::vector<std::string> notes;  ///< what one of them lacks
};

/// Pairs people by name, sites and levels of looseness by label; people of the same name must
/// measure the same. \throws InvalidInput when nothing can be paired, or people of one name differ.
StudyComparison compare_studies(const StudyData& a, const StudyData& b,
                                const BootstrapOptions& options = {});

std::string comparison_text(const StudyComparison& comparison);
std::string comparison_csv(const StudyComparison& comparison);
std::string comparison_json(const StudyComparison& comparison);

}  // namespace loosefit::study
