#pragma once
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_model.h"

namespace loosefit::body {

/// One line of asked against measured [m].
struct MeasureRow {
  std::string name;
  double asked = 0;
  double measured = 0;
};

/// How far a row is off, as a share of what was asked.
double miss(const MeasureRow& row);

/// What a fit may change: "height", "weight" or a local change.
struct Unknown {
  std::string key;
  double usual = 0, low = -1, high = 1;
  double stiffness = 0.3;  ///< of the pull towards `usual`
  double start = 0;        ///< where the search begins
};

/// A person that a search has found.
struct FoundPerson {
  BodyParameters parameters;
  std::vector<MeasureRow> table;
  double misfit = 0;  ///< sum of squares of misses, each in its unit
  int evaluations = 0;
};

/// The unit of misses: a share of what was asked, the same for trunk and limbs. Stature is known
/// better than a girth.
inline constexpr double kMissUnit = 0.003, kStatureMissUnit = 0.001;

/// The person whose measures are nearest to the rows asked for: least squares of their misses and
/// of the pulls of the unknowns, by bounded Gauss-Newton from their starts. `fixed` has what is not
/// unknown. A measure that is `yielding` counts so little that the others are met first.
/// \throws Cancelled by `progress`, if there is one.
FoundPerson nearest_person(const BodyModel& model, BodyDetail detail, const BodyParameters& fixed,
                           const std::vector<MeasureRow>& asked,
                           const std::vector<Unknown>& unknowns, const Progress* progress,
                           const std::string& yielding = "");

}  // namespace loosefit::body
