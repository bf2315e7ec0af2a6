#include "loosefit/pipeline/drape_side_by_side.h"

#include <algorithm>
#include <new>

#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/side_by_side.h"

namespace loosefit::pipeline {
namespace {

/// Share of the memory of the machine that drapes side by side may take.
constexpr double kMemoryShare = 0.5;

}  // namespace

int drapes_at_once() {
  const double peak = peak_memory_mb(), all = usable_memory_mb();
  const double room = peak > 0 && all > 0 ? kMemoryShare * all / peak : 1;
  return std::max(1, static_cast<int>(std::min(room, static_cast<double>(usable_threads()))));
}

void drape_side_by_side(const std::vector<DrapeJob>& jobs, int at_once, Progress& progress) {
  const int sharing = std::max(1, std::min(at_once, static_cast<int>(jobs.size())));
  std::vector<SideJob> timed;
  for (const DrapeJob& job : jobs)
    timed.push_back({job.name, [&job, sharing](Progress& own) {
                       try {
                         job.drape(sharing, own);
                       } catch (const Cancelled&) {
                         throw;
                       } catch (const Error& error) {
                         job.failed(error.what());
                       } catch (const std::bad_alloc&) {
                         job.failed(kNoMemory);
                       }
                     }});
  side_by_side(timed, at_once, progress);
}

}  // namespace loosefit::pipeline
