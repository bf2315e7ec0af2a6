#pragma once
#include <pybind11/pybind11.h>

#include "loosefit/io/config_node.h"

namespace loosefit::python {

/// A Python mapping as the table that a TOML file with the same keys and values would give: dict
/// (or another mapping) → table, list, tuple or array → array, str and os.PathLike → text; NumPy
/// scalars are numbers. Lines are 0. What has no place in TOML becomes a value that no key accepts.
/// \throws InvalidInput naming the key for None, for keys that are no text, for integers beyond 64
/// bits and for nesting deeper than 32.
io::ConfigNode table_of_python(pybind11::handle mapping);

}  // namespace loosefit::python
