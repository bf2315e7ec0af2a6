#pragma once
#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace loosefit {

/// What is wrong with a command line, and a way on.
struct UsageError {
  std::string message, hint;
};

/// Names the first command or option that does not exist, with the nearest one that does; else what
/// CLI11 complains about. `words`: the command line without the name of the program.
UsageError explain_usage(const CLI::App& app, const std::vector<std::string>& words,
                         const CLI::ParseError& error);

}  // namespace loosefit
