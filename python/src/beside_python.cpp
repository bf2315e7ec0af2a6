#include "beside_python.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "loosefit/base/resources.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
constexpr std::chrono::milliseconds kPause{50};

/// What the work has to tell, until the calling thread comes to fetch it. Every stage is told, of
/// the fractions the latest.
class Mailbox : public Progress {
 public:
  using News = std::vector<std::pair<std::string, double>>;

  void stage(const std::string& name) override {
    const std::lock_guard lock(mutex_);
    news_.emplace_back(name, 0);
    stage_ = name;
    furthest_ = 0;
  }
  void update(double fraction, const std::string&) override {
    const std::lock_guard lock(mutex_);
    // Residuals rise at times, progress should not.
    furthest_ = std::max(furthest_, std::clamp(fraction, 0.0, 1.0));
    if (news_.empty() || news_.back().first != stage_) news_.emplace_back(stage_, 0);
    news_.back().second = furthest_;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    awake_.notify_all();
  }
  /// Waits a moment, or until the end. Whether it has come.
  bool wait() {
    std::unique_lock lock(mutex_);
    return awake_.wait_for(lock, kPause, [&] { return ended_; });
  }
  News take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable awake_;
  News news_;
  std::string stage_;
  double furthest_ = 0;
  bool ended_ = false;
};

/// While it lives, this thread, and every thread that it begins, takes no signals that are sent to
/// the process: they would interrupt the writing of files.
class SignalsElsewhere {
 public:
  SignalsElsewhere() {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
      sigdelset(&all, fault);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsElsewhere() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsElsewhere(const SignalsElsewhere&) = delete;
  SignalsElsewhere& operator=(const SignalsElsewhere&) = delete;

 private:
  sigset_t before_;
};

/// The thread of the work. Whoever leaves waits for it.
class Worker {
 public:
  Worker(Mailbox& mailbox, const std::function<void(Progress&)>& work) : mailbox_(mailbox) {
    const SignalsElsewhere quiet;
    try {
      thread_ = std::thread([this, &work] { run(work); });
    } catch (const std::system_error&) {  // no memory for the stack of one more
      throw std::bad_alloc();
    }
  }
  ~Worker() {
    if (!thread_.joinable()) return;
    mailbox_.request_cancel();
    const py::gil_scoped_release release;
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Waits a moment without the GIL. Whether the work is done.
  bool wait() {
    const py::gil_scoped_release release;
    return mailbox_.wait();
  }
  /// After the work. \throws what it threw
  void finish() {
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run(const std::function<void(Progress&)>& work) {
    try {
      const ThreadLimit cores(0);
      work(mailbox_);
    } catch (...) {
      failure_ = std::current_exception();
    }
    mailbox_.end();
  }

  Mailbox& mailbox_;
  std::exception_ptr failure_;
  std::thread thread_;
};

/// Calls back. Whether to go on.
bool tell(const py::object& progress, const Mailbox::News& news) {
  for (const auto& [stage, fraction] : news) {
    const py::object answer = progress(stage, fraction);
    if (answer.ptr() == Py_False) return false;
  }
  return true;
}

}  // namespace

void beside_python(const py::object& progress, const CancelToken* token,
                   const std::function<void(Progress&)>& work) {
  Mailbox mailbox;
  Worker worker(mailbox, work);
  for (bool done = false; !done;) {
    done = worker.wait();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const Mailbox::News news = mailbox.take();
    if ((token && token->cancelled()) || (!progress.is_none() && !tell(progress, news)))
      mailbox.request_cancel();
  }
  worker.finish();
}

}  // namespace loosefit::python
