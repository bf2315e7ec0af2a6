#include "loosefit/body/person_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "loosefit/body/body_tape.h"

namespace loosefit::body {
namespace {

// Local changes that a measure brings into the fit.
const std::map<std::string, std::vector<std::string>> kDetailsOf = {
    {"neck", {"neck"}},
    {"mid_neck", {"neck"}},
    {"upper_arm", {"upper_arm"}},
    {"forearm", {"forearm"}},
    {"wrist", {"wrist"}},
    {"thigh", {"thigh"}},
    {"knee", {"knee"}},
    {"calf", {"calf"}},
    {"ankle", {"ankle"}},
    {"shoulder_breadth", {"shoulder"}},
    {"arm_length", {"upper_arm_length", "forearm_length"}},
    {"back_length", {"nape_to_waist"}},
    {"crotch_height", {"thigh_length", "shank_length"}}};

/// What a search may change, from persons near the average to the ends of the model. Only bodies
/// that need it go farther.
struct Reach {
  double heaviest = 1;
  bool more_changes = false;  ///< local ones that no single girth asks for
};
constexpr Reach kReaches[] = {{1, false}, {1.6, false}, {1.6, true}, {kHeaviest, true}};

std::vector<Unknown> unknowns_of(const std::vector<MeasureRow>& asked, const Reach& reach,
                                 double muscle) {
  const auto asks_for = [&](const std::string& name) {
    return std::ranges::any_of(asked, [&](const MeasureRow& row) { return row.name == name; });
  };
  std::vector<Unknown> unknowns;
  const auto add = [&](const Unknown& unknown) {
    if (std::ranges::find(unknowns, unknown.key, &Unknown::key) == unknowns.end())
      unknowns.push_back(unknown);
  };
  if (asks_for("height")) add({"height", 0.5, 0, 1, 0.3, 0.5});
  const bool trunk = reach.more_changes || asks_for("chest") || asks_for("underbust") ||
                     asks_for("waist") || asks_for("hip");
  // Extrapolated muscle is no person's: necks of 0.9 m.
  const double beyond = (reach.heaviest - 1) * std::clamp(2 - 2 * muscle, 0.0, 1.0);
  if (trunk || reach.heaviest > 1) add({"weight", 0.5, 0, 1 + beyond, 0.5, 0.5});
  if (trunk) {
    add({"bust", 0, -1, 1, 0.5});
    add({"underbust", 0, -1, 1, 0.6});
    add({"waist", 0, -1, 1, 0.5});
    add({"hips", 0, -1, 1, 0.5});
    add({"belly", 0, -0.3, 0.5, 0.6});
    if (reach.more_changes) {
      for (const char* key : {"trunk_depth", "trunk_width", "hip_depth", "hip_width", "buttocks"})
        add({key, 0, -1, 1, 0.6});
      add({"round_belly", 0, 0, 1, 0.6});
    }
  }
  for (const auto& [measure, details] : kDetailsOf)
    if (asks_for(measure))
      for (const auto& key : details) add({key, 0, -1, 1, 0.3});
  if (asks_for("upper_arm") && reach.more_changes) add({"upper_arm_fat", 0, -1, 1, 0.3});
  return unknowns;
}

/// The same unknowns; the search begins at that weight and at that local change.
std::vector<Unknown> starting_at(std::vector<Unknown> unknowns, double weight, double change) {
  for (Unknown& unknown : unknowns)
    if (unknown.key != "height")
      unknown.start =
          std::clamp(unknown.key == "weight" ? weight : change, unknown.low, unknown.high);
  return unknowns;
}

/// The same unknowns; the search begins at this person.
std::vector<Unknown> from_person(std::vector<Unknown> unknowns, const BodyParameters& person) {
  for (Unknown& unknown : unknowns)
    unknown.start = unknown.key == "height"   ? person.height
                    : unknown.key == "weight" ? person.weight
                                              : person.details.at(unknown.key);
  return unknowns;
}

}  // namespace

double off(const MeasureRow& row) { return std::abs(row.measured - row.asked); }

bool misses(const FoundPerson& person) {
  return std::ranges::any_of(person.table,
                             [](const MeasureRow& row) { return off(row) > kResidual; });
}

double PersonSearch::measure(const BodyParameters& parameters, const std::string& name) const {
  const RestBody rest = model_.rest(parameters, detail_);
  return BodyTape(model_.data(), rest).measure(name);
}

FoundPerson PersonSearch::from(BodyDetail detail, const std::vector<MeasureRow>& asked,
                               const std::vector<Unknown>& unknowns, const std::string& yielding) {
  FoundPerson found = nearest_person(model_, detail, fixed_, asked, unknowns, progress_, yielding);
  evaluations_ += found.evaluations;
  return found;
}

// Coarse bodies show which start leads nearest.
FoundPerson PersonSearch::from_several_starts(const std::vector<MeasureRow>& asked,
                                              const std::vector<Unknown>& unknowns,
                                              const std::string& yielding) {
  FoundPerson best;
  for (const double weight : {0.5, kHeaviest})
    for (const double change : {0.0, -0.5, 0.5}) {
      FoundPerson found =
          from(BodyDetail::coarse, asked, starting_at(unknowns, weight, change), yielding);
      if (best.table.empty() || found.misfit < best.misfit) best = std::move(found);
    }
  return from(detail_, asked, from_person(unknowns, best.parameters), yielding);
}

FoundPerson PersonSearch::nearest(const std::vector<MeasureRow>& asked) {
  FoundPerson best = from(detail_, asked, unknowns_of(asked, kReaches[0], fixed_.muscle), "");
  for (std::size_t i = 0; i < std::size(kReaches) && misses(best); ++i) {
    if (progress_)
      progress_->update(double(i) / std::size(kReaches),
                        fmt::format("persons up to weight {:g}", kReaches[i].heaviest));
    FoundPerson found = from_several_starts(asked, unknowns_of(asked, kReaches[i], fixed_.muscle));
    if (found.misfit < best.misfit) best = std::move(found);
  }
  return best;
}

FoundPerson PersonSearch::farthest(const std::vector<MeasureRow>& asked, const std::string& wish) {
  if (progress_) progress_->update(1, "how far the body model goes");
  const Reach& widest = kReaches[std::size(kReaches) - 1];
  return from_several_starts(asked, unknowns_of(asked, widest, fixed_.muscle), wish);
}

}  // namespace loosefit::body
