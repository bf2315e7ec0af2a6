#pragma once
#include <pybind11/pybind11.h>

namespace loosefit::python {

/// _core.Ranking and _core.rank.
void bind_ranking(pybind11::module_& core);

}  // namespace loosefit::python
