#include "print_document.h"

#include <cstdio>
#include <string_view>

#include "loosefit/base/control_characters.h"

namespace loosefit {

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "one JSON document on standard output, also of an error");
}

bool asks_for_json(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--") return false;
    if (word == "--json") return true;
  }
  return false;
}

void print_document(const std::string& json) {
  const std::string document = json_without_controls(json);
  // A stream that cannot be written is told of at the end of the program.
  std::fwrite(document.data(), 1, document.size(), stdout);
}

}  // namespace loosefit
