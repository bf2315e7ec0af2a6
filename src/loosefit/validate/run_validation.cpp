#include "loosefit/validate/run_validation.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Work of all threads: who runs what, what is done, and one progress for all.
class Board {
 public:
  Board(const std::vector<Benchmark>& benchmarks, Progress& progress,
        const std::function<void(const BenchmarkOutcome&)>& finished)
      : benchmarks_(benchmarks),
        progress_(progress),
        finished_(finished),
        outcomes_(benchmarks.size()),
        fraction_(benchmarks.size(), 0.0),
        note_(benchmarks.size()),
        state_(benchmarks.size(), State::waiting) {}

  /// Index of the next benchmark to run, −1 when there is none or the work was given up.
  int take() {
    const std::lock_guard lock(mutex_);
    if (failure_ || next_ == benchmarks_.size()) return -1;
    state_[next_] = State::running;
    show();
    return static_cast<int>(next_++);
  }

  void update(int i, double fraction, const std::string& note) {
    const std::lock_guard lock(mutex_);
    fraction_[i] = std::clamp(fraction, 0.0, 1.0);
    note_[i] = note;
    show();
  }

  void done(int i, BenchmarkOutcome outcome) {
    const std::lock_guard lock(mutex_);
    outcomes_[i] = std::move(outcome);
    fraction_[i] = 1;
    state_[i] = State::done;
    for (; told_ < outcomes_.size() && state_[told_] == State::done; ++told_)
      if (finished_) finished_(outcomes_[told_]);
    show();
  }

  /// Everybody is to stop; `reason` is what the caller of run_validation gets.
  void give_up(const std::exception_ptr& reason) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = reason;
  }

  void check_cancelled() {
    progress_.check_cancelled();
    const std::lock_guard lock(mutex_);
    if (failure_) throw Cancelled();
  }

  std::vector<BenchmarkOutcome> outcomes() {
    if (failure_) std::rethrow_exception(failure_);
    return std::move(outcomes_);
  }

 private:
  enum class State : char { waiting, running, done };

  void show() {
    double sum = 0;
    std::string text;
    for (std::size_t i = 0; i < benchmarks_.size(); ++i) {
      sum += fraction_[i];
      if (state_[i] != State::running) continue;
      if (!text.empty()) text += " | ";
      text += benchmarks_[i].id + (note_[i].empty() ? "" : " " + note_[i]);
    }
    progress_.update(sum / static_cast<double>(benchmarks_.size()), text);
  }

  const std::vector<Benchmark>& benchmarks_;
  Progress& progress_;
  const std::function<void(const BenchmarkOutcome&)>& finished_;
  std::mutex mutex_;
  std::size_t next_ = 0, told_ = 0;
  std::vector<BenchmarkOutcome> outcomes_;
  std::vector<double> fraction_;
  std::vector<std::string> note_;
  std::vector<State> state_;
  std::exception_ptr failure_;
};

/// What one benchmark sees as its progress.
class Share : public Progress {
 public:
  Share(Board& board, int index) : board_(board), index_(index) {}
  void update(double fraction, const std::string& note) override {
    board_.update(index_, fraction, note);
  }
  void check_cancelled() const override { board_.check_cancelled(); }

 private:
  Board& board_;
  int index_;
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

bool BenchmarkOutcome::pass() const {
  return error.empty() && !result.findings.empty() &&
         std::all_of(result.findings.begin(), result.findings.end(),
                     [](const Finding& f) { return f.pass(); });
}

int Validation::gated() const {
  return static_cast<int>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.gated(); }));
}

int Validation::passed() const {
  return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(),
                                        [](const auto& o) { return o.gated() && o.pass(); }));
}

bool Validation::pass() const {
  return std::all_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.pass(); });
}

std::vector<Benchmark> select_benchmarks(const std::vector<Benchmark>& all,
                                         const std::vector<std::string>& ids, Effort effort) {
  std::vector<std::string> known, wanted;
  for (const Benchmark& b : all) known.push_back(b.id);
  for (const std::string& id : ids) {
    wanted.push_back(upper(id));
    const auto found = std::find(known.begin(), known.end(), wanted.back());
    if (found == known.end())
      throw InvalidInput({"", 0, "--only"}, "\"" + printable(id) + "\"", "the id of a benchmark",
                         did_you_mean(wanted.back(), known));
    if (effort == Effort::quick && !all[found - known.begin()].in_quick)
      throw InvalidInput({"", 0, "--only"}, *found + ", which has no quick form",
                         "benchmarks of the quick subset", "leave out --quick");
  }
  std::vector<Benchmark> chosen;
  for (const Benchmark& b : all) {
    if (effort == Effort::quick && !b.in_quick) continue;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), b.id) == wanted.end()) continue;
    chosen.push_back(b);
  }
  return chosen;
}

Validation run_validation(const std::vector<Benchmark>& benchmarks, Effort effort,
                          Progress& progress, int workers,
                          const std::function<void(const BenchmarkOutcome&)>& finished) {
  const auto start = Clock::now();
  Board board(benchmarks, progress, finished);
  const auto work = [&] {
    // The specimens are small: two benchmarks on a core each are faster than one on two cores.
    tbb::task_arena alone(1);
    try {
      for (int i = board.take(); i >= 0; i = board.take()) {
        Share share(board, i);
        BenchmarkOutcome outcome;
        alone.execute([&] { outcome = carry_out(benchmarks[i], effort, share); });
        board.done(i, std::move(outcome));
      }
    } catch (...) {
      board.give_up(std::current_exception());
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < std::min<int>(workers, static_cast<int>(benchmarks.size())); ++k)
      others.emplace_back(work);
    work();
  }
  Validation validation;
  validation.effort = effort;
  validation.outcomes = board.outcomes();
  validation.seconds = seconds_since(start);
  return validation;
}

}  // namespace loosefit
