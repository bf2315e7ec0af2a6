#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"

namespace loosefit::pipeline {

/// How many more drapes to make side by side: one per thread, as far as memory goes. To be asked
/// right after the first one, for none takes more than the process has taken until then.
int drapes_at_once();

/// Why a drape is not made for which there was no memory: a lack of the machine, not of the case.
inline constexpr const char* kNoMemory = "not enough memory";

/// A drape that needs nothing from others which are made at the same time.
struct DrapeJob {
  std::string name;  ///< one or two words, for the progress
  /// `sharing`: how many drapes share the threads, so that one gets as many times the time budget.
  std::function<void(int sharing, Progress& progress)> drape;
  /// Told why it could not be draped: what others have made in an hour is not lost for it.
  std::function<void(const std::string& why)> failed;
};

/// Makes all of them, `at_once` (≥ 1) at a time. What one throws, but for Cancelled and faults of
/// the program, is told to its `failed`. \throws as side_by_side.
void drape_side_by_side(const std::vector<DrapeJob>& jobs, int at_once, Progress& progress);

}  // namespace loosefit::pipeline
