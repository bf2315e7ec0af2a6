#include "command_schema.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_schema.h"
#include "loosefit/report/error_document.h"
#include "loosefit/report/fact_documents.h"
#include "print_document.h"

namespace loosefit {
namespace {

struct Arguments {
  std::vector<std::string> check;
  bool json = false;
};

int check(const Arguments& arguments) {
  std::vector<report::CheckedScenario> checked;
  int code = kGood;
  for (const std::string& file : arguments.check) {
    std::string message, hint, document;
    try {
      io::read_scenario(file);
    } catch (const Error& error) {
      code = kBadInput;
      message = error.what();
      hint = error.hint();
      document = report::error_document(error, kBadInput);
    }
    checked.push_back({file, document});
    if (arguments.json) continue;
    if (message.empty())
      fmt::print("ok       {}\n", terminal_line(file));
    else
      fmt::print("refused  {}\n", terminal_line(message));
    if (!hint.empty()) fmt::print("         hint: {}\n", terminal_line(hint));
  }
  if (arguments.json) print_document(report::checked_document(checked));
  return code;
}

}  // namespace

void add_schema_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "schema", "JSON Schema of scenarios; or check scenario files without running them");
  command->add_option("--check", arguments->check,
                      "say whether these files are scenarios, and what is wrong with the first "
                      "wrong key of each; exit code 2 if any is refused");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] {
    if (arguments->check.empty())
      print_document(io::scenario_schema());
    else
      exit_code = check(*arguments);
  });
}

}  // namespace loosefit
