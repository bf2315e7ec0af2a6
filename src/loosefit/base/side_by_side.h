#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"

namespace loosefit {

/// A piece of long work that needs nothing from the others.
struct SideJob {
  std::string name;  ///< one or two words, for the progress
  std::function<void(Progress&)> run;
};

/// Carries out all jobs, `at_once` (≥ 1) at a time, begun in their order; their progress is shown
/// as one. Threads that no job keeps busy help with the loops inside the others, while a thread
/// that waits inside its job takes up nothing else, so no more than `at_once` are under way. The
/// first exception, Cancelled included, ends the work: jobs that run see Cancelled, no other
/// begins, and it is thrown.
void side_by_side(const std::vector<SideJob>& jobs, int at_once, Progress& progress);

}  // namespace loosefit
