#include "loosefit/study/unit_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/study/population_ranking.h"

namespace loosefit::study {
namespace {

bool is_of_cases(UnitKind kind) {
  return kind == UnitKind::wearers_cases || kind == UnitKind::cases;
}

}  // namespace

UnitKind unit_kind(const StudyData& data) {
  if (const int people = people_axis(data.plan); people >= 0)
    return data.plan.axes[people].sampled ? UnitKind::people : UnitKind::listed_people;
  const std::vector<FolderCase>& cases = data.plan.cases;
  const bool one_wearer = !cases.empty() && !cases.front().wearer.empty() &&
                          std::ranges::all_of(cases, [&](const FolderCase& one) {
                            return one.wearer == cases.front().wearer;
                          });
  return one_wearer ? UnitKind::wearers_cases : UnitKind::cases;
}

std::string name(UnitKind kind) {
  switch (kind) {
    case UnitKind::people:
      return "people";
    case UnitKind::listed_people:
      return "listed people";
    case UnitKind::wearers_cases:
      return "cases of one wearer";
    case UnitKind::cases:
      break;
  }
  return "cases";
}

std::string column_name(UnitKind kind) { return is_of_cases(kind) ? "cases" : name(kind); }

std::string counted(int count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string counted(int count, UnitKind kind) {
  switch (kind) {
    case UnitKind::people:
      return counted(count, "person", "people");
    case UnitKind::listed_people:
      return counted(count, "listed person", "listed people");
    case UnitKind::wearers_cases:
      return counted(count, "case", "cases") + " of one wearer";
    case UnitKind::cases:
      break;
  }
  return counted(count, "case", "cases");
}

std::string rated_of_all(int rated, int all, UnitKind kind) {
  const std::string units = kind == UnitKind::listed_people
                                ? "the " + counted(all, "person", "people") + " listed"
                                : counted(all, kind);
  return rated < all ? fmt::format("the {} rated of {}", rated, units) : units;
}

std::string for_most(int count, UnitKind kind) {
  if (kind == UnitKind::people) return "for 95 % of people";
  const std::string units = kind == UnitKind::listed_people
                                ? counted(count, "person", "people") + " listed"
                                : counted(count, kind);
  return (is_of_cases(kind) ? "in " : "for ") + (count > kWorstIsRobust ? "95 % of the " + units
                                                 : count == 1           ? "the " + units
                                                                        : "all " + units);
}

}  // namespace loosefit::study
