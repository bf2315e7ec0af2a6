#include "loosefit/validate/run_validation.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <mutex>

#include "loosefit/base/error.h"
#include "loosefit/base/side_by_side.h"
#include "loosefit/base/text.h"

namespace loosefit::validate {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Outcomes, told in the order of the list whoever is done first, and never while progress is
/// shown: both may write to one terminal.
class Outcomes : public Progress {
 public:
  Outcomes(std::size_t count, Progress& shown,
           const std::function<void(const BenchmarkOutcome&)>& finished)
      : shown_(shown), finished_(finished), all_(count), done_(count, 0) {}

  void update(double fraction, const std::string& note) override {
    const std::lock_guard lock(mutex_);
    shown_.update(fraction, note);
  }
  void check_cancelled() const override { shown_.check_cancelled(); }

  void take(std::size_t i, BenchmarkOutcome outcome) {
    const std::lock_guard lock(mutex_);
    all_[i] = std::move(outcome);
    done_[i] = 1;
    for (; told_ < all_.size() && done_[told_]; ++told_)
      if (finished_) finished_(all_[told_]);
  }

  std::vector<BenchmarkOutcome> all() { return std::move(all_); }

 private:
  Progress& shown_;
  const std::function<void(const BenchmarkOutcome&)>& finished_;
  std::mutex mutex_;
  std::size_t told_ = 0;
  std::vector<BenchmarkOutcome> all_;
  std::vector<char> done_;
};

/// Only the wish to stop gets out; every other failure is an outcome.
BenchmarkOutcome carry_out(const Benchmark& benchmark, Effort effort, Progress& progress) {
  BenchmarkOutcome outcome{benchmark.id, benchmark.title, benchmark.reference, {}, {}, 0};
  const auto start = Clock::now();
  try {
    outcome.result = benchmark.run(effort, progress);
    if (outcome.result.findings.empty()) outcome.error = "it found nothing to compare";
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& e) {
    outcome.error = e.what();
  }
  outcome.seconds = seconds_since(start);
  return outcome;
}

}  // namespace

bool BenchmarkOutcome::gated() const {
  return !error.empty() ||
         std::any_of(result.findings.begin(), result.findings.end(),
                     [](const Finding& f) { return f.gate != Finding::Gate::reported; });
}

Verdict BenchmarkOutcome::verdict() const {
  if (!error.empty() || result.findings.empty()) return Verdict::miss;
  Verdict gravest = Verdict::reported;
  for (const Finding& f : result.findings) gravest = std::max(gravest, f.verdict());
  return gravest;
}

int Validation::gated() const {
  return static_cast<int>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.gated(); }));
}

int Validation::count(Verdict verdict) const {
  return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(),
                                        [&](const auto& o) { return o.verdict() == verdict; }));
}

bool Validation::as_stated() const {
  return std::all_of(outcomes.begin(), outcomes.end(),
                     [](const auto& o) { return is_as_stated(o.verdict()); });
}

std::vector<Benchmark> select_benchmarks(const std::vector<Benchmark>& all,
                                         const std::vector<std::string>& ids, Effort effort) {
  std::vector<std::string> names, requested;
  for (const Benchmark& b : all) names.push_back(b.id);
  for (const std::string& id : ids) {
    requested.push_back(upper(id));
    const auto found = std::find(names.begin(), names.end(), requested.back());
    if (found == names.end())
      throw InvalidInput({"", 0, "--only"}, "\"" + printable(id) + "\"", "the id of a benchmark",
                         did_you_mean(requested.back(), names));
    if (effort == Effort::quick && !all[found - names.begin()].in_quick)
      throw InvalidInput({"", 0, "--only"}, *found + ", which has no quick form",
                         "benchmarks of the quick subset", "leave out --quick");
  }
  std::vector<Benchmark> selected;
  for (const Benchmark& b : all) {
    if (effort == Effort::quick && !b.in_quick) continue;
    if (!requested.empty() &&
        std::find(requested.begin(), requested.end(), b.id) == requested.end())
      continue;
    selected.push_back(b);
  }
  return selected;
}

Validation run_validation(const std::vector<Benchmark>& benchmarks, Effort effort,
                          Progress& progress, int workers,
                          const std::function<void(const BenchmarkOutcome&)>& finished) {
  const auto start = Clock::now();
  Outcomes outcomes(benchmarks.size(), progress, finished);
  std::vector<SideJob> jobs;
  for (std::size_t i = 0; i < benchmarks.size(); ++i)
    jobs.push_back({benchmarks[i].id, [&, i](Progress& own) {
                      // The specimens are small: two benchmarks on a core each are faster than one
                      // on two cores.
                      tbb::task_arena alone(1);
                      BenchmarkOutcome outcome;
                      alone.execute([&] { outcome = carry_out(benchmarks[i], effort, own); });
                      outcomes.take(i, std::move(outcome));
                    }});
  side_by_side(jobs, std::max(1, workers), outcomes);
  Validation validation;
  validation.effort = effort;
  validation.outcomes = outcomes.all();
  validation.seconds = seconds_since(start);
  return validation;
}

}  // namespace loosefit::validate
