#pragma once
#include <string>

namespace loosefit {

/// What the linker made out of the program's code and data (its ELF build ID), in hexadecimal
/// digits: another one for every build of other code, whatever its version says. Libraries that it
/// loads are not a part of it. Of the object that holds this function, the shared library of
/// Loosefit where that is used. Empty where the linker wrote none.
std::string build_id();

}  // namespace loosefit
