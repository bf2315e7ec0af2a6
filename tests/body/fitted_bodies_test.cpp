#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_tape.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

struct Fitted {
  const char* name;
  double sex, age;
  double h, w;
  std::map<std::string, double> details;
  double stature, chest, waist, hip;  ///< [cm]
  double litres;
};

const std::vector<Fitted>& fitted_bodies() {
  static const std::vector<Fitted> kBodies = {
      {"slim child",
       0.4,
       10,
       0.5872,
       0.0602,
       {{"bust", -0.2103},
        {"underbust", -0.0646},
        {"waist", -0.3217},
        {"hips", -0.5672},
        {"belly", -0.0110}},
       140,
       63,
       55,
       68,
       27.7},
      {"heavy child",
       0.4,
       10,
       0.5872,
       1.0,
       {{"bust", 0.0886},
        {"underbust", 0.1658},
        {"waist", 0.6109},
        {"hips", 0.0299},
        {"belly", 0.1546}},
       140,
       75,
       72,
       80,
       36.6},
      {"girl 14",
       0,
       14,
       0.7037,
       0.4333,
       {{"bust", 0.3482},
        {"underbust", 0.1160},
        {"waist", -0.2760},
        {"hips", 0.0863},
        {"belly", -0.0077}},
       160,
       80,
       65,
       88,
       44.4},
      {"boy 14",
       0.7,
       14,
       0.6674,
       0.4101,
       {{"bust", -0.1782},
        {"underbust", -0.0411},
        {"waist", -0.0923},
        {"hips", 0.0016},
        {"belly", -0.0092}},
       163,
       78,
       67,
       84,
       46.6},
      {"child 7",
       0.4,
       7,
       0.6592,
       0.4211,
       {{"bust", 0.0226},
        {"underbust", -0.0014},
        {"waist", -0.0570},
        {"hips", -0.1237},
        {"belly", -0.0081}},
       122,
       60,
       54,
       64,
       21.5},
      {"woman",
       0,
       30,
       0.5632,
       0.4483,
       {{"bust", 0.1658},
        {"underbust", 0.0654},
        {"waist", -0.1170},
        {"hips", 0.0556},
        {"belly", -0.0036}},
       168,
       88,
       72,
       97,
       54.5},
      {"man",
       1,
       30,
       0.5498,
       0.8371,
       {{"bust", 0.0905},
        {"underbust", 0.0673},
        {"waist", 0.1021},
        {"hips", 0.1261},
        {"belly", 0.0157}},
       180,
       100,
       86,
       102,
       75.4},
  };
  return kBodies;
}

BodySpec spec_of(const Fitted& body) {
  BodySpec spec;
  spec.sex = body.sex;
  spec.age = body.age;
  spec.height = body.stature / 100;
  spec.measurements = {
      {"chest", body.chest / 100}, {"waist", body.waist / 100}, {"hip", body.hip / 100}};
  return spec;
}

TEST(BodyFit, SevenReferenceBodiesWithoutSubdivision) {
  const BodyModel& model = body_model();
  for (const auto& body : fitted_bodies()) {
    SCOPED_TRACE(body.name);
    const BodyFit fit = fit_body(model, spec_of(body), BodyDetail::coarse);
    EXPECT_NEAR(fit.parameters.height, body.h, 0.005);
    EXPECT_NEAR(fit.parameters.weight, body.w, 0.02);
    for (const auto& [key, value] : body.details) {
      EXPECT_NEAR(fit.parameters.details.at(key), value, 0.02) << key;
    }
    for (const auto& row : fit.table) EXPECT_NEAR(row.measured, row.asked, 0.001) << row.name;
    EXPECT_NEAR(
        geometry::enclosed_volume(model.rest(fit.parameters, BodyDetail::coarse).surface) * 1000,
        body.litres, 0.06);
    EXPECT_LE(fit.evaluations, 120);
  }
}

TEST(BodyFit, MeasuresTheSurfaceThatIsBuilt) {
  const BodyModel& model = body_model();
  const BodyFit fit = fit_body(model, spec_of(fitted_bodies()[5]));
  const Body body = model.build(fit.parameters, {});
  EXPECT_NEAR(body.measured.at("height"), 1.68, 0.001);
  EXPECT_NEAR(body.measured.at("chest"), 0.88, 0.001);
  EXPECT_NEAR(body.measured.at("waist"), 0.72, 0.001);
  EXPECT_NEAR(body.measured.at("hip"), 0.97, 0.001);
}

TEST(BodyFit, ManyMeasuresTogether) {
  BodySpec spec;
  spec.sex = 0, spec.age = 30, spec.height = 1.68;
  spec.measurements = {{"chest", 0.90},        {"waist", 0.75},
                       {"hip", 0.98},          {"neck", 0.36},
                       {"upper_arm", 0.29},    {"wrist", 0.155},
                       {"thigh", 0.56},        {"back_length", 0.42},
                       {"arm_length", 0.56},   {"shoulder_breadth", 0.38},
                       {"crotch_height", 0.78}};
  const BodyFit fit = fit_body(body_model(), spec);
  EXPECT_EQ(fit.table.size(), 12u);
  for (const auto& row : fit.table) EXPECT_NEAR(row.measured, row.asked, 0.001) << row.name;
}

TEST(BodyFit, HeavyBodiesExtrapolateAndSaySo) {
  BodySpec spec;
  spec.sex = 1, spec.height = 1.78;
  spec.measurements = {{"chest", 1.20}, {"waist", 1.15}, {"hip", 1.18}};
  const BodyFit fit = fit_body(body_model(), spec, BodyDetail::coarse);
  EXPECT_NEAR(fit.parameters.weight, 1.57, 0.05);
  for (const auto& row : fit.table) EXPECT_NEAR(row.measured, row.asked, 0.002) << row.name;
  ASSERT_FALSE(fit.warnings.empty());
  EXPECT_NE(fit.warnings[0].find("extrapolated"), std::string::npos);
}

// High on their arms trunk and arm are one: the tape goes round the arm below that.
TEST(BodyFit, TheTapeGoesRoundTheArmOfStoutPeople) {
  for (const BodySpec& spec :
       {BodySpec{.sex = 1,
       .age = 71,
       .height = 1.81,
       .measurements = {{"chest", 1.14}, {"waist", 1.131}, {"hip", 1.196}}},
        BodySpec{.sex = 0,
        .age = 73.5,
        .height = 1.663,
        .measurements = {{"chest", 1.093}, {"waist", 1.036}, {"hip", 1.203}}}}) {
    const BodyFit fit = fit_body(body_model(), spec);
    const Body body = body_model().build(fit.parameters, {});
    EXPECT_GT(body.measured.at("upper_arm"), 0.28);
    EXPECT_LT(body.measured.at("upper_arm"), 0.52);
  }
}

// In the plane of their shoulder joint arm, trunk and leg are one: the fold is looked for farther
// out.
TEST(BodyFit, TheScyeOfStoutMenEndsUnderTheArm) {
  const BodyFit fit = fit_body(
      body_model(), {.sex = 1,
                     .age = 38.5,
                     .height = 1.777,
                     .measurements = {{"chest", 1.203}, {"waist", 1.137}, {"hip", 1.155}}});
  const Body body = body_model().build(fit.parameters, {});
  EXPECT_GT(body.measured.at("scye_depth"), 0.12);
  EXPECT_LT(body.measured.at("scye_depth"), 0.35);
}

TEST(BodyFit, WishesThatNoBodyMeetsTogetherAreRefusedWithTheNearest) {
  BodySpec spec;
  spec.height = 1.68;
  spec.measurements = {{"chest", 0.60}, {"waist", 1.40}, {"hip", 0.50}};
  try {
    fit_body(body_model(), spec);
    FAIL() << "this body does not exist";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "waist");
    EXPECT_NE(error.hint().find("waist 0."), std::string::npos) << error.hint();
  }
}

TEST(BodyFit, AWishThatIsNearlyInReachIsReported) {
  BodySpec spec;
  spec.sex = 0.4, spec.age = 10, spec.height = 1.40;
  spec.measurements = {{"chest", 0.66}, {"neck", 0.28}};
  double limit = 0;
  try {
    fit_body(body_model(), spec);
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "neck");
    limit = std::stod(error.expected().substr(error.expected().find("about ") + 6));
  }
  ASSERT_GT(limit, 0.28);
  spec.measurements["neck"] = 0.98 * limit;
  const BodyFit fit = fit_body(body_model(), spec);
  ASSERT_FALSE(fit.warnings.empty());
  EXPECT_NE(fit.warnings[0].find("neck: asked"), std::string::npos) << fit.warnings[0];
}

TEST(BodyFit, HeightAloneIsEnough) {
  BodySpec spec;
  spec.sex = 1, spec.age = 40, spec.height = 1.90;
  const BodyFit fit = fit_body(body_model(), spec);
  ASSERT_EQ(fit.table.size(), 1u);
  EXPECT_NEAR(fit.table[0].measured, 1.90, 0.001);
  EXPECT_TRUE(fit.parameters.details.empty());
}

TEST(BodyFit, AbsurdWishesAreRefusedByName) {
  const auto refusal = [](const std::string& name, double value) -> std::string {
    BodySpec spec;
    spec.height = 1.70;
    if (name == "height") {
      spec.height = value;
    } else {
      spec.measurements[name] = value;
    }
    try {
      fit_body(body_model(), spec);
    } catch (const InvalidInput& error) {
      return std::string(error.what()) + " | " + error.hint();
    }
    return "accepted";
  };
  EXPECT_NE(refusal("chest", 3).find("chest: found 3 m, expected 0.35 to 1.8 m"),
            std::string::npos);
  EXPECT_NE(refusal("height", 0.2).find("height: found 0.2 m"), std::string::npos);
  EXPECT_NE(refusal("height", 168).find("metres"), std::string::npos);
  EXPECT_NE(refusal("waist", std::nan("")).find("waist"), std::string::npos);
  EXPECT_NE(refusal("wiast", 0.7).find("did you mean \"waist\""), std::string::npos)
      << refusal("wiast", 0.7);
}

}  // namespace
}  // namespace loosefit::body
