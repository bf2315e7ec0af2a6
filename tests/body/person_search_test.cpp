#include "loosefit/body/person_search.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <regex>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_tape.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

constexpr BodyDetail kCoarse = BodyDetail::coarse;

double measured(const BodyParameters& person, const std::string& name) {
  const RestBody rest = body_model().rest(person, kCoarse);
  return BodyTape(body_model().data(), rest).measure(name);
}

/// Largest miss of a fit; 1 where it is refused.
double worst_miss(const BodySpec& spec) {
  try {
    double worst = 0;
    for (const MeasureRow& row : fit_body(body_model(), spec, kCoarse).table)
      worst = std::max(worst, miss(row));
    return worst;
  } catch (const InvalidInput&) {
    return 1;
  }
}

struct Refusal {
  std::string key, expected, hint;
};

Refusal refusal(const BodySpec& spec) {
  try {
    fit_body(body_model(), spec, kCoarse);
  } catch (const InvalidInput& error) {
    return {error.place().key, error.expected(), error.hint()};
  }
  return {"accepted", "", ""};
}

/// The number behind some words, or NaN.
double number_after(const std::string& text, const std::string& words) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(words + " ([0-9.]+) m"))
             ? std::stod(found[found.size() - 1])
             : std::nan("");
}

TEST(PersonSearch, FindsMeasuresThatABodyOfTheModelHas) {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> share(0, 1), change(-0.6, 0.6);
  for (int draw = 0; draw < 12; ++draw) {
    BodyParameters person;
    person.sex = share(random), person.age = 8 + 65 * share(random);
    person.weight = 1.6 * share(random), person.height = 0.3 + 0.4 * share(random);
    for (const char* key : {"bust", "underbust", "waist", "hips", "upper_arm", "thigh", "calf"})
      person.details[key] = change(random);
    BodySpec spec;
    spec.sex = person.sex, spec.age = person.age, spec.height = measured(person, "height");
    for (const char* name : {"chest", "waist", "hip"})
      spec.measurements[name] = measured(person, name);
    if (draw % 2 == 0)
      for (const char* name : {"upper_arm", "thigh", "calf"})
        spec.measurements[name] = measured(person, name);
    EXPECT_LT(worst_miss(spec), 0.005) << "draw " << draw;
  }
}

TEST(PersonSearch, ReachesVeryHeavyPeopleAndPregnantWomen) {
  const auto met = [](double sex, double age, double height, double chest, double waist,
                      double hip) {
    return worst_miss({.sex = sex,
                       .age = age,
                       .height = height,
                       .measurements = {{"chest", chest}, {"waist", waist}, {"hip", hip}}});
  };
  EXPECT_LT(met(1, 50, 1.80, 1.35, 1.40, 1.30), 0.005);
  EXPECT_LT(met(1, 50, 1.80, 1.20, 1.22, 1.09), 0.005);
  EXPECT_LT(met(0, 60, 1.55, 1.40, 1.37, 1.45), kMostMiss);
  EXPECT_LT(met(0, 31, 1.65, 1.05, 1.18, 1.08), kMostMiss);
  EXPECT_LT(met(0, 30, 1.68, 0.98, 1.10, 1.05), 0.005);
  EXPECT_LT(met(0, 40, 1.60, 1.20, 1.15, 1.25), 0.005);
  EXPECT_LT(met(0.4, 11, 1.45, 0.95, 0.95, 1.00), 0.005);
}

// No start of a search at the ends of the model leads nearer than what is told.
TEST(PersonSearch, TheNearestIsTheNearest) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(0, 1);
  for (int draw = 0; draw < 4; ++draw) {
    BodyParameters fixed;
    fixed.sex = share(random), fixed.age = 20 + 40 * share(random);
    const double stature = 1.5 + 0.4 * share(random);
    const std::vector<MeasureRow> asked = {{"height", stature},
                                           {"chest", stature * (0.55 + 0.4 * share(random))},
                                           {"waist", stature * (0.4 + 0.6 * share(random))},
                                           {"hip", stature * (0.5 + 0.5 * share(random))}};
    PersonSearch search(body_model(), kCoarse, fixed, nullptr);
    const double nearest = search.nearest(asked).misfit;
    for (int start = 0; start < 4; ++start) {
      std::vector<Unknown> unknowns = {{"height", 0.5, 0, 1, 0.3, share(random)},
                                       {"weight", 0.5, 0, kHeaviest, 0.5, 2 * share(random)}};
      for (const char* key : {"bust", "underbust", "waist", "hips", "trunk_depth", "hip_depth"})
        unknowns.push_back({key, 0, -1, 1, 0.5, 2 * share(random) - 1});
      EXPECT_LT(
          nearest,
          1.02 * nearest_person(body_model(), kCoarse, fixed, asked, unknowns, nullptr).misfit +
              0.5);
    }
  }
}

TEST(PersonSearch, AGirthThatIsMissedIsRefusedOnLimbsToo) {
  BodySpec spec;
  spec.sex = 0, spec.height = 1.68;
  const BodyParameters person = fit_body(body_model(), spec, kCoarse).parameters;
  for (const auto& [name, share] : {std::pair("thigh", 0.55), std::pair("thigh", 1.6),
                                    std::pair("upper_arm", 0.5), std::pair("neck", 1.6)}) {
    SCOPED_TRACE(name);
    spec.measurements = {{"hip", measured(person, "hip")}, {name, share * measured(person, name)}};
    const Refusal told = refusal(spec);
    EXPECT_EQ(told.key, name);
    // The limit that is told is reached, and what is farther is refused.
    const double limit = number_after(told.expected, "at (most|least) about");
    spec.measurements[name] = limit;
    EXPECT_LT(worst_miss(spec), 0.01) << limit;
    spec.measurements[name] = limit * (share < 1 ? 0.9 : 1.1);
    EXPECT_EQ(worst_miss(spec), 1) << limit;
  }
}

// Of wishes at odds each is told: the odd one as the error, those that the nearest body misses with
// it beside its limit, those that it meets not.
TEST(PersonSearch, WishesAtOddsAreAllNamed) {
  for (const auto& [chest, waist] : {std::pair(0.80, 1.25), std::pair(0.84, 1.35)}) {
    BodySpec spec;
    spec.sex = 1, spec.height = 1.80;
    spec.measurements = {{"chest", chest}, {"waist", waist}, {"hip", chest}, {"wrist", 0.17}};
    const Refusal told = refusal(spec);
    EXPECT_EQ(told.key, "waist");
    for (const char* other : {"chest", "hip"})
      EXPECT_NEAR(number_after(told.expected, std::string("beside .*") + other), chest, 1e-9)
          << told.expected;
    EXPECT_EQ(told.expected.find("wrist"), std::string::npos) << told.expected;
  }
}

TEST(PersonSearch, TheEndOfTheModelIsTold) {
  const Refusal told =
      refusal({.sex = 1, .age = 45, .height = 1.75, .measurements = {{"waist", 1.8}}});
  EXPECT_EQ(told.key, "waist");
  const double end = number_after(told.hint, "the body model ends at about waist");
  EXPECT_GT(end, 1.3) << told.hint;
  EXPECT_LT(worst_miss({.sex = 1, .age = 45, .height = 1.75, .measurements = {{"waist", end}}}),
            0.005);
  EXPECT_EQ(
      worst_miss({.sex = 1, .age = 45, .height = 1.75, .measurements = {{"waist", 1.05 * end}}}),
      1);
}

TEST(PersonSearch, InchesAreSuspectedWhereTheyFit) {
  const auto hint = [](const std::string& name, double value) {
    return refusal({.sex = 0, .height = 1.68, .measurements = {{"hip", 1.04}, {name, value}}}).hint;
  };
  EXPECT_NE(hint("thigh", 0.33).find("inches? 13 in are 0.330 m"), std::string::npos);
  EXPECT_NE(hint("thigh", 0.23).find("inches? 23 in are 0.584 m"), std::string::npos);
  EXPECT_NE(hint("calf", 14).find("inches? 14 in are 0.356 m"), std::string::npos);
  EXPECT_EQ(hint("thigh", 0.34).find("inches"), std::string::npos) << hint("thigh", 0.34);
}

}  // namespace
}  // namespace loosefit::body
