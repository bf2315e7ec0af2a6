#include <gtest/gtest.h>

#include "loosefit/drape/drape.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/drape/settling_budget.h"

namespace loosefit::drape {
namespace {

Certificate balanced(double residual, double largest) {
  Certificate c;
  c.residual = residual, c.residual_max = largest;
  c.intersections_body = c.intersections_self = 0;
  return c;
}

TEST(Certificate, AsksForTheWholeResidualAndForTheLargestForce) {
  EXPECT_TRUE(balanced(1e-3, 0.1).settled());
  EXPECT_FALSE(balanced(1.1e-3, 0.01).settled());
  EXPECT_FALSE(balanced(1e-4, 0.11).settled());
}

TEST(SettlingBudget, HalfOfItIsHalfOfTheIterationsWhateverTheClockSays) {
  DrapeOptions options;
  options.max_iterations = 100;
  options.time_budget = 1e-9;
  SettlingBudget budget(options);
  budget.count(50, false);
  EXPECT_TRUE(budget.is_half_left());
  budget.count(1, false);
  EXPECT_FALSE(budget.is_half_left());
}

}  // namespace
}  // namespace loosefit::drape
