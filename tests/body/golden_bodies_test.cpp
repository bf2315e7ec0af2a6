#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "loosefit/body/body_tape.h"
#include "loosefit/body/rulers.h"
#include "loosefit/body/section.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

struct Golden {
  const char* name;
  BodyParameters parameters;
  int targets;
  double stature;  ///< [cm], like the rest
  std::vector<double>
      rulers;  ///< bust, underbust, waist, hips, neck, upperarm, wrist; empty: not given
  double chest, waist, hip;
  double litres;
};

BodyParameters person(double sex, double age) {
  BodyParameters p;
  p.sex = sex;
  p.age = age;
  return p;
}

std::vector<Golden> golden_bodies() {
  BodyParameters e = person(0.4, 10);
  e.height = 0.587;
  BodyParameters f = person(1, 40);
  f.weight = 0.8, f.muscle = 0.3, f.height = 0.6, f.ancestry = {0, 0, 1};
  BodyParameters g = person(0, 14);
  g.weight = 0.3, g.cup = 0.7;
  return {
      {"A",
       person(0.5, 25),
       8,
       165.938,
       {87.96, 73.88, 72.73, 92.83, 32.85, 24.95, 13.59},
       86.79,
       72.40,
       92.46,
       54.908},
      {"B",
       person(0, 25),
       4,
       158.979,
       {82.51, 65.90, 71.16, 94.16, 28.57, 22.94, 12.31},
       81.90,
       70.92,
       93.33,
       47.969},
      {"C",
       person(1, 25),
       4,
       173.040,
       {96.26, 83.96, 76.79, 93.31, 37.37, 27.06, 14.90},
       92.65,
       75.11,
       92.65,
       63.320},
      {"D",
       person(0.4, 10),
       8,
       129.923,
       {65.16, 55.73, 57.87, 71.67, 27.16, 18.48, 10.34},
       64.28,
       57.75,
       71.39,
       26.198},
      {"E",
       e,
       10,
       139.980,
       {68.64, 58.82, 60.86, 75.44, 28.51, 19.52, 11.07},
       67.71,
       60.71,
       75.15,
       31.232},
      {"F",
       f,
       18,
       188.531,
       {109.71, 98.35, 99.32, 110.47, 42.07, 31.32, 18.23},
       106.96,
       98.35,
       109.98,
       94.856},
      {"G",
       g,
       14,
       134.885,
       {68.75, 54.41, 59.00, 76.91, 26.00, 18.67, 10.67},
       68.86,
       59.02,
       76.11,
       28.029},
  };
}

/// Macro targets (all-zero ones included) whose factors leave them a weight.
int active_macro_targets(const BodyData& data, const BodyParameters& parameters) {
  const auto factors = macro_factors(parameters);
  int active = 0;
  for (const auto& [name, field] : data.field_of_name) {
    const auto words = macro_words(name);
    double weight = words.empty() ? 0 : 1;
    for (const std::string& word : words) weight *= factors.at(word);
    active += std::abs(weight) > 1e-9;
  }
  return active;
}

/// Length of a ruler's vertex chain as a polyline [m].
double ruler_length(const std::vector<Vec3>& vertices, const std::string& name) {
  const auto& chain = ruler(name);
  double length = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    length += (vertices[chain[i + 1]] - vertices[chain[i]]).norm();
  return length;
}

TEST(GoldenBodies, AToGAgreeWithTheReference) {
  const std::vector<std::string> rulers = {"bust_circ", "underbust_circ", "waist_circ", "hips_circ",
                                           "neck_circ", "upperarm_circ",  "wrist_circ"};
  const BodyModel& model = body_model();
  for (const auto& golden : golden_bodies()) {
    SCOPED_TRACE(golden.name);
    EXPECT_EQ(active_macro_targets(model.data(), golden.parameters), golden.targets);
    const RestBody rest = model.rest(golden.parameters, BodyDetail::coarse);
    const BodyTape tape(model.data(), rest);
    EXPECT_NEAR(tape.measure("height") * 100, golden.stature, 0.001);
    for (std::size_t i = 0; i < rulers.size(); ++i) {
      EXPECT_NEAR(ruler_length(rest.surface.vertices, rulers[i]) * 100, golden.rulers[i], 0.01)
          << rulers[i];
    }
    EXPECT_NEAR(tape.measure("chest") * 100, golden.chest, 0.01);
    EXPECT_NEAR(tape.measure("waist") * 100, golden.waist, 0.01);
    EXPECT_NEAR(tape.measure("hip") * 100, golden.hip, 0.01);
    EXPECT_NEAR(geometry::enclosed_volume(rest.surface) * 1000, golden.litres, 0.001);
  }
}

void expect_point(const Vec3& found, double x, double y, double z, double tolerance_dm = 0.0002) {
  EXPECT_LT((found - from_decimetres(x, y, z)).cwiseAbs().maxCoeff(), tolerance_dm * 0.1)
      << found.transpose();
}

TEST(GoldenBodies, VerticesAndShoulderJoints) {
  const BodyModel& model = body_model();
  const auto bodies = golden_bodies();
  const auto check = [&](std::size_t which, std::vector<double> c7, std::vector<double> bust,
                         std::vector<double> shoulder) {
    SCOPED_TRACE(bodies[which].name);
    const RestBody rest = model.rest(bodies[which].parameters, BodyDetail::coarse);
    expect_point(rest.surface.vertices[1491], c7[0], c7[1], c7[2]);
    expect_point(rest.surface.vertices[8439], bust[0], bust[1], bust[2]);
    if (shoulder.empty()) return;
    const auto joint = model.data().bones[std::size_t(model.data().bone("upperarm01.L"))].head;
    expect_point(rest.joints[std::size_t(joint)], shoulder[0], shoulder[1], shoulder[2]);
  };
  check(0, {0, 5.7338, -0.3450}, {0.9389, 3.9131, 1.4901}, {1.7004, 5.0213, 0.1931});
  check(1, {0, 5.1275, -0.3192}, {0.9618, 3.4022, 1.5589}, {});
  check(2, {0, 6.3401, -0.3708}, {0.9161, 4.4239, 1.4213}, {1.8649, 5.6075, 0.1783});
  check(4, {0, 3.3490, -0.3916}, {0.7070, 2.0070, 1.1028}, {1.3444, 2.7481, 0.1320});
  check(5, {0, 7.8361, -0.4967}, {0.9711, 5.6614, 1.7186}, {});
}

TEST(GoldenBodies, HTestsTheRepairOfLopsidedTargets) {
  BodyParameters p = person(0.4, 10);
  p.height = 0.587;
  p.details = {{"bust", -0.5}, {"hips", 0.3}};
  const BodyModel& model = body_model();
  const RestBody rest = model.rest(p, BodyDetail::coarse);
  const BodyTape tape(model.data(), rest);
  EXPECT_NEAR(tape.measure("chest") * 100, 60.603, 0.002);
  EXPECT_NEAR(tape.measure("hip") * 100, 80.857, 0.002);
  EXPECT_NEAR(ruler_length(rest.surface.vertices, "bust_circ") * 100, 61.948, 0.002);
  expect_point(rest.surface.vertices[8439], 0.6410, 2.0070, 1.0093);
  expect_point(rest.surface.vertices[1783], -0.6780, 2.0024, 1.0073);
}

TEST(GoldenBodies, ChestSectionIsTrunkAndTwoArms) {
  const BodyModel& model = body_model();
  for (const auto& golden : golden_bodies()) {
    SCOPED_TRACE(golden.name);
    const RestBody rest = model.rest(golden.parameters);
    const double z = ruler_centre(rest.surface.vertices, "bust_circ").z();
    const auto loops = plane_section(rest.surface, Vec3(0, 0, z), Vec3::UnitZ());
    EXPECT_EQ(loops.size(), 3u);
    EXPECT_NE(trunk_loop(loops), nullptr);
  }
}

}  // namespace
}  // namespace loosefit::body
