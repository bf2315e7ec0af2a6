#include "command_doctor.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "exit_code.h"
#include "loosefit/base/disk_cache.h"
#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/body/body_data.h"
#include "loosefit/io/material_file.h"
#include "loosefit/render/screen.h"
#include "loosefit/report/fact_documents.h"
#include "print_document.h"

namespace loosefit {
namespace {

/// Runs one check: its finding, or the error and the way out.
report::Finding examine_one(const std::string& what, const std::function<std::string()>& check) {
  try {
    return {what, true, check(), {}};
  } catch (const Error& e) {
    return {what, false, e.what(), e.hint()};
  }
}

void print_words(const std::vector<report::Finding>& findings) {
  for (const auto& [library, number] : versions())
    fmt::print("version  {:12} {}\n", library, number);
  fmt::print("version  {:12} {}\n", "cores", usable_threads());
  for (const report::Finding& f : findings) {
    fmt::print("{:8} {:12} {}\n", f.ok ? "ok" : "missing", f.what, terminal_line(f.found));
    if (!f.hint.empty()) fmt::print("         {:12} {}\n", "", terminal_line(f.hint));
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

std::string find_cache() {
  const std::filesystem::path folder = disk_cache::folder();
  if (folder.empty()) return "off";
  const disk_cache::Size size = disk_cache::size();
  constexpr double kMega = 1 << 20;
  return fmt::format("{}: {} files, {:.1f} MB of at most {:.0f}", folder.string(), size.files,
                     static_cast<double>(size.bytes) / kMega, disk_cache::kMostBytes / kMega);
}

std::string find_screen() { return render::Screen().str(); }

int examine(bool json) {
  std::vector<report::Finding> findings = {
      examine_one("body data", find_body_data), examine_one("materials", find_materials),
      examine_one("screen", find_screen), examine_one("cache", find_cache)};
  if (!findings[2].ok) findings[2].hint += "; everything but pictures works without";
  const bool can_run = findings[0].ok && findings[1].ok;
  if (json)
    print_document(report::doctor_document(findings, can_run));
  else
    print_words(findings);
  return can_run ? kGood : kBadInput;
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("doctor", "what is installed, what is missing, how to get it");
  add_json_flag(*command, *json);
  command->callback([json, &exit_code] { exit_code = examine(*json); });
}

}  // namespace loosefit
