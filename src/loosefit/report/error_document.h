#pragma once
#include <exception>
#include <string>

namespace loosefit::report {

/// What a failed command says with `--json`: where, what was found, what was expected, the whole
/// message, a hint, and the exit code. Parts that an error does not have are null.
std::string error_document(const std::exception& error, int exit_code);
/// The same of a complaint that has no place.
std::string error_document(const std::string& message, const std::string& hint, int exit_code);

}  // namespace loosefit::report
