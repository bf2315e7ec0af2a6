#pragma once
#include <string>

#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// validation.html: one self-contained page. What is tested and against what, every figure with its
/// error, gate and mesh, the curves, and the solver settings, which are the same for all.
std::string validation_html(const Validation& validation);

}  // namespace loosefit::validate
