#include "usage_error.h"

#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cctype>

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
  return {error.what(),
          command == &app ? "loosefit --help, or loosefit COMMAND --help" : called + " --help"};
}

}  // namespace loosefit
