#pragma once
#include <string>

#include "loosefit/study/study_data.h"

// What the units of a study are called: a figure over chosen cases says nothing of people.
namespace loosefit::study {

enum class UnitKind {
  people,         ///< drawn from statistics
  listed_people,  ///< from a file: they stand for themselves alone
  wearers_cases,  ///< cases of one body, without an axis of people
  cases           ///< cases of several bodies, or of bodies that are not known
};

UnitKind unit_kind(const StudyData& data);

/// "people", "listed people", "cases of one wearer", "cases"
std::string name(UnitKind kind);
/// The same as the head of a column: "people", "listed people", "cases".
std::string column_name(UnitKind kind);

/// "1 case", "2 cases"
std::string counted(int count, const std::string& one, const std::string& many);
/// "1 person", "4 people", "4 listed people", "4 cases of one wearer"
std::string counted(int count, UnitKind kind);

/// Of which units a share is: "4 people", "the 3 rated of 4 people", "the 4 people listed", "4
/// cases of one wearer".
std::string rated_of_all(int rated, int all, UnitKind kind);

/// Those for whom a robust score holds: "for 95 % of people", "for all 4 people listed", "in all 4
/// cases of one wearer". Of chosen units up to kWorstIsRobust it holds for all.
std::string for_most(int count, UnitKind kind);

}  // namespace loosefit::study
