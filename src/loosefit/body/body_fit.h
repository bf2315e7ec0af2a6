#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_model.h"
#include "loosefit/body/measure_fit.h"

namespace loosefit::body {

/// The wearer as asked for, in metres. `measurements` takes any of measure_names() but "height".
struct BodySpec {
  double sex = 0.5;   ///< 0 female … 1 male; 0.3 … 0.5 for a child before puberty
  double age = 25;    ///< years
  double height = 0;  ///< stature [m]; 0: what the model gives for sex and age
  std::map<std::string, double> measurements;
  double muscle = 0.5;
  double proportions = 0.5;
  double cup = 0.5;
  double firmness = 0.5;
};

/// What a fit found. A measure more than 5 mm off and a strained local change make a warning.
struct BodyFit {
  BodyParameters parameters;
  std::vector<MeasureRow> table;
  std::vector<std::string> warnings;
  int evaluations = 0;
};

/// Parameters whose body has the asked measures, on the surface that BodyModel::build makes. A
/// person near the average is looked for first; where that misses a wish, heavier people and more
/// local changes are searched, from several starts (docs/theory/body_model.md 4). `progress` is
/// asked whether to go on, and hears of the longer search.
/// \throws InvalidInput naming a measure that no person has, or the measure that the nearest body
/// misses most if that is by more than kMostMiss; Cancelled.
BodyFit fit_body(const BodyModel& model, const BodySpec& spec,
                 BodyDetail detail = BodyDetail::subdivided, Progress* progress = nullptr);

/// Share of a wish that a body may miss: of trunk, limbs and stature alike.
inline constexpr double kMostMiss = 0.03;

}  // namespace loosefit::body
