#include "loosefit/base/stage_clock.h"

#include <gtest/gtest.h>

#include <thread>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

struct Recorder : Progress {
  std::vector<std::string> heard;
  void stage(const std::string& name) override { heard.push_back(name); }
  void update(double, const std::string& note) override { heard.push_back("  " + note); }
};

TEST(StageClock, ForwardsAndAddsUpRepeatedStages) {
  Recorder shown;
  StageClock clock(shown);
  clock.stage("body");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  clock.stage("pattern");
  clock.update(0.5, "half");
  clock.stage("body");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  clock.stop();
  EXPECT_EQ(shown.heard, (std::vector<std::string>{"body", "pattern", "  half", "body"}));
  ASSERT_EQ(clock.entries().size(), 2u);
  EXPECT_EQ(clock.entries()[0].stage, "body");
  EXPECT_GE(clock.entries()[0].seconds, 0.040);
  EXPECT_LT(clock.entries()[1].seconds, 0.020);
}

TEST(StageClock, CancellingTheShownProgressStopsTheWork) {
  Recorder shown;
  StageClock clock(shown);
  clock.stage("settle");
  EXPECT_NO_THROW(clock.check_cancelled());
  shown.request_cancel();
  EXPECT_THROW(clock.check_cancelled(), Cancelled);
  EXPECT_THROW(clock.stage("maps"), Cancelled);
}

}  // namespace
}  // namespace loosefit
