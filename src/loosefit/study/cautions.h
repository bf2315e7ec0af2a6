#pragma once
#include <string>
#include <vector>

#include "loosefit/study/study_data.h"

namespace loosefit::study {

/// Warnings of cases that say the same but for their figures.
struct Caution {
  std::string example;  ///< the whole warning of the first case that has it, metrics in words
  int number = 0;       ///< of that case
  int cases = 0;        ///< that have such a warning
};

/// Warnings alike in their first kLeadingWords words, figures aside, are one. The commonest first,
/// of those alike that of the earlier case.
std::vector<Caution> group_warnings(const StudyData& data);
/// What follows differs by cloth, region and direction (judgement).
inline constexpr int kLeadingWords = 8;

/// Cases that carry a warning.
int warned_cases(const StudyData& data);
/// "3 of 4 cases carry warnings: see Cautions on the page" of cases that have run; empty without
/// one.
std::string cautions_in_words(const StudyData& data);

/// Every figure becomes #, with its sign and exponent; digits of a word ("C7") stay.
std::string without_figures(const std::string& text);

/// Names of metrics in a text, as their words ("coe_rms_deg").
std::string metrics_in_words(const std::string& text);

/// The section of the page: the first kOpenCautions in the open, the others folded away; empty
/// without a warning.
std::string cautions_html(const StudyData& data);
inline constexpr std::size_t kOpenCautions = 12;

}  // namespace loosefit::study
