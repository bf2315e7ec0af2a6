#pragma once
#include <filesystem>

#include "loosefit/base/progress.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// The folder of validation.json and validation.html, begun before the benchmarks run so that what
/// is in the way shows before the long work. Without write() it leaves nothing behind.
class ValidationOutput {
 public:
  /// \throws InvalidInput if something else or something changed is there; IoError.
  explicit ValidationOutput(const std::filesystem::path& folder);
  /// Puts both files in their place, once. \throws Cancelled as `progress` asks; InvalidInput if
  /// something foreign has come in the way; IoError.
  void write(const Validation& validation, Progress& progress);

 private:
  io::RunFolder folder_;
};

}  // namespace loosefit::validate
