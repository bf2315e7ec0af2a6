#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/study/database.h"
#include "loosefit/study/store.h"
#include "support/study_on_disk.h"

// Axes of where a sensor sits. What a shift does on a drape is tested with the sites
// (tests/placement/sites_test.cpp), and with a study that runs (tests/python/place_axis_test.py).
namespace loosefit::study {
namespace {

const std::string kHead = "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n";
const std::string kSites =
    "[[scenario.site]]\nname = \"still\"\nlandmark = \"sternum\"\n"
    "[[scenario.site]]\nname = \"moved\"\nlandmark = \"sternum\"\n";

std::string axis(const std::string& place) {
  return "[[axis]]\nname = \"place\"\nplace = " + place + "\n";
}

Plan plan_of(const std::string& text) { return make_plan(parse_study_file(text, "study.toml")); }

scenario::Scenario scenario_of(const PlannedCase& one) {
  return io::parse_scenario(one.toml, "case.toml");
}

std::string refusal(const std::string& text) {
  try {
    plan_of(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PlaceAxis, ShiftsOneSiteByWhatItsLevelsSay) {
  const Plan plan = plan_of(kHead + kSites + axis("{ site = 1, count = 8 }"));
  ASSERT_EQ(plan.cases.size(), 8u);
  std::set<int> eighths_u, eighths_v;
  for (const PlannedCase& one : plan.cases) {
    const AxisLevel& level = plan.study.axes[0].levels[one.levels[0]];
    const std::vector<placement::SiteSpec> sites = scenario_of(one).sites;
    EXPECT_TRUE(sites[0].shift.isZero());
    EXPECT_EQ(sites[1].shift, Vec2(level.inputs.at("place.u"), level.inputs.at("place.v")));
    EXPECT_EQ(sites[1].landmark, "sternum") << "from where it is shifted";
    // Within 20 mm to either side, and spread evenly in both directions.
    EXPECT_LE(sites[1].shift.cwiseAbs().maxCoeff(), 0.020);
    eighths_u.insert(static_cast<int>(std::floor(sites[1].shift.x() / 0.005)));
    eighths_v.insert(static_cast<int>(std::floor(sites[1].shift.y() / 0.005)));
  }
  EXPECT_EQ(eighths_u, (std::set{-4, -3, -2, -1, 0, 1, 2, 3}));
  EXPECT_EQ(eighths_v, eighths_u);
}

TEST(PlaceAxis, HasFivePlacesOfTheFirstSiteUnlessAsked) {
  const Plan plan = plan_of(kHead + kSites + axis("{}"));
  EXPECT_EQ(plan.cases.size(), 5u);
  for (const PlannedCase& one : plan.cases) {
    EXPECT_FALSE(scenario_of(one).sites[0].shift.isZero());
    EXPECT_TRUE(scenario_of(one).sites[1].shift.isZero());
  }
  EXPECT_EQ(plan_of(kHead + kSites + axis("{ shift = 0, count = 1 }")).cases[0].address,
            plan_of(kHead + kSites).cases[0].address)
      << "a shift by nothing changes nothing";
}

TEST(PlaceAxis, ChangesNothingButThePlace) {
  const Plan plan = plan_of(kHead + kSites + axis("{ count = 3 }"));
  std::set<std::string> addresses;
  for (const PlannedCase& one : plan.cases) {
    addresses.insert(one.address);
    std::string without = one.toml;
    const std::size_t line = without.find("shift = [", without.find("[[site]]"));
    ASSERT_NE(line, std::string::npos) << one.toml;
    without.erase(line, without.find('\n', line) + 1 - line);
    EXPECT_EQ(without, plan_of(kHead + kSites).cases[0].toml);
    EXPECT_EQ(one.wearer, plan.cases[0].wearer);
    EXPECT_EQ(one.wearing, plan.cases[0].wearing);
  }
  EXPECT_EQ(addresses.size(), 3u);
}

TEST(PlaceAxis, AddsToTheShiftThatIsThereAndToOtherAxes) {
  const std::string site =
      "[[scenario.site]]\nname = \"s\"\npanel = \"front\"\nat = [0.1, -0.3]\n"
      "shift = [0.05, 0]\n";
  const Plan plan = plan_of(kHead + site + axis("{ count = 2 }") +
                            "[[axis]]\nname = \"more\"\nplace = { shift = 0.1, count = 2 }\n");
  ASSERT_EQ(plan.cases.size(), 4u);
  for (const PlannedCase& one : plan.cases) {
    Vec2 sum(0.05, 0);
    for (std::size_t k = 0; k < 2; ++k) {
      const SiteShift& shift = *plan.study.axes[k].levels[one.levels[k]].shift;
      sum += Vec2(shift.u, shift.v);
    }
    const placement::SiteSpec spec = scenario_of(one).sites[0];
    EXPECT_LT((spec.shift - sum).norm(), 1e-12);
    EXPECT_EQ(spec.at, Vec2(0.1, -0.3));
  }
}

TEST(PlaceAxis, ALatinHypercubeHasAPlaceForEachCase) {
  const Plan plan =
      plan_of("[study]\nmodalities = [\"ecg\"]\ndesign = \"latin-hypercube\"\nsamples = 6\n" +
              kSites + axis("{ site = 0 }") +
              "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0, 0.1]\n");
  std::set<double> u;
  for (const PlannedCase& one : plan.cases) u.insert(scenario_of(one).sites[0].shift.x());
  EXPECT_EQ(u.size(), 6u);
}

TEST(PlaceAxis, IsRefusedWithItsKey) {
  const std::string all = kHead + kSites;
  const auto expect_refused = [&](const std::string& place, const std::string& phrase) {
    const std::string told = refusal(all + axis(place));
    EXPECT_NE(told.find(phrase), std::string::npos) << place << ": " << told;
  };
  for (const auto& [wrong, found] : {std::pair{"\"far\"", "\"far\""},
                                     {"[0.02, 0.01]", "an array of 2"},
                                     {"nan", "nan"},
                                     {"inf", "inf"},
                                     {"-0.01", "-0.01"},
                                     {"20", "20"}})
    expect_refused(std::string("{ shift = ") + wrong + " }",
                   std::string("axis[0].place.shift: found ") + found + ", expected metres from 0");
  for (const auto& [wrong, found] :
       {std::pair{"\"moved\"", "\"moved\""}, {"-1", "-1"}, {"0.5", "0.5"}, {"nan", "nan"}})
    expect_refused(std::string("{ site = ") + wrong + " }",
                   std::string("axis[0].place.site: found ") + found + ", expected a whole number");
  expect_refused("{ count = 0 }", "axis[0].place.count: found 0");
  expect_refused("{ sites = 0 }", "axis[0].place.sites: found an unknown key");
  expect_refused("\"moved\"", "axis[0].place: found \"moved\", expected a table");
  expect_refused("{ site = 2 }", "study.toml: place.site: found 2 in case 1 (place ");
  const std::string line = "[[scenario.site]]\nname = \"l\"\nfrom = \"c7\"\nto = \"sternum\"\n";
  EXPECT_NE(refusal(kHead + line + axis("{}")).find("place.site: found 0, a line, in case 1"),
            std::string::npos)
      << refusal(kHead + line + axis("{}"));
  // What the scenario itself says is judged as in any other.
  const std::string wrong =
      refusal(kHead + "[[scenario.site]]\nname = \"s\"\nlandmark = \"c7\"\nshift = [\"a\", 0]\n" +
              axis("{}"));
  EXPECT_NE(wrong.find("study.toml:7: site[0].shift: found an array of 2"), std::string::npos)
      << wrong;
  const std::string far =
      refusal(kHead + "[[scenario.site]]\nname = \"s\"\nlandmark = \"c7\"\nshift = [0.2, 0.2]\n" +
              axis("{ shift = 0.2 }"));
  EXPECT_NE(far.find("study.toml:7: site[0].shift: found 0."), std::string::npos) << far;
}

// A sum that is a little too large is one of metres; whoever writes 20 means millimetres.
TEST(PlaceAxis, HintsAtAnotherUnitOnlyWhereItCouldBeMeant) {
  const auto hint = [](const std::string& own, const std::string& place) -> std::string {
    try {
      plan_of(kHead + "[[scenario.site]]\nname = \"s\"\nlandmark = \"c7\"\nshift = [" + own +
              ", 0]\n" + axis(place));
    } catch (const InvalidInput& error) {
      return error.hint();
    }
    return "accepted";
  };
  EXPECT_EQ(hint("0.2", "{ shift = 0.2 }"), "");
  EXPECT_EQ(hint("0.3", "{ shift = 0.01 }"), "");
  EXPECT_EQ(hint("20", "{}"), "lengths are in metres: 20 cm is 0.2");
  EXPECT_EQ(hint("-2", "{}"), "lengths are in metres: -2 cm is -0.02");
  EXPECT_EQ(hint("150", "{}"), "lengths are in metres: 150 mm is 0.15");
  EXPECT_EQ(hint("0", "{ shift = 15 }"), "lengths are in metres: 15 cm is 0.15");
}

// Also where a place brings the sum back into the range.
TEST(PlaceAxis, DoesNotHideAShiftThatIsTooFar) {
  const auto with = [](const std::string& own, const std::string& more = "") {
    return kHead + "[[scenario.site]]\nname = \"s\"\nlandmark = \"c7\"\nshift = " + own + "\n" +
           axis("{ shift = 0.15, count = 8 }") + more;
  };
  for (const auto& [own, found] : {std::pair{"[0.3, 0]", "0.3"},
                                   {"[0, -0.3]", "-0.3"},
                                   {"[0.2001, 0]", "0.2001"},
                                   {"[nan, 0]", "nan"}}) {
    const std::string told = refusal(with(own));
    EXPECT_NE(told.find(std::string("study.toml:7: site[0].shift: found ") + found +
                        " in case 1 (place "),
              std::string::npos)
        << own << ": " << told;
    EXPECT_NE(told.find("metres from -0.2 to 0.2"), std::string::npos) << told;
  }
}

struct PlaceOnDisk : StudyOnDisk {
  PlaceOnDisk() { plan = plan_of(std::string(kStudy) + kSites + axis("{ site = 1, count = 2 }")); }
};

TEST_F(PlaceOnDisk, StandsInTheTablesOfTheAxes) {
  const StudyFolder folder = finished("a");
  collect(folder, folder.read_plan());
  const Database database(folder.database(), Database::Mode::read);
  Statement found = database.prepare("SELECT kind, sampled FROM axes WHERE axis = 'place'");
  ASSERT_TRUE(found.step());
  EXPECT_EQ(found.text(0), "place");
  EXPECT_EQ(found.integer(1), 1);
  Statement rows = database.prepare(
      "SELECT l.number, l.label, l.value IS NULL, u.value, v.value FROM levels l "
      "JOIN inputs u ON u.number = l.number AND u.input = 'place.u' "
      "JOIN inputs v ON v.number = l.number AND v.input = 'place.v' "
      "WHERE l.axis = 'place' ORDER BY l.number");
  for (const PlannedCase& one : plan.cases) {
    ASSERT_TRUE(rows.step());
    const AxisLevel& level = plan.study.axes[2].levels[one.levels[2]];
    EXPECT_EQ(rows.integer(0), one.number);
    EXPECT_EQ(rows.text(1), level.label);
    EXPECT_EQ(rows.integer(2), 1) << "places have no order";
    EXPECT_EQ(rows.number(3), level.shift->u);
    EXPECT_EQ(rows.number(4), level.shift->v);
  }
  EXPECT_FALSE(rows.step());
}

}  // namespace
}  // namespace loosefit::study
