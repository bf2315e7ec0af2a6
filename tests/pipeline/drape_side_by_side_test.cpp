#include "loosefit/pipeline/drape_side_by_side.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <new>
#include <stdexcept>

#include "loosefit/base/error.h"

namespace loosefit::pipeline {
namespace {

/// How many `count` drapes are told to share the threads.
std::map<std::string, int> shares(int count, int at_once) {
  std::map<std::string, int> found;
  std::vector<int> got(count);
  std::vector<DrapeJob> jobs;
  for (int i = 0; i < count; ++i)
    jobs.push_back({std::to_string(i), [&got, i](int sharing, Progress&) { got[i] = sharing; },
                    [](const std::string& why) { ADD_FAILURE() << why; }});
  Progress silent;
  drape_side_by_side(jobs, at_once, silent);
  for (int i = 0; i < count; ++i) found[jobs[i].name] = got[i];
  return found;
}

TEST(DrapeSideBySide, EachIsToldHowManyShareTheThreads) {
  for (const auto& [name, sharing] : shares(5, 2)) EXPECT_EQ(sharing, 2) << name;
  for (const auto& [name, sharing] : shares(3, 8)) EXPECT_EQ(sharing, 3) << name;
  for (const auto& [name, sharing] : shares(4, 1)) EXPECT_EQ(sharing, 1) << name;
  EXPECT_TRUE(shares(0, 2).empty());
}

TEST(DrapeSideBySide, OneThatCannotBeDrapedIsToldAndTheOthersAreMade) {
  std::vector<std::string> told(4, "made");
  const auto job = [&](int i, std::function<void()> run) {
    return DrapeJob{std::to_string(i), [run](int, Progress&) { run(); },
                    [&told, i](const std::string& why) { told[i] = why; }};
  };
  Progress silent;
  drape_side_by_side(
      {job(0, [] { throw GeometryError("no room"); }), job(1, [] { throw std::bad_alloc(); }),
       job(2, [] { throw SolverFailure("singular"); }), job(3, [] {})},
      2, silent);
  EXPECT_EQ(told, (std::vector<std::string>{"no room", "not enough memory", "singular", "made"}));
  EXPECT_THROW(drape_side_by_side({job(0, [] { throw Cancelled(); })}, 1, silent), Cancelled);
  EXPECT_THROW(drape_side_by_side({job(0, [] { throw std::logic_error("fault"); })}, 1, silent),
               std::logic_error);
}

TEST(DrapeSideBySide, AtLeastOneFitsIntoTheMemory) { EXPECT_GE(drapes_at_once(), 1); }

}  // namespace
}  // namespace loosefit::pipeline
