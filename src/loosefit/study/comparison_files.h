#pragma once
#include <filesystem>

#include "loosefit/study/compare.h"

// A comparison as two files that belong together: NAME.csv with the differences of scores, and
// NAME.limits.csv with those of limits.
namespace loosefit::study {

/// The refusals of write_comparison, before the work. \throws InvalidInput, IoError
void check_comparison_files(const std::filesystem::path& file, bool may_replace);

/// Writes both, or none when one of them cannot be written. \throws InvalidInput when something
/// stands there and may not be replaced; IoError.
void write_comparison(const StudyComparison& comparison, const std::filesystem::path& file,
                      bool may_replace);

}  // namespace loosefit::study
