#pragma once
#include <string>
#include <vector>

#include "loosefit/study/study_data.h"

// Which cases of two studies tell of the same: those of the same person, fit, postures and history
// of putting on, and of the same level of every other axis that both studies have. What differs
// between the studies otherwise is what they are compared for.
namespace loosefit::study {

/// Cases of two studies with the same of all that both tell; several of one study where an axis is
/// in that study alone, or where its levels come to the same scenario.
struct Counterparts {
  int unit = 0;           ///< of CommonCases::units
  int level = 0;          ///< of looseness, of the first study
  std::vector<int> a, b;  ///< cases, from 0
};

struct CommonCases {
  std::vector<std::string> units;  ///< people; without people what else tells cases apart
  std::vector<Counterparts> groups;
  int paired_a = 0, paired_b = 0;  ///< cases that are in a group
  /// In words: how many cases of each study have no counterpart, and why; which axes one alone has.
  std::vector<std::string> notes;
};

/// \throws InvalidInput when no case has a counterpart, naming what the studies do not share, or
/// when people of one name measure otherwise.
CommonCases common_cases(const StudyData& a, const StudyData& b);

/// For each person of `a` the same one in `b`; nothing when one study has people that the other has
/// not, or none. \pre people of one name measure alike (common_cases)
std::vector<int> same_people(const StudyData& a, const StudyData& b);

}  // namespace loosefit::study
