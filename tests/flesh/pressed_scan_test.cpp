#include <gtest/gtest.h>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/body/scan_person.h"
#include "loosefit/flesh/soft_body.h"
#include "support/body_fixture.h"

namespace loosefit::flesh {
namespace {

constexpr double kTape = 0.010;  ///< what a scan may differ by from its parametric twin [m]

body::BodyParameters stout(double sex, double age, double height, double chest, double waist,
                           double hip) {
  body::BodySpec spec;
  spec.sex = sex, spec.age = age, spec.height = height;
  spec.measurements = {{"chest", chest}, {"waist", waist}, {"hip", hip}};
  return body::fit_body(body_model(), spec).parameters;
}

// Hanging arms press the trunk of stout people over a hand's length, and are pressed: what the
// scanner sees there is thinner than the person.
TEST(PressedScan, StoutPeopleAreFoundWithTheirMeasuresWhenArmsHang) {
  for (const auto& twin :
       {stout(1, 50, 1.76, 1.16, 1.10, 1.14), stout(0, 70, 1.60, 1.04, 0.94, 1.08)}) {
    SoftBody person(body_model(), twin);
    const body::PosedBody known = person.in(body::named_posture("standing"));
    const body::Body built = person.as_built(body::named_posture("standing"));
    ASSERT_NE(known->surface.vertices, built.surface.vertices) << "nothing is pressed";
    const auto found = body::person_from_scan(body_model(), known->surface, {"scan.obj", "m", "z"});
    ASSERT_TRUE(found);
    for (const char* girth :
         {"chest", "underbust", "waist", "hip", "neck", "armscye", "scye_depth", "upper_arm",
          "forearm", "wrist", "thigh", "shoulder_breadth", "back_length", "arm_length"})
      EXPECT_NEAR(found->body.measured.at(girth), known->measured.at(girth), kTape) << girth;
  }
}

}  // namespace
}  // namespace loosefit::flesh
