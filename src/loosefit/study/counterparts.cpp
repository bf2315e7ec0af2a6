#include "loosefit/study/counterparts.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::study {
namespace {

/// What is known of a person: the inputs of the axis of people.
std::map<std::string, double> measures_of(const StudyData& data, int unit) {
  const Axis& axis = data.plan.axes[people_axis(data.plan)];
  const std::string prefix = axis.name + ".";
  std::map<std::string, double> measures;
  for (const auto& [name, value] : axis.levels[unit].inputs)
    measures[name.substr(std::min(name.size(), prefix.size()))] = value;
  return measures;
}

void check_people(const StudyData& a, const StudyData& b) {
  for (std::size_t i = 0; i < a.units.size(); ++i)
    for (std::size_t j = 0; j < b.units.size(); ++j)
      if (a.units[i] == b.units[j] &&
          measures_of(a, static_cast<int>(i)) != measures_of(b, static_cast<int>(j)))
        throw InvalidInput("\"" + printable(a.units[i]) + "\" of " + printable(a.plan.name) +
                               " measures otherwise in " + printable(b.plan.name),
                           "draw the people of both studies from the same statistics with the same "
                           "seed and axis name, or give both the same CSV file");
}

/// One thing that counterparts have in common.
struct Likeness {
  std::string what;  ///< "person"
  std::function<std::string(const StudyData&, const FolderCase&)> of;
};

const std::string& label_on(const StudyData& data, const FolderCase& one, int axis) {
  return data.plan.axes[axis].levels[one.levels[axis]].label;
}

int axis_named(const FolderPlan& plan, const std::string& name) {
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    if (plan.axes[k].name == name) return static_cast<int>(k);
  return -1;
}

/// People and fits, which are paired whatever their axes are called.
bool is_person_or_fit(const FolderPlan& plan, int axis) {
  return axis == people_axis(plan) || axis == looseness_axis(plan);
}

/// Told by the scenario itself, so that a study without the axis has it, too.
bool is_wearing(const FolderPlan& plan, int axis) {
  return plan.axes[axis].kind == "postures" || plan.axes[axis].kind == "donnings";
}

bool knows_wearing(const StudyData& data) {
  return std::all_of(data.plan.cases.begin(), data.plan.cases.end(),
                     [](const FolderCase& one) { return !one.wearing.empty(); });
}

std::vector<Likeness> likenesses(const StudyData& a, const StudyData& b) {
  std::vector<Likeness> all;
  const auto on_axis = [](int (*find)(const FolderPlan&)) {
    return [find](const StudyData& data, const FolderCase& one) {
      const int axis = find(data.plan);
      return axis < 0 ? std::string() : label_on(data, one, axis);
    };
  };
  all.push_back({"person", on_axis(people_axis)});
  all.push_back({"fit", on_axis(looseness_axis)});
  const bool known = knows_wearing(a) && knows_wearing(b);
  if (known && people_axis(a.plan) < 0)
    all.push_back({"wearer", [](const StudyData&, const FolderCase& one) { return one.wearer; }});
  if (known)
    all.push_back({"posture or donning",
                   [](const StudyData&, const FolderCase& one) { return one.wearing; }});
  for (std::size_t k = 0; k < a.plan.axes.size(); ++k) {
    const std::string name = a.plan.axes[k].name;
    const int other = axis_named(b.plan, name);
    const int own = static_cast<int>(k);
    if (other < 0 || is_person_or_fit(a.plan, own) || is_person_or_fit(b.plan, other)) continue;
    if (known && is_wearing(a.plan, own) && is_wearing(b.plan, other)) continue;
    all.push_back({name, [name](const StudyData& data, const FolderCase& one) {
                     return label_on(data, one, axis_named(data.plan, name));
                   }});
  }
  return all;
}

/// Labels of cases, one for each likeness.
using Labels = std::vector<std::string>;

std::vector<Labels> labels_of(const StudyData& data, const std::vector<Likeness>& likenesses) {
  std::vector<Labels> all;
  for (const FolderCase& one : data.plan.cases) {
    Labels& labels = all.emplace_back();
    for (const Likeness& likeness : likenesses) labels.push_back(likeness.of(data, one));
  }
  return all;
}

/// How many cases have no counterpart, by the first thing that the other study has not at all.
std::string alone_note(const StudyData& data, const std::vector<Labels>& own,
                       const StudyData& other, const std::vector<Labels>& theirs,
                       const std::vector<Likeness>& likenesses, const std::set<Labels>& common) {
  std::vector<std::set<std::string>> known(likenesses.size());
  for (const Labels& labels : theirs)
    for (std::size_t d = 0; d < labels.size(); ++d) known[d].insert(labels[d]);
  std::map<std::string, int> why;
  int alone = 0;
  for (const Labels& labels : own) {
    if (common.count(labels)) continue;
    ++alone;
    std::size_t d = 0;
    while (d < labels.size() && known[d].count(labels[d])) ++d;
    ++why[d < labels.size() ? "of another " + likenesses[d].what : "of another combination"];
  }
  if (alone == 0) return "";
  std::vector<std::string> words;
  for (const auto& [reason, count] : why) words.push_back(fmt::format("{} {}", count, reason));
  return fmt::format("{} of {} cases of {} have no counterpart in {}: {}", alone, own.size(),
                     data.plan.name, other.plan.name, join(words));
}

/// What a study that has not run to its end does not tell.
void note_open_cases(const StudyData& data, std::vector<std::string>& notes) {
  const auto open = std::ranges::count(data.troubles, "open", &CaseTrouble::status);
  if (open > 0)
    notes.push_back(
        fmt::format("{} of {} cases of {} have no result yet: scores and limits are of the others",
                    open, data.plan.cases.size(), data.plan.name));
}

/// Axes of one study alone: the worst of their levels counts.
void note_axes_alone(const StudyData& data, const StudyData& other,
                     std::vector<std::string>& notes) {
  for (std::size_t k = 0; k < data.plan.axes.size(); ++k) {
    const Axis& axis = data.plan.axes[k];
    const int own = static_cast<int>(k);
    if (axis.levels.size() < 2 || is_person_or_fit(data.plan, own) || is_wearing(data.plan, own) ||
        axis_named(other.plan, axis.name) >= 0)
      continue;
    notes.push_back(fmt::format("the axis {} is in {} alone: the worst of its {} levels counts",
                                axis.name, data.plan.name, axis.levels.size()));
  }
}

/// People are paired by name and told measures; what the plans do not tell may make them others.
void note_other_bodies(const StudyData& a, const StudyData& b, CommonCases& common) {
  std::set<std::string> others;
  for (const Counterparts& group : common.groups) {
    const std::string &in_a = a.plan.cases[group.a.front()].wearer,
                      &in_b = b.plan.cases[group.b.front()].wearer;
    if (!in_a.empty() && !in_b.empty() && in_a != in_b) others.insert(common.units[group.unit]);
  }
  if (!others.empty())
    common.notes.push_back(fmt::format(
        "{} of {} people have another body in {} than in {}, though their names and what is told "
        "of them are the same (sex, age, scan or another key of [scenario.body]): they are not the "
        "same people",
        others.size(), common.units.size(), a.plan.name, b.plan.name));
}

[[noreturn]] void refuse(const StudyData& a, const StudyData& b,
                         const std::vector<std::string>& notes) {
  throw InvalidInput("the studies " + printable(a.plan.name) + " and " + printable(b.plan.name) +
                         " have no case in common: " + join(notes, "; "),
                     "a comparison is of the same people, fits, postures and donnings");
}

}  // namespace

CommonCases common_cases(const StudyData& a, const StudyData& b) {
  if ((people_axis(a.plan) < 0) != (people_axis(b.plan) < 0))
    throw InvalidInput(
        "the studies " + printable(a.plan.name) + " and " + printable(b.plan.name) +
            " have no case in common: " + printable((people_axis(a.plan) < 0 ? a : b).plan.name) +
            " has no axis of people",
        "a comparison is of the same people, fits, postures and donnings");
  if (people_axis(a.plan) >= 0) check_people(a, b);
  const std::vector<Likeness> alike = likenesses(a, b);
  const std::vector<Labels> of_a = labels_of(a, alike), of_b = labels_of(b, alike);
  CommonCases common;
  std::map<Labels, Counterparts> groups;
  for (std::size_t i = 0; i < of_a.size(); ++i) groups[of_a[i]].a.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < of_b.size(); ++i) groups[of_b[i]].b.push_back(static_cast<int>(i));
  std::set<Labels> in_both;
  std::map<std::string, int> unit_of;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const Counterparts& found = groups.at(of_a[i]);
    if (found.b.empty() || !in_both.insert(of_a[i]).second) continue;
    std::string unit = of_a[i].front();
    if (people_axis(a.plan) < 0) unit = join(Labels(of_a[i].begin() + 2, of_a[i].end()));
    const auto [at, is_new] = unit_of.try_emplace(unit, static_cast<int>(common.units.size()));
    if (is_new) common.units.push_back(unit);
    common.groups.push_back({at->second, a.level_of_case[found.a.front()], found.a, found.b});
    common.paired_a += static_cast<int>(found.a.size());
    common.paired_b += static_cast<int>(found.b.size());
  }
  for (const std::string& note :
       {alone_note(a, of_a, b, of_b, alike, in_both), alone_note(b, of_b, a, of_a, alike, in_both)})
    if (!note.empty()) common.notes.push_back(note);
  note_open_cases(a, common.notes);
  note_open_cases(b, common.notes);
  if (common.groups.empty()) refuse(a, b, common.notes);
  note_other_bodies(a, b, common);
  note_axes_alone(a, b, common.notes);
  note_axes_alone(b, a, common.notes);
  if (!knows_wearing(a) || !knows_wearing(b))
    common.notes.push_back(
        "postures and donnings are paired by the labels of axes alone: the plan of one study was "
        "written by an earlier program (loosefit study plan STUDY -o DIR writes it anew)");
  return common;
}

std::vector<int> same_people(const StudyData& a, const StudyData& b) {
  if (people_axis(a.plan) < 0 || people_axis(b.plan) < 0 || a.units.size() != b.units.size())
    return {};
  std::vector<int> in_b;
  for (const std::string& person : a.units) {
    const auto at = std::ranges::find(b.units, person);
    if (at == b.units.end()) return {};
    in_b.push_back(static_cast<int>(at - b.units.begin()));
  }
  return in_b;
}

}  // namespace loosefit::study
