#pragma once
#include <filesystem>
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// What to write beside the data files.
struct OutputOptions {
  bool pictures = true;
  bool report = true;
};

/// Writes all files of a case into `folder`: data, pictures and report (timed as stage "report" in
/// result.seconds), summary.json last. \throws IoError, Cancelled.
void write_output(const std::filesystem::path& folder, CaseResult& result,
                  const OutputOptions& options, Progress& progress);

/// The result in a few lines on standard output.
void print_result(const CaseResult& result, const std::string& folder);

}  // namespace loosefit
