#pragma once
#include <string>

namespace loosefit::io {

/// JSON Schema (draft 2020-12) of scenarios, with types, ranges, units, defaults and a description
/// of every key. It is made by letting the readers of scenarios read examples that lead through
/// every branch of them, and noting what they ask for, so that it says what they accept. What
/// depends on several sections, on files or on the body is not in it.
std::string scenario_schema();

}  // namespace loosefit::io
