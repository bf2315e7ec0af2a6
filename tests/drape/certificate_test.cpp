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

TEST(Certificate, GradeAAsksForTheWholeResidualAndForTheLargestForce) {
  EXPECT_TRUE(balanced(1e-3, 0.1).settled());
  EXPECT_EQ(balanced(1e-3, 0.1).grade(), solver::RestGrade::a);
  EXPECT_FALSE(balanced(1.1e-3, 0.01).settled());
  EXPECT_FALSE(balanced(1e-4, 0.11).settled());
}

TEST(Certificate, GradeBAsksForTheLargestForceToo) {
  const auto near = [](double residual, double largest) {
    Certificate c = balanced(residual, largest);
    c.left = LeftToGo{.move = 1e-5, .turn = 1e-3};
    return c;
  };
  EXPECT_TRUE(near(0.02, 2).settled());
  EXPECT_EQ(near(0.02, 2).grade(), solver::RestGrade::b);
  EXPECT_FALSE(near(0.021, 1).settled());
  EXPECT_FALSE(near(0.01, 2.1).settled()) << "on one particle";
  EXPECT_FALSE(balanced(0.01, 1).settled()) << "nobody asked how far it has to go";
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
