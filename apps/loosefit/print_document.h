#pragma once
#include <CLI/App.hpp>
#include <string>

namespace loosefit {

/// Adds `--json` to a command: one JSON document on standard output and nothing else there, also
/// when the command fails (docs/command-line.md).
void add_json_flag(CLI::App& command, bool& json);

/// Whether a command line asks for JSON, however wrong the rest of it may be.
bool asks_for_json(int count, char** arguments);

/// The one document of a command. What the command has to say besides is on standard error.
void print_document(const std::string& document);

}  // namespace loosefit
