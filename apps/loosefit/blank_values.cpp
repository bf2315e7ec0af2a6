#include "blank_values.h"

#include <string_view>

namespace loosefit {
namespace {

std::string blank(const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") != std::string::npos) return {};
  return std::string("found ") + (text.empty() ? "an empty text" : "blanks alone") +
         ", expected a name";
}

}  // namespace

void refuse_blank_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_type_name().starts_with("TEXT")) option->check(blank);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    refuse_blank_values(*command);
}

std::string value_left_out(int count, const char* const* words) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--") break;
    if (word.size() > 3 && word.starts_with("--") && word.find('=') == word.size() - 1)
      return std::string(word);
  }
  return {};
}

}  // namespace loosefit
