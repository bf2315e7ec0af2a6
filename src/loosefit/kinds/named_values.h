#pragma once
#include <map>
#include <string>
#include <utility>

#include "loosefit/kinds/girth_line.h"

namespace loosefit::kinds {

/// Numbers by name: measures of a body, or the fit of a garment. SI units.
using NamedValues = std::map<std::string, double>;

/// What a draft knows of a body: measures by name, and girths along its limbs, which a table of
/// sizes lacks.
struct BodyMeasures : NamedValues {
  using NamedValues::NamedValues;
  BodyMeasures() = default;
  BodyMeasures(NamedValues values, GirthsAlong girths = {})
      : NamedValues(std::move(values)), along(std::move(girths)) {}
  GirthsAlong along;
};

}  // namespace loosefit::kinds
