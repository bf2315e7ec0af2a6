#include "loosefit/base/side_by_side.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

thread_local bool inside = false;  ///< a job, on this thread

TEST(SideBySide, CarriesOutEveryJobOnceNoMoreThanAskedAtATime) {
  for (const int at_once : {1, 2, 7}) {
    std::atomic<int> under_way{0}, most{0};
    std::vector<std::atomic<int>> times(5);
    std::vector<SideJob> jobs;
    for (auto& t : times)
      jobs.push_back({"job", [&](Progress&) {
                        const int now = ++under_way;
                        for (int seen = most;
                             now > seen && !most.compare_exchange_weak(seen, now);) {
                        }
                        // A thread that waits in here must not begin another job meanwhile.
                        EXPECT_FALSE(std::exchange(inside, true));
                        tbb::parallel_for(0, 8, [](int) { wait_a_little(); });
                        inside = false;
                        ++t;
                        --under_way;
                      }});
    Progress silent;
    side_by_side(jobs, at_once, silent);
    for (const auto& t : times) EXPECT_EQ(t, 1) << at_once;
    EXPECT_LE(most, at_once);
  }
}

TEST(SideBySide, BeginsInTheOrderOfTheList) {
  std::vector<int> begun;
  std::vector<SideJob> jobs;
  for (int i = 0; i < 4; ++i) jobs.push_back({"job", [&, i](Progress&) { begun.push_back(i); }});
  Progress silent;
  side_by_side(jobs, 1, silent);
  EXPECT_EQ(begun, (std::vector<int>{0, 1, 2, 3}));
}

TEST(SideBySide, ShowsWhoRunsAndHowFarAllAre) {
  struct Shown : Progress {
    double fraction = 0;
    std::vector<std::string> notes;
    void update(double f, const std::string& note) override {
      fraction = f;
      notes.push_back(note);
    }
    void stage(const std::string&) override { ADD_FAILURE() << "no stage of the whole"; }
  } shown;
  const auto job = [](Progress& p) {
    p.stage("settle");
    p.update(0.5, "halfway");
  };
  side_by_side({{"first", job}, {"second", job}}, 1, shown);
  EXPECT_EQ(shown.fraction, 1);
  EXPECT_EQ(std::count(shown.notes.begin(), shown.notes.end(), "first halfway"), 1);
  EXPECT_EQ(std::count(shown.notes.begin(), shown.notes.end(), "second halfway"), 1);
}

TEST(SideBySide, TheFirstFailureEndsTheWorkAndIsThrown) {
  Progress silent;
  int later = 0;
  const std::vector<SideJob> jobs = {{"good", [](Progress&) {}},
                                     {"bad", [](Progress&) { throw GeometryError("no room"); }},
                                     {"late", [&](Progress&) { ++later; }}};
  EXPECT_THROW(side_by_side(jobs, 1, silent), GeometryError);
  EXPECT_EQ(later, 0);
}

TEST(SideBySide, AFailureStopsTheOthersThatRun) {
  // Two threads, also on a machine with one core.
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  tbb::task_arena arena(2);
  Progress silent;
  std::atomic<bool> runs{false}, stopped{false};
  const std::vector<SideJob> jobs = {
      {"long",
       [&](Progress& p) {
         runs = true;
         const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
         try {
           // Alone it would wait for a failure that cannot come.
           for (; std::chrono::steady_clock::now() < end; wait_a_little()) p.check_cancelled();
         } catch (const Cancelled&) {
           stopped = true;
           throw;
         }
       }},
      {"bad", [&](Progress&) {
         while (!runs) wait_a_little();
         throw GeometryError("no room");
       }}};
  arena.execute([&] { EXPECT_THROW(side_by_side(jobs, 2, silent), GeometryError); });
  EXPECT_TRUE(stopped);
}

TEST(SideBySide, StopsWhenAsked) {
  Progress progress;
  int begun = 0;
  const auto job = [&](Progress& own) {
    ++begun;
    progress.request_cancel();
    own.check_cancelled();
  };
  EXPECT_THROW(side_by_side({{"one", job}, {"two", job}}, 1, progress), Cancelled);
  EXPECT_EQ(begun, 1);
}

TEST(SideBySide, NothingAtATimeIsAnError) {
  Progress silent;
  EXPECT_THROW(side_by_side({}, 0, silent), Error);
  EXPECT_NO_THROW(side_by_side({}, 3, silent));
}

}  // namespace
}  // namespace loosefit
