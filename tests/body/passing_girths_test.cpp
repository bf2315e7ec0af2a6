#include "loosefit/body/passing_girths.h"

#include <gtest/gtest.h>

#include <random>

#include "support/body_fixture.h"
#include "support/stick_person.h"

namespace loosefit::body {
namespace {

BodyParameters someone(double sex, double age = 25) {
  BodyParameters person;
  person.sex = sex;
  person.age = age;
  return person;
}

TEST(PassingGirths, OfAdultsAsAnthropometryHasThem) {
  // Means of ANSUR II, women and men: head 0.562 and 0.574 m, hand 0.187 and 0.214 m; heel and
  // ankle 0.31 and 0.34 m (recalled). The model's people are smaller and less muscular.
  struct Mean {
    double sex, head, hand, foot;
  };
  for (const auto& [sex, head, hand, foot] :
       {Mean{0, 0.562, 0.187, 0.31}, Mean{1, 0.574, 0.214, 0.34}}) {
    const PassingGirths girths = passing_girths(body_model().build(someone(sex), kStanding));
    EXPECT_NEAR(girths.head.value(), head, 0.10 * head) << sex;
    for (const int side : {0, 1}) {
      EXPECT_NEAR(girths.hand[side].value(), hand, 0.10 * hand) << sex;
      EXPECT_NEAR(girths.foot[side].value(), foot, 0.10 * foot) << sex;
    }
  }
}

TEST(PassingGirths, OfDrawnPeopleHaveTheirOrder) {
  std::mt19937 draw(61);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 6; ++k) {
    BodyParameters person = someone(share(draw), 2 + 60 * share(draw));
    person.muscle = share(draw);
    person.weight = 0.2 + 0.6 * share(draw);
    person.height = share(draw);
    const Body body = body_model().build(person, kArmsApart);
    const PassingGirths g = passing_girths(body);
    const auto at = [&](const char* name) { return body.measured.at(name); };
    SCOPED_TRACE(person.age);
    EXPECT_GT(*g.head, 1.2 * at("mid_neck"));
    for (const int side : {0, 1}) {
      EXPECT_GT(*g.hand[side], 1.15 * at("wrist"));
      EXPECT_LT(*g.hand[side], 1.9 * at("wrist"));
      EXPECT_GT(*g.foot[side], 1.3 * at("ankle"));
      EXPECT_LT(*g.foot[side], 2.1 * at("ankle"));
    }
    EXPECT_EQ(*g.chest, at("chest"));
    EXPECT_EQ(*g.hip, at("hip"));
  }
}

TEST(PassingGirths, DoNotDependOnThePosture) {
  const BodyParameters person = someone(0.3, 30);
  const PassingGirths first = passing_girths(body_model().build(person, kArmsApart));
  Posture bent;
  bent.forward_bend = radians(60);
  Posture sitting = kStanding;
  sitting.sitting = 1;
  for (const Posture& posture : {kStanding, bent, sitting}) {
    const PassingGirths g = passing_girths(body_model().build(person, posture));
    EXPECT_NEAR(*g.head, *first.head, 0.03 * *first.head);
    for (const int side : {0, 1}) {
      EXPECT_NEAR(*g.hand[side], *first.hand[side], 0.03 * *first.hand[side]);
      EXPECT_NEAR(*g.foot[side], *first.foot[side], 0.05 * *first.foot[side]);
    }
  }
}

TEST(PassingGirths, OfCylindersAreTheirs) {
  const support::StickPerson person;
  const PassingGirths girths = passing_girths(person.body);
  const double polygon = 32 * 2 * std::sin(kPi / 32);  // of 32 corners on the unit circle
  for (const int side : {0, 1}) {
    EXPECT_NEAR(girths.hand[side].value(), polygon * support::StickPerson::kArm, 1e-4);
    // Half of an ellipse at most: its heel is the lower edge of the cylinder.
    EXPECT_GT(girths.foot[side].value(), 2 * kPi * support::StickPerson::kLeg * 0.9);
  }
  EXPECT_FALSE(girths.head) << "it has none";
  EXPECT_FALSE(girths.chest);
}

TEST(PassingGirths, WithoutJointsNothingIsKnown) {
  Body body = body_model().build(someone(0), kStanding);
  body.joints.clear();
  const PassingGirths none = passing_girths(body);
  EXPECT_FALSE(none.head || none.hand[0] || none.hand[1] || none.foot[0] || none.foot[1]);
}

TEST(PassingGirths, OfALimbThatIsMissingAreAbsent) {
  Body body = body_model().build(someone(0), kStanding);
  body.joints.erase("wrist_R");
  const PassingGirths girths = passing_girths(body);
  EXPECT_TRUE(girths.hand[0]);
  EXPECT_FALSE(girths.hand[1]);
}

TEST(PassingGirths, OfALimbThatEndsEarlierNothingHasToPass) {
  for (const int side : {0, 1}) {
    support::StickPerson person;
    const std::string s = side == 0 ? "_L" : "_R";
    // The skin of the limb is far from where its joints are.
    for (const char* joint : {"elbow", "wrist"}) person.body.joints[joint + s].x() += 3;
    EXPECT_FALSE(passing_girths(person.body).hand[side]);
    person.body.joints["arm_end" + s] = person.body.joints["shoulder" + s];
    EXPECT_EQ(passing_girths(person.body).hand[side], 0.0);
    EXPECT_GT(passing_girths(person.body).hand[1 - side].value(), 0.1);
    for (std::size_t v = 0; v < person.body.segment.size(); ++v)
      if (person.body.segment[v] == Segment::foot && (person.body.side[v] > 0) == (side == 0))
        person.body.segment[v] = Segment::shank;
    EXPECT_FALSE(passing_girths(person.body).foot[side]);
    person.body.joints["leg_end" + s] = person.body.joints["knee" + s];
    EXPECT_EQ(passing_girths(person.body).foot[side], 0.0);
  }
}

}  // namespace
}  // namespace loosefit::body
