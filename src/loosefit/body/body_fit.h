#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body_model.h"

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

/// One line of asked against measured [m].
struct MeasureRow {
  std::string name;
  double asked = 0;
  double measured = 0;
};

/// What a fit found. A measure more than 5 mm off and a strained local change make a warning.
struct BodyFit {
  BodyParameters parameters;
  std::vector<MeasureRow> table;
  std::vector<std::string> warnings;
  int evaluations = 0;
};

/// Parameters whose body has the asked measures, by bounded Gauss-Newton on the surface that
/// BodyModel::build makes. \throws InvalidInput naming a measure that no person has, or a stature
/// or trunk girth that the nearest body misses by more than a tenth.
BodyFit fit_body(const BodyModel& model, const BodySpec& spec,
                 BodyDetail detail = BodyDetail::subdivided);

}  // namespace loosefit::body
