#pragma once
#include <pybind11/pybind11.h>

namespace loosefit::python {

/// _core.Scenario: a scenario as read from a mapping, a TOML text or a file.
void bind_scenario(pybind11::module_& core);

}  // namespace loosefit::python
