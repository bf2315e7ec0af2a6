#include "loosefit/study/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/study/run_study.h"
#include "support/scratch_folder.h"

namespace fs = std::filesystem;

namespace loosefit::study {
namespace {

const std::string kHead = "[study]\nname = \"x\"\nmodalities = [\"imu-inclination\"]\n";
const std::string kPeople =
    "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 3 }\n";
const std::string kFits =
    "[[axis]]\nname = \"fit\"\nkeys = [\"garment.fit.chest\", \"garment.fit.hip\"]\n"
    "values = [0.05, 0.1]\n";

Plan plan_of(const std::string& text) { return make_plan(parse_study_file(text, "study.toml")); }

void expect_refused(const std::string& text, const std::string& phrase) {
  try {
    plan_of(text);
    FAIL() << text;
  } catch (const InvalidInput& error) {
    const std::string said = std::string(error.what()) + "; " + error.hint();
    EXPECT_NE(said.find(phrase), std::string::npos) << said;
  }
}

TEST(DesignMatrix, CrossedHasEveryCombinationOnce) {
  const auto rows = design_matrix(Design::crossed, {2, 3, 4}, 0, 1);
  EXPECT_EQ(rows.size(), 24u);
  EXPECT_EQ(std::set(rows.begin(), rows.end()).size(), 24u);
  EXPECT_EQ(rows.front(), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(rows[1], (std::vector<int>{0, 0, 1}));
}

TEST(DesignMatrix, PairedGoesAlongAllAxes) {
  const auto rows = design_matrix(Design::paired, {3, 1, 3}, 0, 1);
  EXPECT_EQ(rows, (std::vector<std::vector<int>>{{0, 0, 0}, {1, 0, 1}, {2, 0, 2}}));
  EXPECT_THROW(design_matrix(Design::paired, {3, 2}, 0, 1), InvalidInput);
}

TEST(DesignMatrix, LatinHypercubeHasEveryLevelEquallyOften) {
  const auto rows = design_matrix(Design::latin_hypercube, {12, 4, 5}, 12, 3);
  ASSERT_EQ(rows.size(), 12u);
  std::vector<int> twelve(12), four(4), five(5);
  for (const auto& row : rows) {
    ++twelve[row[0]];
    ++four[row[1]];
    ++five[row[2]];
  }
  EXPECT_EQ(twelve, std::vector<int>(12, 1));
  EXPECT_EQ(four, std::vector<int>(4, 3));
  EXPECT_EQ(*std::max_element(five.begin(), five.end()), 3);
  EXPECT_EQ(*std::min_element(five.begin(), five.end()), 2);
}

TEST(Plan, CasesAreOrdinaryScenarios) {
  const Plan plan = plan_of(kHead + kPeople + kFits);
  ASSERT_EQ(plan.cases.size(), 6u);
  for (const PlannedCase& one : plan.cases)
    EXPECT_EQ(io::scenario_toml(io::parse_scenario(one.toml, "x.toml")), one.toml);
  const scenario::Scenario second = io::parse_scenario(plan.cases[1].toml, "x.toml");
  EXPECT_EQ(second.studied().spec.fit.at("chest"), 0.1);
  EXPECT_EQ(second.studied().spec.fit.at("hip"), 0.1);
  EXPECT_EQ(plan.label(plan.cases[1]), "person 1, fit 0.1");
}

TEST(Plan, AddressesTellWhatMatters) {
  const auto address = [](const std::string& scenario) {
    return plan_of(kHead + "[scenario]\n" + scenario).cases.at(0).address;
  };
  const std::string usual = address("");
  EXPECT_EQ(address("simulation = { threads = 3 }"), usual);
  EXPECT_EQ(address("output = { views = [\"left\"], width = 400 }"), usual);
  EXPECT_EQ(address("ranking = { modality = \"ecg\" }"), usual);
  EXPECT_NE(address("simulation = { seed = 2 }"), usual);
  EXPECT_NE(address("body = { height = 1.7 }"), usual);
  EXPECT_NE(address("donning = { repeats = 2 }"), usual);
  EXPECT_NE(plan_of("[study]\nmodalities = [\"ecg\"]\n").cases.at(0).address, usual);
}

// Who runs a case compares what it reads with the address, to the last bit of drawn angles.
TEST(Plan, AddressesAreThoseOfTheScenariosThatAreWritten) {
  const Plan plan = plan_of(kHead + kPeople +
                            "[[axis]]\nname = \"bend\"\nkey = \"body.posture.forward_bend_deg\"\n"
                            "range = [1, 40]\ncount = 50\n");
  for (const PlannedCase& one : plan.cases)
    EXPECT_EQ(case_address(io::parse_scenario(one.toml, "scenario.toml"), {"imu-inclination"}),
              one.address)
        << one.toml;
}

TEST(Plan, AnotherLevelChangesOnlyItsOwnCases) {
  const Plan before = plan_of(kHead + kPeople + kFits);
  std::string more = kFits;
  more.replace(more.find("0.1]"), 4, "0.1, 0.2]");
  std::set<std::string> known, now;
  for (const PlannedCase& one : before.cases) known.insert(one.address);
  for (const PlannedCase& one : plan_of(kHead + kPeople + more).cases) now.insert(one.address);
  EXPECT_EQ(now.size(), 9u);
  EXPECT_TRUE(std::includes(now.begin(), now.end(), known.begin(), known.end()));
}

TEST(Plan, ADrapeOfAStudyDoesNotEndByTheClock) {
  EXPECT_EQ(io::parse_scenario(plan_of(kHead).cases[0].toml, "x").simulation.time_budget, 1e6);
  const Plan asked = plan_of(kHead + "[scenario.simulation]\ntime_budget = 30\n");
  EXPECT_EQ(io::parse_scenario(asked.cases[0].toml, "x").simulation.time_budget, 30);
}

TEST(Plan, ChosenEaseBecomesAMobilityOfTheWearer) {
  const Plan plan =
      plan_of(kHead +
              "[scenario.body]\nmeasurements = { chest = 0.8 }\n"
              "[[axis]]\nname = \"ease\"\nease = { chosen = \"blouse\", count = 40 }\n");
  double sum = 0;
  for (const PlannedCase& one : plan.cases) {
    const double bgm = io::parse_scenario(one.toml, "x").studied().spec.fit.at("chest");
    EXPECT_NEAR(bgm, *plan.study.axes[0].levels[one.levels[0]].value / 0.8, 1e-4);
    EXPECT_EQ(one.looseness, bgm);
    sum += bgm;
  }
  EXPECT_NEAR(sum / 40, 0.073 / 0.8, 0.003);
}

TEST(Plan, DrawnAxesFollowTheirLaw) {
  const Plan plan = plan_of(kHead +
                            "[[axis]]\nname = \"friction\"\nkey = \"material.friction_body\"\n"
                            "range = [0.2, 0.8]\ndistribution = \"log-normal\"\ncount = 400\n");
  int below = 0, above = 0, lower_half = 0;
  for (const AxisLevel& level : plan.study.axes[0].levels) {
    below += *level.value < 0.2;
    above += *level.value > 0.8;
    lower_half += *level.value < 0.4;  // the geometric mean
  }
  EXPECT_NEAR(below, 20, 1);
  EXPECT_NEAR(above, 20, 1);
  EXPECT_NEAR(lower_half, 200, 1);
}

// Between the 1st and the 99th percentile a normal deviate has 0.935 of its deviation.
TEST(Plan, FabricsHaveMediansDeviationsAndCorrelationsOfThePopulation) {
  constexpr int kCount = 600;
  const Plan plan =
      plan_of(kHead + "[[axis]]\nname = \"fabric\"\nfabrics = { population = \"618-measured\", " +
              "count = " + std::to_string(kCount) + " }\n");
  struct Quantity {
    const char* name;
    double mean, deviation;
  };
  const Quantity all[] = {{"fabric.areal_density", -1.789, 0.806},
                          {"fabric.bending_warp", -11.285, 1.405},
                          {"fabric.bending_weft", -11.691, 1.249}};
  std::vector<std::vector<double>> scores(3);
  for (int k = 0; k < 3; ++k) {
    double sum = 0, squares = 0;
    for (const AxisLevel& level : plan.study.axes[0].levels) {
      const double score =
          (std::log(level.inputs.at(all[k].name)) - all[k].mean) / all[k].deviation;
      sum += score;
      squares += score * score;
      scores[k].push_back(score);
    }
    EXPECT_NEAR(sum / kCount, 0, 0.12) << all[k].name;
    EXPECT_NEAR(std::sqrt(squares / kCount), 0.92, 0.08) << all[k].name;
  }
  const auto correlation = [&](int i, int j) {
    double both = 0, first = 0, second = 0;
    for (int c = 0; c < kCount; ++c) {
      both += scores[i][c] * scores[j][c];
      first += scores[i][c] * scores[i][c];
      second += scores[j][c] * scores[j][c];
    }
    return both / std::sqrt(first * second);
  };
  EXPECT_NEAR(correlation(0, 1), 0.69, 0.06);  // 0.72 before the tails were cut
  EXPECT_NEAR(correlation(0, 2), 0.69, 0.06);
  EXPECT_NEAR(correlation(1, 2), 0.83, 0.05);  // 0.85
}

TEST(Plan, AnAxisForEachCaseIsDrawnAnewForAll) {
  const Plan plan = plan_of(kHead + kPeople + kFits +
                            "[[axis]]\nname = \"friction\"\nkey = \"material.friction_body\"\n"
                            "range = [0.2, 0.8]\neach_case = true\n");
  ASSERT_EQ(plan.cases.size(), 6u);
  std::set<int> levels;
  for (const PlannedCase& one : plan.cases) levels.insert(one.levels[2]);
  EXPECT_EQ(levels.size(), 6u);
}

// Seams beside a pattern are read though nobody names them: they are a part of what a case is.
TEST(Plan, EachDonningOfAnAxisIsAnotherHistory) {
  for (const std::string base : {"", "[scenario.donning]\nmovements = [\"breath\"]\n",
                                 "[scenario.donning]\nrepeats = 1\n"}) {
    const Plan plan = plan_of(kHead + base + "[[axis]]\nname = \"put on\"\ndonnings = 4\n");
    ASSERT_EQ(plan.cases.size(), 4u);
    EXPECT_EQ(plan.drapes(), 4) << "each level is one donning: " << base;
    EXPECT_EQ(same_as_others(plan), 0);
    EXPECT_TRUE(idle_axes(plan).empty());
    std::set<std::vector<double>> shifts;
    for (const PlannedCase& one : plan.cases) {
      const scenario::Scenario scenario = io::parse_scenario(one.toml, "case.toml");
      const auto how = pipeline::planned_donnings(scenario.donning).front();
      shifts.insert({how.shift.x(), how.shift.y(), how.shift.z(), how.twist});
      EXPECT_FALSE(how.shift.isZero()) << one.toml;
      EXPECT_NE(how.friction, 1);
    }
    EXPECT_EQ(shifts.size(), 4u) << base;
  }
  // Repeats of the base stay: so many donnings a level, all drawn.
  EXPECT_EQ(plan_of(kHead + "[scenario.donning]\nrepeats = 3\n[[axis]]\nname = \"put on\"\n"
                            "donnings = 2\n")
                .drapes(),
            6);
  expect_refused(kHead +
                     "[scenario.simulation]\nrepeats = 3\n[[axis]]\nname = \"put on\"\n"
                     "donnings = 2\n",
                 "simulation.repeats");
}

TEST(Plan, TellsOfAxesThatChangeNothing) {
  const std::string shifts =
      "[[axis]]\nname = \"shift\"\nkey = \"donning.shift\"\nvalues = [0.01, 0.02]\n";
  const Plan idle = plan_of(kHead + "[scenario.donning]\nrepeats = 1\n" + kFits + shifts);
  EXPECT_EQ(idle_axes(idle), std::vector<std::string>{"shift"});
  EXPECT_EQ(same_as_others(idle), 2);
  const Plan of_use = plan_of(kHead + "[scenario.donning]\nrepeats = 2\n" + kFits + shifts);
  EXPECT_TRUE(idle_axes(of_use).empty());
  EXPECT_EQ(same_as_others(of_use), 0);
  // Where it changes something beside one level of another axis it is of use.
  const Plan in_part = plan_of(
      kHead + "[[axis]]\nname = \"times\"\nkey = \"donning.repeats\"\nvalues = [1, 2]\n" + shifts);
  EXPECT_TRUE(idle_axes(in_part).empty());
  EXPECT_EQ(same_as_others(in_part), 1);
}

TEST(Plan, TellsOfPeopleWithoutSexOrAge) {
  const support::ScratchFolder scratch;
  const fs::path file = scratch / "people.csv";
  const auto told = [&](const std::string& people, const std::string& axis = "") {
    io::write_text_file(file.string(), people);
    return left_to_base(plan_of(kHead + "[[axis]]\nname = \"person\"\npeople = { file = \"" +
                                file.string() + "\" }\n" + axis));
  };
  EXPECT_TRUE(told("sex,age,height\nfemale,30,1.6\nmale,40,1.8\n").empty());
  EXPECT_EQ(told("age,height\n30,1.6\n40,1.8\n"),
            std::vector<std::string>{"people of axis person have no sex: all take that of "
                                     "[scenario.body]"});
  EXPECT_EQ(told("height\n1.6\n").size(), 2u);
  EXPECT_EQ(told("height\n1.6\n",
                 "[[axis]]\nname = \"sex\"\nkey = \"body.sex\"\n"
                 "values = [\"female\", \"male\"]\n")
                .size(),
            1u)
      << "another axis says it";
}

TEST(Plan, AddressesKnowTheSeamsBesideAPattern) {
  const support::ScratchFolder folder;
  io::write_text_file((folder / "top.dxf").string(), "pieces");
  const auto address = [&] {
    scenario::Scenario scenario =
        io::parse_scenario("[garment]\npattern = \"top.dxf\"\n", (folder / "case.toml").string());
    return case_address(scenario, {});
  };
  const std::string without = address();
  io::write_text_file((folder / "top.seams.toml").string(), "confirmed = true\n");
  const std::string with = address();
  EXPECT_NE(with, without);
}

TEST(Plan, TheExamplesAreStudies) {
  const std::string examples = LOOSEFIT_SOURCE_DIR "/examples/";
  const Plan loose = make_plan(read_study_file(examples + "study-how-loose.toml"));
  EXPECT_EQ(loose.cases.size(), 12u * 6);
  EXPECT_EQ(loose.drapes(), 12 * 6 * 2 * 2);
  EXPECT_EQ(loose.study.looseness, "fit");
  const Plan children = make_plan(read_study_file(examples + "study-harms2012.toml"));
  EXPECT_EQ(children.cases.size(), 21u);
  EXPECT_EQ(children.drapes(), 126);
}

TEST(Plan, CountsDrapes) {
  const Plan plan = plan_of(kHead + kFits +
                            "[scenario]\npostures = { list = [\"standing\", \"slouch\"] }\n"
                            "donning = { repeats = 3 }\n");
  EXPECT_EQ(plan.drapes(), 2 * 2 * 3);
}

TEST(Plan, LongCasesRunFirst) {
  const Plan plan = plan_of(kHead + kPeople +
                            "[[axis]]\nname = \"edge\"\nkey = \"simulation.edge_length\"\n"
                            "values = [0.03, 0.01]\n");
  std::vector<std::string> all;
  for (const PlannedCase& one : plan.cases) all.push_back(one.address);
  const std::vector<std::string> order = longest_first(plan, all);
  ASSERT_TRUE(std::is_permutation(order.begin(), order.end(), all.begin(), all.end()));
  std::map<std::string, double> edge;
  for (const PlannedCase& one : plan.cases) edge[one.address] = one.edge_length;
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end(),
                             [&](const auto& a, const auto& b) { return edge[a] < edge[b]; }));
}

// It is said once, and the cases are those of a study file without the key.
TEST(Plan, ACertificateOfAnEarlierStudyFileChangesNothingAndIsTold) {
  const std::string text = kHead + kFits, simulation = "[scenario.simulation]\ncertificate = ";
  const Plan without = plan_of(text), a = plan_of(text + simulation + "\"A\"\n"),
             b = plan_of(text + simulation + "\"B\"\n");
  EXPECT_TRUE(without.notes.empty());
  EXPECT_TRUE(a.notes.empty()) << "it has what it asks for";
  ASSERT_EQ(b.notes.size(), 1u);
  EXPECT_NE(b.notes.begin()->find("certificate has no effect"), std::string::npos);
  ASSERT_EQ(b.cases.size(), without.cases.size());
  for (std::size_t i = 0; i < b.cases.size(); ++i) {
    EXPECT_EQ(b.cases[i].toml, without.cases[i].toml);
    EXPECT_EQ(b.cases[i].address, without.cases[i].address);
  }
  EXPECT_THROW(plan_of(text + simulation + "\"C\"\n"), InvalidInput);
}

// As for crossed designs, where each_case has the draws of all cases.
TEST(Plan, ALatinHypercubeDrawsAnAxisForEachCaseToo) {
  const std::string head =
      "[study]\nmodalities = [\"imu-inclination\"]\n"
      "design = \"latin-hypercube\"\nsamples = 8\n";
  const Plan plan = plan_of(head + kFits +
                            "[[axis]]\nname = \"friction\"\nkey = \"material.friction_body\"\n"
                            "range = [0.2, 0.8]\neach_case = true\n");
  std::set<int> levels;
  for (const PlannedCase& one : plan.cases) levels.insert(one.levels[1]);
  EXPECT_EQ(levels.size(), 8u);
}

// Lines and paths are those of the file in which they stand, whatever they are laid over.
TEST(StudyFile, LaidOverABaseKeepsItsOwnPlaces) {
  const support::ScratchFolder folder;
  fs::create_directories(folder / "bases");
  io::write_text_file((folder / "bases/case.toml").string(), "\n\n[body]\nage = 30\n");
  const std::string file = (folder / "study.toml").string();
  const auto complaint = [&](const std::string& text) -> std::string {
    try {
      make_plan(parse_study_file("[study]\nbase = \"bases/case.toml\"\n" + text, file));
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(complaint(""), "accepted");
  EXPECT_NE(complaint("[scenario.body]\nheight = 9\n").find(file + ":4: body.height: found 9"),
            std::string::npos)
      << complaint("[scenario.body]\nheight = 9\n");
  const std::string axis = "[[axis]]\nname = \"a\"\nkey = \"body.age\"\nvalues = [30, 900]\n";
  EXPECT_NE(complaint(axis).find(file + ":6: body.age: found 900"), std::string::npos)
      << complaint(axis);
  const std::string beside = "[scenario.garment]\npattern = \"mine.json\"\n";
  EXPECT_NE(complaint(beside).find(file + ":4: garment.pattern"), std::string::npos);
  io::write_text_file((folder / "mine.json").string(), "{}");
  EXPECT_EQ(complaint(beside), "accepted") << "whoever runs it reads it";
}

TEST(StudyFile, ModalityOfTheBaseMayBeAFileBesideIt) {
  const StudyFile study = parse_study_file("[scenario.ranking]\nmodality = \"cards/mine.toml\"\n",
                                           "/somewhere/study.toml");
  EXPECT_EQ(study.modalities, std::vector<std::string>{"/somewhere/cards/mine.toml"});
}

// The plan, which names it, is JSON.
TEST(StudyFile, ScorecardsAreNamedInUtf8WhoeverNamesThem) {
  for (const auto& [text, key] :
       {std::pair("[study]\nmodalities = [\"mine.toml\"]\n", "study.modalities"),
        std::pair("[scenario.ranking]\nmodality = \"mine.toml\"\n", "ranking.modality")})
    try {
      parse_study_file(text, "/some\xff/study.toml");
      FAIL() << key;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place().key, key);
      EXPECT_EQ(error.place().line, 2);
      EXPECT_NE(error.found().find("not UTF-8"), std::string::npos) << error.what();
    }
}

TEST(StudyFile, IsRefusedWithPlace) {
  expect_refused("[study]\nnmae = \"x\"\n", "study.toml:2: study.nmae");
  expect_refused("[study]\nmodalities = [\"imu\"]\n", "study.toml:2: study.modalities");
  expect_refused("[study]\ndesign = \"latin-hypercube\"\n", "samples");
  expect_refused(kHead + "[[axis]]\nname = \"fit\"\n", "an axis of nothing");
  expect_refused(kHead + "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = []\n",
                 "values");
  expect_refused(kHead + kFits + kFits, "twice");
  expect_refused(kHead + "[[axis]]\nname = \"p\"\npeople = { statistics = \"nobody\" }\n",
                 "statistics");
  const std::string shipped = (data_directory() / "scorecards" / "ecg.toml").string();
  expect_refused("[study]\nmodalities = [\"ecg\", \"" + shipped + "\"]\n", "\"ecg\" twice");
  const std::string values = kHead + "[[axis]]\nname = \"a\"\nvalues = [0.1, 0.2]\n";
  expect_refused(
      values + "key = \"garment..fit\"\n",
      "study.toml:7: axis[0].key: found \"garment..fit\" with an empty part, expected keys");
  expect_refused(values + "key = \"site[0].shift\"\n", "a key that is in no array");
  expect_refused(values + "keys = [\"garment.fit.chest\", 3]\n", "axis[0].keys: found 3");
  expect_refused(values + "key = \"garment.fit.chest\"\nlabels = [\"small\", 2]\n",
                 "axis[0].labels: found 2");
  expect_refused(kHead + "[[axis]]\nname = \"a\"\nlevels = []\n", "at least one level");
  expect_refused(kHead + "[[axis]]\nname = \"a\"\npostures = [[\"standing\", 3]]\n",
                 "axis[0].postures: found 3");
  expect_refused(
      kHead + "[[axis]]\nname = \"p\"\npeople = { statistics = \"ansur-2012\", age = [95, 99] }\n",
      "study.toml:6: axis[0].people: found no group");
  expect_refused("[study]\ndesign = \"paired\"\n" + kPeople + kFits,
                 "study.toml: study.design: found");
  // Inputs of two axes under one name would be one column.
  expect_refused(kHead + kPeople +
                     "[[axis]]\nname = \"person.height\"\nkey = \"body.muscle\"\nvalues = [0.4]\n",
                 "the input \"person.height\" of both");
  // A scenario that no run would take, told with the case.
  expect_refused(
      kHead + "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.1, 90]\n",
      "study.toml:7: garment.fit.chest: found 90 in case 2 (fit 90), expected");
  expect_refused(kHead + "[[axis]]\nname = \"a\"\nkey = \"garment.colour\"\nvalues = [1]\n",
                 "garment.colour");
}

// What names nothing would be left out of nothing, without a word.
TEST(StudyFile, NamesOfSitesAndAxesThatNothingHasAreRefused) {
  const std::string site = "[[scenario.site]]\nname = \"my sensor\"\nlandmark = \"sternum\"\n";
  const auto not_at = [](const std::string& names) { return kHead + "not_at = [" + names + "]\n"; };
  EXPECT_EQ(plan_of(not_at("\"my sensor\", \"scapula_L\"") + site).study.not_at.size(), 2u);
  expect_refused(not_at("\"scapula_L\", \"scpaula_R\"") + site,
                 "study.toml:4: study.not_at: found \"scpaula_R\", expected names of a [[site]] of "
                 "the scenario or of preset sites; did you mean \"scapula_R\"?");
  expect_refused(not_at("\"my senser\"") + site, "did you mean \"my sensor\"?");
  expect_refused(not_at("\"back\"") + site, "known: ");  // a region is no site
  const std::string without = "[scenario.output]\npreset_sites = false\n";
  expect_refused(not_at("\"scapula_L\"") + without + site, "found \"scapula_L\"");
  // Of some cases alone.
  const std::string axis =
      "[[axis]]\nname = \"a\"\nlevels = [{ set = { site = [{ name = \"other\", landmark = "
      "\"sternum\" }] } }, { set = { body = { age = 30 } } }]\n";
  EXPECT_EQ(plan_of(not_at("\"my sensor\", \"other\"") + site + axis).cases.size(), 2u);
  expect_refused(kHead + "looseness = \"fitt\"\n" + kFits,
                 "study.toml:4: study.looseness: found \"fitt\"");
  expect_refused(kHead + "looseness = \"fitt\"\n" + kFits, "did you mean \"fit\"?");
  expect_refused(kHead + "[[axis]]\nname = \"a\"\nkey = \"ranking.modality\"\nvalues = [\"ecg\"]\n",
                 "modalities of [study]");
}

}  // namespace
}  // namespace loosefit::study
