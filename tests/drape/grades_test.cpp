#include <gtest/gtest.h>

#include "loosefit/drape/drape_session.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

TEST(Grades, ACertificateIsOfTheGradeThatItReaches) {
  Certificate c;
  c.intersections_body = c.intersections_self = 0;
  c.residual = 0.019;
  EXPECT_FALSE(c.settled()) << "nobody has asked how far it is to go";
  c.left = LeftToGo{0.9e-4, radians(0.19)};
  EXPECT_TRUE(c.settled());
  EXPECT_EQ(c.grade(), solver::RestGrade::b);
  c.left = LeftToGo{1.1e-4, radians(0.19)};
  EXPECT_FALSE(c.settled());
  c.left = LeftToGo{0.9e-4, radians(0.21)};
  EXPECT_FALSE(c.settled());
  c.left = LeftToGo{0.9e-4, radians(0.19)};
  c.residual = 0.021;
  EXPECT_FALSE(c.settled());
  c.residual = 0.9e-3, c.residual_max = 0.05;
  c.left.reset();
  EXPECT_TRUE(c.settled());
  EXPECT_EQ(c.grade(), solver::RestGrade::a);
  c.intersections_self = 1;
  EXPECT_FALSE(c.settled());
}

/// A shirt on a body that turns its arms, to either grade.
struct Worn {
  Drape put_on, followed;

  explicit Worn(solver::RestGrade grade, bool others_follow, const fabric::Material& material) {
    const body::BodyParameters parameters = support::adult_parameters();
    const garment::GarmentHierarchy shirt = garment::build_hierarchy(
        support::shirt_for(support::standing(parameters, 25), 0.10), 0.03, material);
    DrapeOptions options;
    options.grade = grade;
    options.others_follow = others_follow;
    Progress silent;
    DrapeSession session(shirt, material, options, silent);
    put_on = session.put_on(support::arms_path(parameters, 25, 25));
    followed = session.follow(support::arms_path(parameters, 25, 35), silent);
  }
};

double farthest(const Drape& a, const Drape& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    most = std::max(most, (a.positions[i] - b.positions[i]).norm());
  return most;
}

TEST(Grades, GradeBEndsOnTheWayToGradeA) {
  // Stiff cloth, whose residual falls long after it has come to lie.
  fabric::Material stiff = support::knit();
  stiff.stiffness_warp = stiff.stiffness_weft = 4000;
  stiff.stiffness_shear = 100;
  const Worn a(solver::RestGrade::a, true, stiff), b(solver::RestGrade::b, true, stiff);
  EXPECT_EQ(a.put_on.certificate.grade(), solver::RestGrade::a);
  EXPECT_FALSE(a.put_on.certificate.left.has_value());
  // Others start from there: to grade A, bit by bit the same.
  EXPECT_EQ(b.put_on.certificate.grade(), solver::RestGrade::a);
  EXPECT_EQ(farthest(a.put_on, b.put_on), 0);
  ASSERT_TRUE(b.followed.certificate.settled()) << b.followed.certificate.stop_reason;
  ASSERT_TRUE(b.followed.certificate.left.has_value());
  EXPECT_TRUE(b.followed.certificate.left->is_grade_b());
  EXPECT_EQ(b.followed.certificate.stop_reason, "converged");
  EXPECT_LE(b.followed.report.total().iterations, a.followed.report.total().iterations);
  EXPECT_GE(b.followed.certificate.residual, a.followed.certificate.residual);
  EXPECT_LT(farthest(a.followed, b.followed), 2 * solver::kLeftToMove);
  EXPECT_EQ(b.followed.certificate.intersections_body, 0);

  const Worn alone(solver::RestGrade::b, false, stiff);
  EXPECT_TRUE(alone.put_on.certificate.settled());
  EXPECT_LT(farthest(a.put_on, alone.put_on), 2 * solver::kLeftToMove);
}

}  // namespace
}  // namespace loosefit::drape
