#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "loosefit/io/text_file.h"
#include "support/run_program.h"

namespace loosefit {

/// What a program wrote, its two streams apart.
struct ProgramOutput {
  int exit_code = -1;
  std::string out, err;

  /// Standard output as the one JSON document that it has to be; discarded when it is not.
  nlohmann::json document() const { return nlohmann::json::parse(out, nullptr, false); }
};

/// Runs `environment PROGRAM arguments` of `env`; the streams go through files in `folder`.
inline ProgramOutput run_apart(const std::filesystem::path& folder, const std::string& arguments,
                               const std::string& environment = {}) {
  const std::string out = (folder / "stdout").string(), err = (folder / "stderr").string();
  ProgramOutput run;
  run.exit_code = run_program("env " + environment + " " + LOOSEFIT_BINARY + " " + arguments +
                              " >" + out + " 2>" + err)
                      .exit_code;
  run.out = io::read_text_file(out, 50000000);
  run.err = io::read_text_file(err, 50000000);
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return run;
}

}  // namespace loosefit
