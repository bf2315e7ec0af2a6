#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::python {

/// _core.Pattern: flat pieces and how they fit a body.
struct PatternHandle {
  std::shared_ptr<const pattern::Pattern> pattern;
  std::vector<kinds::FitLevel> levels;
  std::vector<std::string> warnings;
};

/// _core.Pattern and _core.make_pattern.
void bind_pattern(pybind11::module_& core);

}  // namespace loosefit::python
