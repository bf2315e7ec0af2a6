#pragma once
#include <string>
#include <vector>

#include "loosefit/body/measure_fit.h"

namespace loosefit::body {

/// How far a measure may be off and still count as met [m].
inline constexpr double kResidual = 0.005;

/// How far a row is off [m].
double off(const MeasureRow& row);
/// Whether a person is off by more than kResidual in some measure.
bool misses(const FoundPerson& person);

/// Looks for persons by their measures, among those who are the same in all that no measure
/// decides. Keeps references.
class PersonSearch {
 public:
  PersonSearch(const BodyModel& model, BodyDetail detail, const BodyParameters& fixed,
               Progress* progress)
      : model_(model), detail_(detail), fixed_(fixed), progress_(progress) {}

  /// The person who is nearest to what is asked for. Those near the average are tried first; only
  /// where they miss something, heavier ones and more local changes, from several starts.
  /// \throws Cancelled.
  FoundPerson nearest(const std::vector<MeasureRow>& asked);
  /// The person who comes nearest to one of the wishes while the others are met, as far as they can
  /// be.
  FoundPerson farthest(const std::vector<MeasureRow>& asked, const std::string& wish);
  double measure(const BodyParameters& parameters, const std::string& name) const;
  int evaluations() const { return evaluations_; }

 private:
  FoundPerson from(BodyDetail detail, const std::vector<MeasureRow>& asked,
                   const std::vector<Unknown>& unknowns, const std::string& yielding);
  FoundPerson from_several_starts(const std::vector<MeasureRow>& asked,
                                  const std::vector<Unknown>& unknowns,
                                  const std::string& yielding = "");

  const BodyModel& model_;
  BodyDetail detail_;
  const BodyParameters& fixed_;
  Progress* progress_;
  int evaluations_ = 0;
};

}  // namespace loosefit::body
