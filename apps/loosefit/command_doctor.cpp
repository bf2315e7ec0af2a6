#include "command_doctor.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <thread>

#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/body/body_data.h"
#include "loosefit/io/material_file.h"
#include "loosefit/render/display.h"

namespace loosefit {
namespace {

/// Runs one check; prints its finding, or the error and the way out.
bool report(const std::string& what, const std::function<std::string()>& check) {
  try {
    fmt::print("ok       {:12} {}\n", what, terminal_line(check()));
    return true;
  } catch (const Error& e) {
    fmt::print("missing  {:12} {}\n", what, terminal_line(e.what()));
    if (!e.hint().empty()) fmt::print("         {:12} {}\n", "", terminal_line(e.hint()));
    return false;
  }
}

std::string find_body_data() {
  const std::string path = default_body_data_path();
  body::read_body_data(path);
  return path;
}

std::string find_materials() {
  const auto names = io::material_names();
  if (names.empty())
    throw IoError("no cards in " + (data_directory() / "materials").string(),
                  looked_in() + "; set LOOSEFIT_DATA to the folder that holds materials/");
  for (const std::string& name : names) io::load_material(name);
  return fmt::format("{} cards in {}", names.size(), (data_directory() / "materials").string());
}

std::string find_display() {
  render::check_display();
  return std::getenv("DISPLAY");
}

int examine() {
  for (const auto& [library, number] : versions())
    fmt::print("version  {:12} {}\n", library, number);
  fmt::print("version  {:12} {}\n", "cores", std::thread::hardware_concurrency());
  const bool body = report("body data", find_body_data);
  const bool materials = report("materials", find_materials);
  const bool display = report("display", find_display);
  if (!display)
    fmt::print("         {:12} everything but pictures works without: --no-pictures\n", "");
  return body && materials ? kGood : kBadInput;
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  app.add_subcommand("doctor", "what is installed, what is missing, how to get it")
      ->callback([&exit_code] { exit_code = examine(); });
}

}  // namespace loosefit
