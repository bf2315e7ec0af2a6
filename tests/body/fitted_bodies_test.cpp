#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/body_tape.h"
#include "support/body_fixture.h"

namespace loosefit {
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
    const BodyFit fit = model.fit(spec_of(body), BodyDetail::coarse);
    EXPECT_NEAR(fit.parameters.height, body.h, 0.005);
    EXPECT_NEAR(fit.parameters.weight, body.w, 0.02);
    for (const auto& [key, value] : body.details) {
      EXPECT_NEAR(fit.parameters.details.at(key), value, 0.02) << key;
    }
    for (const auto& row : fit.table) EXPECT_NEAR(row.measured, row.asked, 0.001) << row.name;
    EXPECT_NEAR(enclosed_volume(model.rest(fit.parameters, BodyDetail::coarse).surface) * 1000,
                body.litres, 0.06);
    EXPECT_LE(fit.evaluations, 120);
  }
}

TEST(BodyFit, MeasuresTheSurfaceThatIsBuilt) {
  const BodyModel& model = body_model();
  const BodyFit fit = model.fit(spec_of(fitted_bodies()[5]));
  const Body body = model.build(fit.parameters, {});
  EXPECT_NEAR(body.measured.at("height"), 1.68, 0.001);
  EXPECT_NEAR(body.measured.at("chest"), 0.88, 0.001);
  EXPECT_NEAR(body.measured.at("waist"), 0.72, 0.001);
  EXPECT_NEAR(body.measured.at("hip"), 0.97, 0.001);
}

}  // namespace
}  // namespace loosefit
