#include "loosefit/drape/explain_unsettled.h"

#include <gtest/gtest.h>

#include <numeric>

#include "loosefit/drape/certify.h"
#include "support/square_over_ball.h"

namespace loosefit::drape {
namespace {

using namespace testing_support;

struct Square : SquareOverBall {
  using SquareOverBall::SquareOverBall;
  Unsettled explain() {
    return explain_unsettled(*model, {&garment}, x, body->body,
                             certify(*model, x, body->body, {StopReason::time_budget}));
  }
};

constexpr int kGravity = 2, kBodyContact = 3;  // in kForceNames

TEST(ExplainUnsettled, FlatClothInTheAirLacksItsWeightAndNothingElse) {
  Square square(0.05);
  const Unsettled u = square.explain();
  // Nothing carries it: the net force is the whole weight, a thousand times the allowed share.
  EXPECT_NEAR(u.times_allowed, 1000, 1e-6);
  EXPECT_TRUE(u.cuts.empty());
  EXPECT_EQ(u.lagging_share, 0);
  ASSERT_EQ(u.worst.size(), 10u);
  std::vector<double> weight;
  for (double m : square.garment.vertex_mass) weight.push_back(m * 9.80665);
  double before = 1e9;
  for (const UnbalancedVertex& v : u.worst) {
    EXPECT_NEAR(v.net, weight[v.vertex], 1e-9);
    EXPECT_LE(v.net, before);
    before = v.net;
    for (std::size_t k = 0; k < v.force.size(); ++k)
      EXPECT_NEAR(v.force[k], k == kGravity ? weight[v.vertex] : 0, 1e-9) << kForceNames[k];
    EXPECT_EQ(v.panel, "cloth");
    EXPECT_EQ(v.near, "right thigh");
    EXPECT_EQ(v.at, square.garment.vertex_uv[v.vertex]);
  }
  // As many vertices as it takes of the heaviest to make 90 % of Σ w².
  std::sort(weight.rbegin(), weight.rend());
  const double all = std::inner_product(weight.begin(), weight.end(), weight.begin(), 0.0);
  double part = 0;
  int count = 0;
  while (part < 0.9 * all) part += weight[count] * weight[count], ++count;
  EXPECT_EQ(u.vertices_of_most, count);
  EXPECT_NE(u.why.find("cloth"), std::string::npos) << u.why;
  EXPECT_NE(u.why.find("gravity"), std::string::npos) << u.why;
}

TEST(ExplainUnsettled, ClothThatCutsTheBallIsPushedBackAndNamesWhatItCuts) {
  Square square(-0.01);
  const Unsettled u = square.explain();
  ASSERT_FALSE(u.cuts.empty());
  EXPECT_LE(u.cuts.size(), 20u);
  for (const CutTriangle& c : u.cuts) {
    EXPECT_TRUE(c.body);
    EXPECT_EQ(c.segment, body::Segment::thigh);
    EXPECT_EQ(c.with, "right thigh");
    // The plane z = 0.09 cuts the ball of 0.1 m in a circle of √(0.1² − 0.09²) = 0.0436 m.
    EXPECT_NEAR(c.position.head<2>().norm(), 0.0436, 0.03);
    EXPECT_NEAR(c.position.x(), c.at.x() - 0.1, 1e-12);
  }
  const UnbalancedVertex& worst = u.worst.front();
  EXPECT_LT(worst.position.head<2>().norm(), 0.0436);
  EXPECT_GT(worst.force[kBodyContact], 100 * worst.force[kGravity]);
  EXPECT_NE(u.why.find("body contact"), std::string::npos) << u.why;
  EXPECT_NE(u.why.find("cut the body: cloth the right thigh"), std::string::npos) << u.why;
}

}  // namespace
}  // namespace loosefit::drape
