#include "loosefit/kinds/told_limit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::kinds {
namespace {

// The nearest figure of 0.2367 is 0.237, which is more than that.
TEST(ToldLimit, IsTheNearestFigureOnThePermittedSide) {
  EXPECT_EQ(told_most(0.2367), 0.236);
  EXPECT_EQ(told_least(0.2364), 0.237);
  EXPECT_EQ(told_most(-0.0364), -0.037);
  EXPECT_EQ(told_least(-0.0367), -0.036);
}

TEST(ToldLimit, OfAFigureOfThreePlacesIsThatFigure) {
  for (int i = -2000; i <= 2000; ++i) {
    const double figure = i / 1000.0;
    EXPECT_EQ(told_most(figure), figure);
    EXPECT_EQ(told_least(figure), figure);
    // The least step beyond it counts.
    EXPECT_LT(told_most(std::nextafter(figure, -9)), figure);
    EXPECT_GT(told_least(std::nextafter(figure, 9)), figure);
  }
  EXPECT_EQ(fmt::format("{:.3f} {:.3f}", told_most(0.0004), told_least(-0.0004)), "0.000 0.000");
}

TEST(ToldLimit, ReadsBackFromItsTextAsAValueThatKeepsTheLimit) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const double limit = (double(random() % 4000001) - 2e6) / 1e6;
    const double most = std::stod(fmt::format("{:.3f}", told_most(limit))),
                 least = std::stod(fmt::format("{:.3f}", told_least(limit)));
    EXPECT_LE(most, limit);
    EXPECT_GT(most, limit - 0.001 - 1e-9);
    EXPECT_GE(least, limit);
    EXPECT_LT(least, limit + 0.001 + 1e-9);
  }
}

/// Drafts with a value that is refused, and then with what the refusal says instead.
void expect_advice_is_taken(const char* kind, NamedValues measures, NamedValues fit,
                            const std::string& key, double value) {
  SCOPED_TRACE(fmt::format("{} with {} = {}", kind, key, value));
  double& now = key.starts_with("fit.") ? fit[key.substr(4)] : measures[key.substr(9)];
  now = value;
  try {
    garment_kind(kind).draft({measures, "", fit, {}});
    ADD_FAILURE() << "drafted";
    return;
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, key);
    const std::string said = error.what();
    const std::size_t at = said.find("expected at least ");
    ASSERT_NE(at, std::string::npos) << said;
    now = std::stod(said.substr(at + 18));
    EXPECT_GT(now, value) << said;
  }
  EXPECT_NO_THROW(garment_kind(kind).draft({measures, "", fit, {}})) << now;
}

TEST(ToldLimit, OfALengthThatIsRefusedCanBeWrittenInstead) {
  const NamedValues person = garment_kind("long-sleeve-shirt").sizes.front().measures;
  const NamedValues legs = {{"waist", 0.72},
                            {"hip", 0.97},
                            {"waist_level", 1.03},
                            {"hip_level", 0.85},
                            {"crotch_height", 0.79}};
  // Five steps of 0.37 mm: the nearest figure is too low in some.
  for (int i = 0; i < 5; ++i) {
    const double bit = 0.00037 * i;
    NamedValues m = person;
    m["scye_depth"] += bit;
    for (const char* kind : {"long-sleeve-shirt", "tank-top"})
      expect_advice_is_taken(kind, m, {}, "measures.hps_to_hem", 0.21);
    expect_advice_is_taken("long-sleeve-shirt", m, {}, "measures.arm_length", 0.16);
    NamedValues tank = person;
    tank["neck"] += bit;
    expect_advice_is_taken("tank-top", tank, {}, "measures.shoulder_breadth", 0.16);
    tank["neck"] = 0.60 + bit, tank["shoulder_breadth"] = 0.44;
    expect_advice_is_taken("tank-top", tank, {{"strap_width", 0.15}, {"strap_place", 0}},
                           "fit.chest", -0.35);
    m = person;
    m["neck"] += bit;
    expect_advice_is_taken("hoodie", m, {}, "fit.hood_depth", 0.151);
    m = legs;
    m["crotch_height"] += bit;
    expect_advice_is_taken("trousers", m, {}, "measures.hip_level", 0.70);
    expect_advice_is_taken("trousers", m, {{"crotch_ease", 0.10}}, "fit.leg_length", 0.11);
    m["hip_level"] += bit;
    expect_advice_is_taken("trousers", m, {}, "measures.waist_level", 0.80);
  }
}

}  // namespace
}  // namespace loosefit::kinds
