#include "loosefit/body/body_parameters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::body {
namespace {

BodyParameters aged(double years) {
  BodyParameters p;
  p.age = years;
  return p;
}

TEST(BodyParameters, AgeFactorsOfTheReference) {
  const struct {
    double years, baby, child, young, old;
  } kAges[] = {{1, 1, 0, 0, 0},          {7, 0.333, 0.667, 0, 0},  {10, 0, 1, 0, 0},
               {12, 0, 0.867, 0.133, 0}, {14, 0, 0.733, 0.267, 0}, {25, 0, 0, 1, 0},
               {90, 0, 0, 0, 1}};
  for (const auto& age : kAges) {
    const auto factor = macro_factors(aged(age.years));
    EXPECT_NEAR(factor.at("baby"), age.baby, 5e-4) << age.years;
    EXPECT_NEAR(factor.at("child"), age.child, 5e-4) << age.years;
    EXPECT_NEAR(factor.at("young"), age.young, 5e-4) << age.years;
    EXPECT_NEAR(factor.at("old"), age.old, 5e-4) << age.years;
  }
}

TEST(BodyParameters, FactorsOfEachParameterSumToOne) {
  for (double x = 0; x <= 1.0001; x += 0.05) {
    BodyParameters p = aged(1 + 89 * x);
    p.sex = x, p.muscle = x, p.weight = 1.6 * x, p.height = x, p.proportions = x, p.cup = x,
    p.firmness = x;
    const auto f = macro_factors(p);
    EXPECT_NEAR(f.at("male") + f.at("female"), 1, 1e-12);
    EXPECT_NEAR(f.at("baby") + f.at("child") + f.at("young") + f.at("old"), 1, 1e-12);
    for (const char* of : {"muscle", "weight", "height", "cup", "firmness"}) {
      const std::string name = of;
      EXPECT_NEAR(f.at("min" + name) + f.at("average" + name) + f.at("max" + name), 1, 1e-12)
          << name;
    }
    EXPECT_NEAR(f.at("uncommonproportions") + f.at("regularproportions") + f.at("idealproportions"),
                1, 1e-12);
  }
}

TEST(BodyParameters, WeightExtrapolatesWithoutClamping) {
  BodyParameters p;
  p.weight = 1.5;
  const auto f = macro_factors(p);
  EXPECT_DOUBLE_EQ(f.at("maxweight"), 2);
  EXPECT_DOUBLE_EQ(f.at("averageweight"), -1);
  EXPECT_DOUBLE_EQ(f.at("minweight"), 0);
}

TEST(BodyParameters, MacroTargetNames) {
  EXPECT_EQ(macro_words("macrodetails/universal-female-old-maxmuscle-minweight"),
            (std::vector<std::string>{"female", "old", "maxmuscle", "minweight"}));
  EXPECT_EQ(macro_words("breast/female-young-averagemuscle-maxweight-mincup-maxfirmness").size(),
            6u);
  EXPECT_TRUE(macro_words("breast/nipple-size-max").empty());
  EXPECT_TRUE(macro_words("measure/measure-bust-increase").empty());
}

TEST(BodyParameters, ValuesOutOfRangeAreNamed) {
  const auto refusal = [](auto change) -> std::string {
    BodyParameters p;
    change(p);
    try {
      check_parameters(p);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal([](BodyParameters&) {}), "accepted");
  EXPECT_NE(refusal([](BodyParameters& p) { p.age = 0.5; }).find("age"), std::string::npos);
  EXPECT_NE(refusal([](BodyParameters& p) { p.weight = 2.1; }).find("2.1"), std::string::npos);
  EXPECT_NE(refusal([](BodyParameters& p) { p.sex = std::nan(""); }).find("sex"),
            std::string::npos);
  EXPECT_NE(refusal([](BodyParameters& p) {
              p.ancestry = {1, 1, 0};
            }).find("ancestry"),
            std::string::npos);
  EXPECT_NE(refusal([](BodyParameters& p) { p.details["waste"] = 0; }).find("waste"),
            std::string::npos);
  EXPECT_NE(refusal([](BodyParameters& p) { p.details["waist"] = 2; }).find("waist"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::body
