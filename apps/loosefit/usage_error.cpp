#include "usage_error.h"

#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cctype>
#include <optional>

#include "loosefit/base/text.h"

namespace loosefit {
namespace {

bool is_option(const std::string& word) {
  // "-0.3" is a number.
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])));
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// "--output=out" and "-oout" by their names.
std::string option_name(const std::string& word) {
  return word[1] == '-' ? word.substr(0, word.find('=')) : word.substr(0, 2);
}

/// A number of another country, or one with its unit, where CLI11 could not convert it: "Could not
/// convert: --chest = 0,92".
std::optional<UsageError> explain_number(const std::string& complaint, const std::string& help) {
  const std::size_t option = complaint.find("--"), equal = complaint.rfind(" = ");
  if (option == std::string::npos || equal == std::string::npos || equal < option) return {};
  const std::string name = complaint.substr(option, equal - option);
  const std::string value = complaint.substr(equal + 3);
  const std::size_t end = value.find_first_not_of("+-0123456789.,");
  const std::string digits = value.substr(0, end);
  if (digits.find_first_of("0123456789") == std::string::npos) return {};
  const std::string found = "found \"" + printable(value) + "\" for " + name + ", expected ";
  if (end != std::string::npos)
    return UsageError{
        found + "a number without a unit",
        "lengths are in metres, angles of options that end in -deg in degrees; " + help};
  if (std::count(digits.begin(), digits.end(), ',') != 1 || digits.find('.') != std::string::npos)
    return UsageError{found + "a number", help};
  std::string with_point = digits;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return UsageError{found + "a number with a decimal point, not a decimal comma",
                    "write " + name + " " + printable(with_point)};
}

}  // namespace

UsageError explain_usage(const CLI::App& app, const std::vector<std::string>& words,
                         const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string called = "loosefit";
  for (const std::string& word : words) {
    if (word == "--") break;
    if (is_option(word)) {
      const std::vector<std::string> known = options_of(*command);
      const std::string name = option_name(word);
      if (contains(known, name)) continue;
      const std::string near = closest_match(name, known);
      return {"found \"" + word + "\", expected an option of " + called,
              near.empty() ? called + " --help" : "did you mean \"" + near + "\"?"};
    }
    const std::vector<std::string> known = commands_of(*command);
    if (known.empty()) continue;
    if (!contains(known, word)) {
      const std::string what = command == &app ? "a command" : "a subcommand of " + called;
      return {"found \"" + word + "\", expected " + what, did_you_mean(word, known)};
    }
    command = command->get_subcommand(word);
    called += " " + word;
  }
  const std::string help =
      command == &app ? "loosefit --help, or loosefit COMMAND --help" : called + " --help";
  if (const auto number = explain_number(error.what(), help)) return *number;
  return {error.what(), help};
}

}  // namespace loosefit
