#include "loosefit/base/side_by_side.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <mutex>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"

namespace loosefit {
namespace {

/// Who runs what, what is done, and one progress for all.
class Board {
 public:
  Board(const std::vector<SideJob>& jobs, Progress& progress)
      : jobs_(jobs),
        progress_(progress),
        fraction_(jobs.size(), 0.0),
        note_(jobs.size()),
        runs_(jobs.size(), 0) {}

  /// Index of the next job, −1 when there is none or the work was given up.
  int take() {
    const std::lock_guard lock(mutex_);
    if (failure_ || next_ == jobs_.size()) return -1;
    runs_[next_] = 1;
    show();
    return static_cast<int>(next_++);
  }

  void update(int i, double fraction, const std::string& note) {
    const std::lock_guard lock(mutex_);
    fraction_[i] = std::clamp(fraction, 0.0, 1.0);
    note_[i] = note;
    show();
  }

  void done(int i) {
    const std::lock_guard lock(mutex_);
    fraction_[i] = 1;
    runs_[i] = 0;
    show();
  }

  /// Everybody is to stop; `reason` is what the caller of side_by_side gets.
  void give_up(const std::exception_ptr& reason) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = reason;
  }

  void check_cancelled() {
    progress_.check_cancelled();
    const std::lock_guard lock(mutex_);
    if (failure_) throw Cancelled();
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void show() {
    double sum = 0;
    std::string text;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      sum += fraction_[i];
      if (!runs_[i]) continue;
      if (!text.empty()) text += " | ";
      text += jobs_[i].name + (note_[i].empty() ? "" : " " + note_[i]);
    }
    progress_.update(sum / static_cast<double>(jobs_.size()), text);
  }

  const std::vector<SideJob>& jobs_;
  Progress& progress_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::vector<double> fraction_;
  std::vector<std::string> note_;
  std::vector<char> runs_;
  std::exception_ptr failure_;
};

/// What one job sees as its progress; stages inside it are no stages of the whole.
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

}  // namespace

void side_by_side(const std::vector<SideJob>& jobs, int at_once, Progress& progress) {
  require(at_once >= 1, "at least one job at a time");
  Board board(jobs, progress);
  const auto work = [&](int) {
    try {
      for (int i = board.take(); i >= 0; i = board.take()) {
        Share share(board, i);
        tbb::this_task_arena::isolate([&] { jobs[i].run(share); });
        board.done(i);
      }
    } catch (...) {
      board.give_up(std::current_exception());
    }
  };
  const int workers = std::min(at_once, static_cast<int>(jobs.size()));
  tbb::parallel_for(0, workers, work, tbb::simple_partitioner());
  board.rethrow();
}

}  // namespace loosefit
