#include <gtest/gtest.h>

#include <random>

#include "loosefit/body/joint_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "support/mirror_twins.h"

namespace loosefit::flesh {
namespace {

// Flesh gives way at the armpits, and at the flank to which the trunk bends.
TEST(MirroredFlesh, GivesWayAlikeOnBothSides) {
  std::mt19937 random(37);
  std::uniform_real_distribution<double> share(0, 1);
  for (int draw = 0; draw < 3; ++draw) {
    body::BodyParameters person;
    person.sex = share(random), person.age = 15 + 50 * share(random);
    person.weight = share(random), person.height = 0.4 + 0.3 * share(random);
    const body::Posture posture =
        body::joint_posture({{"side-bend", 12 + 8 * share(random)},
                             {"trunk-rotation", draw == 0 ? 0 : -30 * share(random)}});
    const body::Body one = SoftBody(body_model(), person).in(posture),
                     other = SoftBody(body_model(), person).in(mirrored(posture));
    ASSERT_GT(lopsidedness(body_model().build(person, posture), other), 1e-4) << "flesh gave way";
    EXPECT_LT(lopsidedness(one, other), 1e-3) << "draw " << draw;
  }
}

}  // namespace
}  // namespace loosefit::flesh
