#include "loosefit/drape/stop_reason.h"

#include <gtest/gtest.h>

namespace loosefit::drape {
namespace {

TEST(StopReason, SaysWhatTheSolverSaid) {
  using Reason = solver::SettleOutcome::Reason;
  for (const Reason reason : {Reason::converged, Reason::iteration_limit, Reason::stopped,
                              Reason::stuck, Reason::diverged}) {
    solver::SettleOutcome outcome;
    outcome.reason = reason;
    EXPECT_EQ(Stop{stop_reason(reason)}.text(), outcome.text());
  }
}

TEST(StopReason, PutsItsFiguresIntoTheSentence) {
  EXPECT_EQ((Stop{.reason = StopReason::caught_in_skin, .depth = 0.0071}.text()),
            "given up: the cloth is caught 7 mm deep in a fold of the skin");
  EXPECT_EQ((Stop{.reason = StopReason::posture_too_long, .iterations = 612}.text()),
            "given up after 612 iterations on the finest level");
  EXPECT_EQ((Stop{.reason = StopReason::no_progress, .iterations = 800, .residual = 3.5}.text()),
            "given up: the net force has made no progress in 800 iterations; at its lowest it was "
            "3.5 times the weight");
  EXPECT_EQ((Stop{.reason = StopReason::slides_down, .iterations = 800, .sunk = 0.104}.text()),
            "the cloth slides down and nothing holds it: its middle has sunk by 0.10 m in 800 "
            "iterations that brought it no nearer to rest");
  EXPECT_TRUE(falls(StopReason::slides_down));
  EXPECT_FALSE(falls(StopReason::no_progress));
}

TEST(StopReason, NamesThePanelsThatFallAtMostSixOfThem) {
  Stop stop{.reason = StopReason::pieces_fall, .pieces = 1, .panels = {"belt"}};
  EXPECT_EQ(stop.text(), "panel belt is sewn to nothing that stays on the body and falls freely");
  stop.panels = {"a", "b"}, stop.pieces = 2;
  EXPECT_EQ(stop.text(), "panels a, b are sewn to nothing that stays on the body and fall freely");
  stop.panels.assign(8, "p");
  EXPECT_NE(stop.text().find("p, p, p, p, p, p, …"), std::string::npos) << stop.text();
}

}  // namespace
}  // namespace loosefit::drape
