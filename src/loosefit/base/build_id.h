#pragma once
#include <string>

namespace loosefit {

/// What the linker made out of the program's code and data (its ELF build ID), in hexadecimal
/// digits: another one for every build that may compute something else, whatever its version says.
/// Of the object that holds this function, the shared library where there is one. Empty where the
/// linker wrote none.
std::string build_id();

}  // namespace loosefit
