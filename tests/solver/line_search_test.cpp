#include "loosefit/solver/line_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace loosefit::solver {
namespace {

/// φ given as a function, with a derivative by central differences.
class Curve : public SearchLine {
 public:
  explicit Curve(std::function<double(double)> phi) : phi_(std::move(phi)) {}
  double energy(double t) override {
    asked.push_back(t);
    return phi_(t);
  }
  double slope() override {
    constexpr double kH = 1e-6;
    return (phi_(asked.back() + kH) - phi_(asked.back() - kH)) / (2 * kH);
  }
  double squared_force() override { return squared; }
  void keep() override { kept = asked.back(); }

  std::vector<double> asked;
  double kept = 0, squared = 0;

 private:
  std::function<double(double)> phi_;
};

/// A parabola with its minimum at t = best.
Curve parabola(double best) {
  return Curve([best](double t) { return (t - best) * (t - best); });
}
SearchStart start_of(double best, double first, double limit) {
  return {best * best, -2 * best, 1, first, limit};
}

TEST(LineSearch, TakesAStepThatReachesTheMinimum) {
  Curve line = parabola(1);
  const SearchResult found = line_search(line, start_of(1, 1, 1), {});
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.t, 1);
  EXPECT_EQ(line.kept, 1);
  EXPECT_EQ(line.asked.size(), 1u);
}

TEST(LineSearch, HalvesUntilArmijoHolds) {
  Curve line = parabola(0.1);  // lower than at the start for t < 0.2
  const SearchResult found = line_search(line, start_of(0.1, 1, 1), {});
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.t, 0.125);
  EXPECT_EQ(line.kept, 0.125);
}

TEST(LineSearch, DoublesWhileAParabolaExpectsLowerAndItIs) {
  Curve line = parabola(1);
  const SearchResult found = line_search(line, start_of(1, 0.125, 1), {});
  EXPECT_EQ(found.t, 1);
  EXPECT_EQ(line.asked, (std::vector<double>{0.125, 0.25, 0.5, 1}));
}

TEST(LineSearch, KeepsTheBestPointWhereDoublingDoesNotPay) {
  Curve line([](double t) { return t < 0.6 ? -t : 1.0; });  // a wall that the slope does not show
  const SearchResult found = line_search(line, {0, -1, 1, 0.5, 1}, {});
  EXPECT_EQ(found.t, 0.5);
  EXPECT_EQ(line.kept, 0.5);
  EXPECT_EQ(line.asked.size(), 2u);
}

TEST(LineSearch, StaysWithinTheCollisionLimit) {
  Curve line = parabola(1);
  EXPECT_EQ(line_search(line, start_of(1, 0.5, 0.3), {}).t, 0.3);
  Curve blocked = parabola(1);
  EXPECT_FALSE(line_search(blocked, start_of(1, 1, 0), {}).found);
  EXPECT_TRUE(blocked.asked.empty());
}

TEST(LineSearch, BelowRoundOffLetsASmallerForceDecideUnlessThatIsOff) {
  // A decrease that the energy cannot show: the same number everywhere, slightly above the start.
  const SearchStart start{1e6, -1e-9, 2, 1, 1};
  const auto found = [&](double squared_force, bool accept_below_round_off) {
    Curve line([](double) { return 1e6 + 1e-9; });
    line.squared = squared_force;
    LineSearchTuning tuning;
    tuning.accept_below_round_off = accept_below_round_off;
    return line_search(line, start, tuning);
  };
  EXPECT_TRUE(found(3.9, true).found);
  EXPECT_TRUE(found(3.9, true).below_round_off);
  EXPECT_FALSE(found(4.1, true).found);
  EXPECT_FALSE(found(3.9, false).found);
}

TEST(LineSearch, GivesUpAfterItsBacktracksAlsoWithoutANumber) {
  Curve line([](double) { return std::nan(""); });
  LineSearchTuning tuning;
  tuning.max_backtracks = 5;
  EXPECT_FALSE(line_search(line, {0, -1, 1, 1, 1}, tuning).found);
  EXPECT_EQ(line.asked.size(), 5u);
}

}  // namespace
}  // namespace loosefit::solver
