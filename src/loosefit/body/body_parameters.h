#pragma once
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::body {

class Stumps;

/// The knobs of the parametric body. All but age lie in [0,1] with 0.5 as the average; `height` is
/// a level, not metres: BodyModel::fit finds it for a stature. `weight` may go up to 1.6.
struct BodyParameters {
  double sex = 0.5;  ///< 0 female … 1 male
  double age = 25;   ///< years, 1 … 90
  double muscle = 0.5;
  double weight = 0.5;
  double height = 0.5;
  double proportions = 0.5;
  double cup = 0.5;
  double firmness = 0.5;
  std::array<double, 3> ancestry = {1. / 3, 1. / 3, 1. / 3};  ///< african, asian, caucasian; sum 1
  /// Signed local changes in [-1,1] by the keys of detail_targets(): "bust", "waist", "belly", …
  std::map<std::string, double> details;
  /// What a scan has beyond the model: added to the body vertices of the data in the rest posture
  /// [m]. Null: nothing.
  std::shared_ptr<const std::vector<Vec3>> shift;
  /// What a scan lacks: the model makes the person without it. Null: nothing.
  std::shared_ptr<const Stumps> stumps;
};

/// Factor of every word that macro target names are made of: "female", "child", "maxweight", …
/// The factors of one parameter sum to 1 (partition of unity).
std::map<std::string, double> macro_factors(const BodyParameters& parameters);

/// Words of a macro target name: "macrodetails/universal-male-old-…" → {"male", "old", …}.
/// Empty when the name is not a macro target; its weight is the product of its words' factors.
std::vector<std::string> macro_words(const std::string& target_name);

/// A local change: the targets for a negative and a positive coefficient (several when a left and
/// a right target belong together).
struct DetailTarget {
  std::string key;
  std::vector<std::string> decrease;
  std::vector<std::string> increase;
};

/// All local changes the model offers.
const std::vector<DetailTarget>& detail_targets();

/// \throws InvalidInput naming the parameter, its value and its range.
void check_parameters(const BodyParameters& parameters);

}  // namespace loosefit::body
