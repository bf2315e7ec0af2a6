#pragma once
#include <pybind11/pybind11.h>

namespace loosefit::python {

/// From now on our errors arrive in Python as the classes of loosefit/_errors.py.
void register_errors();

}  // namespace loosefit::python
