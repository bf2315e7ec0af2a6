#include "loosefit/study/compare.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis_json.h"
#include "support/study_on_disk.h"

// Two studies are compared case by case of what both have: a score of one posture, donning or
// person is never held against that of another.
namespace loosefit::study {
namespace {

const std::string kHead = "[study]\nname = \"NAME\"\nmodalities = [\"imu-uncalibrated\"]\n";
const std::string kPeople =
    "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 3 }\n";
const std::string kFits =
    "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1]\n";
const std::string kStanding = "[scenario.postures]\nlist = [\"standing\"]\n";

struct Comparison : StudyOnDisk {
  /// Score of a case by its label, "person 1, fit 0.1", and of a donning.
  using ScoreOf = std::function<double(const std::string&, int)>;

  StudyData study(const std::string& name, std::string text, const ScoreOf& score,
                  int donnings = 1) const {
    text = kHead + text;
    text.replace(text.find("NAME"), 4, name);
    const Plan made = make_plan(parse_study_file(text, name + ".toml"));
    const StudyFolder folder(base / name);
    fs::create_directories(base);
    folder.write_plan(made);
    for (const PlannedCase& one : made.cases) {
      CaseRecord record = made_up(one.address, 0);
      const SampleRecord sample = record.samples.front();
      record.samples.clear();
      for (int donning = 1; donning <= donnings; ++donning) {
        record.samples.push_back(sample);
        record.samples.back().donning = donning;
        record.samples.back().score = record.samples.back().margin =
            score(made.label(one), donning);
      }
      write_whole(folder.result_file(one.address), record_json(record));
    }
    return read_study_data(folder);
  }
  static void expect_refused(const StudyData& a, const StudyData& b, const std::string& phrase) {
    try {
      compare_studies(a, b);
      FAIL() << phrase;
    } catch (const InvalidInput& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find("have no case in common"), std::string::npos) << said;
      EXPECT_NE(said.find(phrase), std::string::npos) << said;
    }
  }
  static bool says(const StudyComparison& comparison, const std::string& phrase) {
    return comparison_text(comparison).find(phrase) != std::string::npos;
  }
};

bool has(const std::string& label, const std::string& part) {
  return label.find(part) != std::string::npos;
}

double by_posture(const std::string& label, int) { return has(label, "slouch") ? 0.2 : 0.6; }

// Scores that differ only beyond 0 and 1 are equal, in mean, interval and share alike.
TEST_F(Comparison, CountsAsBetterWhatIsBetterBetweenZeroAndOne) {
  const auto always = [](double score) { return [=](const std::string&, int) { return score; }; };
  for (const auto& [x, y] : {std::pair(-2.0, -1.0), std::pair(1.1, 1.2), std::pair(0.5, 0.5)}) {
    const StudyData a = study("a", kPeople, always(x)), b = study("b", kPeople, always(y));
    const PairedDifference same = compare_studies(a, b).differences.at(0);
    EXPECT_EQ(same.mean, 0);
    EXPECT_EQ(same.better, 0);
    EXPECT_FALSE(same.differs());
  }
  const StudyData low = study("a", kPeople, always(-0.1)), high = study("b", kPeople, always(0.1));
  EXPECT_EQ(compare_studies(low, high).differences.at(0).better, 1);
}

// The worst posture of one study is not compared with the only one of another.
// Of two people whose scores rose both, every draw has risen.
TEST_F(Comparison, MarksNoScoresOfFewPeople) {
  const auto of = [&](const std::string& name, int count, double score) {
    return study(name + std::to_string(count),
                 "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = " +
                     std::to_string(count) + " }\n",
                 [score](const std::string&, int) { return score; });
  };
  for (const int count : {3, kFewestForInterval}) {
    const StudyComparison c = compare_studies(of("a", count, 0.3), of("b", count, 0.5));
    ASSERT_EQ(c.differences.size(), 1u);
    EXPECT_GT(c.differences[0].interval.low, 0);
    EXPECT_EQ(c.differences[0].differs(), count == kFewestForInterval) << count;
  }
}

TEST_F(Comparison, TellsOfOtherBodiesBehindTheSameNames) {
  const auto of = [&](const std::string& name, const std::string& sex) {
    fs::create_directories(base);
    io::write_text_file((base / "people.csv").string(), "name,height\nx,1.7\ny,1.75\n");
    return study(name,
                 "[scenario.body]\nsex = \"" + sex +
                     "\"\n[[axis]]\nname = \"person\"\n"
                     "people = { file = \"" +
                     (base / "people.csv").string() + "\" }\n",
                 [](const std::string&, int) { return 0.5; });
  };
  const StudyData woman = of("a", "female");
  EXPECT_TRUE(says(compare_studies(woman, of("b", "male")),
                   "2 of 2 people have another body in a than in b"));
  EXPECT_FALSE(says(compare_studies(woman, of("c", "female")), "another body"));
}

TEST_F(Comparison, IsOfTheSamePostureAlsoWhereOneStudyHasNoAxisOfThem) {
  const StudyData a = study(
      "a",
      kPeople + kFits + "[[axis]]\nname = \"worn\"\npostures = [[\"slouch\"], [\"standing\"]]\n",
      by_posture);
  const StudyData b = study("b", kStanding + kPeople + kFits, by_posture);
  for (const StudyComparison& c : {compare_studies(a, b), compare_studies(b, a)}) {
    ASSERT_EQ(c.differences.size(), 2u);
    for (const PairedDifference& d : c.differences) {
      EXPECT_EQ(d.pairs, 3);
      EXPECT_EQ(d.mean, 0) << "0.4 where slouch and standing are compared";
    }
  }
  const StudyComparison c = compare_studies(a, b);
  EXPECT_EQ(c.cases_a, 12);
  EXPECT_EQ(c.paired_a, 6);
  EXPECT_EQ(c.paired_b, 6);
  EXPECT_TRUE(says(c, "paired: 6 of 12 cases of A with 6 of 6 of B")) << comparison_text(c);
  EXPECT_TRUE(
      says(c, "6 of 12 cases of a have no counterpart in b: 6 of another posture or donning"))
      << comparison_text(c);
}

TEST_F(Comparison, IsOfTheSameDonning) {
  const ScoreOf worse_and_worse = [](const std::string&, int donning) {
    return 0.9 - 0.2 * donning;
  };
  const StudyData a = study("a", kPeople + kFits, worse_and_worse, 3);
  const StudyData b = study("b", kPeople + kFits, worse_and_worse, 2);
  const StudyComparison c = compare_studies(a, b);
  ASSERT_EQ(c.differences.size(), 2u);
  EXPECT_EQ(c.differences[0].mean, 0) << "0.2 where the third donning is held against the second";
  // Of axes of donnings, whatever their names are, those of the same seed.
  const ScoreOf first_alone = [](const std::string& label, int) {
    return has(label, "donning 1") ? 0.7 : 0.3;
  };
  const StudyData one =
      study("one", kPeople + kFits + "[[axis]]\nname = \"x\"\ndonnings = 1\n", first_alone);
  const StudyData two =
      study("two", kPeople + kFits + "[[axis]]\nname = \"y\"\ndonnings = 2\n", first_alone);
  EXPECT_EQ(compare_studies(one, two).differences.at(0).mean, 0);
  EXPECT_EQ(compare_studies(one, two).paired_b, 6);
}

TEST_F(Comparison, OfStudiesWithoutPeopleIsNotByTheNumbersOfCases) {
  const std::string fabrics = "[[axis]]\nname = \"cloth\"\nfabrics = [";
  const ScoreOf by_cloth = [](const std::string& label, int) {
    return has(label, "denim") ? 0.7 : 0.3;
  };
  const StudyData a = study("a", fabrics + "\"denim\", \"cotton-shirting\"]\n", by_cloth);
  const StudyData b = study("b", fabrics + "\"cotton-shirting\", \"denim\"]\n", by_cloth);
  const PairedDifference d = compare_studies(a, b).differences.at(0);
  EXPECT_EQ(d.pairs, 2);
  EXPECT_EQ(d.mean, 0);
  EXPECT_EQ(d.better, 0) << "one in two where case 1 is held against case 1";
  const StudyData other =
      study("other", "[scenario.body]\nheight = 1.8\n" + fabrics + "\"denim\"]\n", by_cloth);
  expect_refused(a, other, "2 of another wearer");
}

TEST_F(Comparison, TellsHowManyCasesHaveNoCounterpart) {
  const ScoreOf same = [](const std::string&, int) { return 0.5; };
  const StudyData a = study("a", kPeople + kFits, same);
  std::string more = kPeople;
  more.replace(more.find("count = 3"), 9, "count = 4");
  std::string fits = kFits;
  fits.replace(fits.find("0.0, 0.1"), 8, "0.1, 0.2");
  const StudyComparison c = compare_studies(a, study("b", more + fits, same));
  EXPECT_EQ(c.paired_a, 3);
  EXPECT_EQ(c.paired_b, 3);
  EXPECT_TRUE(says(c, "3 of 6 cases of a have no counterpart in b: 3 of another fit"))
      << comparison_text(c);
  EXPECT_TRUE(
      says(c, "5 of 8 cases of b have no counterpart in a: 3 of another fit, 2 of another person"))
      << comparison_text(c);
  const std::string json = comparison_json(c);
  EXPECT_NE(json.find("\"cases_b\": 8"), std::string::npos) << json;
  EXPECT_NE(json.find("\"paired_b\": 3"), std::string::npos) << json;
}

TEST_F(Comparison, CountsPeopleWhomOneStudyDoesNotRate) {
  const StudyData a = study("a", kPeople + kFits, [](const std::string&, int) { return 0.5; });
  const StudyData b = study("b", kPeople + kFits, [](const std::string& label, int) {
    return has(label, "person 2, fit 0.1") ? std::nan("") : 0.6;
  });
  const StudyComparison c = compare_studies(a, b);
  EXPECT_EQ(c.differences.at(0).not_rated, 0);
  EXPECT_EQ(c.differences.at(1).pairs, 2);
  EXPECT_EQ(c.differences.at(1).not_rated, 1);
  EXPECT_TRUE(says(c, "2 of 3")) << comparison_text(c);
}

TEST_F(Comparison, OfStudiesWithoutACommonCaseIsRefusedWithTheReason) {
  const ScoreOf same = [](const std::string&, int) { return 0.5; };
  const StudyData a = study("a", kPeople + kFits, same);
  std::string fits = kFits;
  fits.replace(fits.find("0.0, 0.1"), 8, "0.3, 0.4");
  expect_refused(a, study("b", kPeople + fits, same), "6 of another fit");
  expect_refused(a,
                 study("c", "[scenario.postures]\nlist = [\"slouch\"]\n" + kPeople + kFits, same),
                 "6 of another posture or donning");
  expect_refused(a, study("d", kFits, same), "d has no axis of people");
}

const std::string kMoreFits =
    "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1, 0.2]\n";

/// BGM and number of the person in "person 2, fit 0.1".
double fit_of(const std::string& label) { return std::stod(label.substr(label.find("fit ") + 4)); }
int person_of(const std::string& label) {
  return std::stoi(label.substr(label.find("person ") + 7));
}

double pass_mark() { return io::load_scorecard("imu-uncalibrated").pass; }

std::string people_of(int count) {
  std::string text = kPeople;
  return text.replace(text.find("count = 3"), 9, "count = " + std::to_string(count));
}

/// Person p reaches the pass mark at the BGM limit + 0.01 (p − 1).
Comparison::ScoreOf limited(double limit) {
  return [limit](const std::string& label, int) {
    return pass_mark() + limit + 0.01 * (person_of(label) - 1) - fit_of(label);
  };
}

// Without people the cases are of one wearer, each at one fit: to draw them is to draw fits.
TEST_F(Comparison, OfOneWearerHasNoInterval) {
  const auto falling = [](double limit) {
    return [limit](const std::string& label, int) { return pass_mark() + limit - fit_of(label); };
  };
  const StudyData a = study("a", kMoreFits, falling(0.08)),
                  b = study("b", kMoreFits, falling(0.12));
  const StudyComparison c = compare_studies(a, b);
  ASSERT_EQ(c.limits.size(), 1u);
  EXPECT_NEAR(c.limits[0].difference, 0.04, 1e-9);
  EXPECT_TRUE(std::isnan(c.limits[0].interval.low) && std::isnan(c.limits[0].interval.high));
  EXPECT_TRUE(says(c, "limits without draws have no interval")) << comparison_text(c);
  for (const char* phrase : {"drawn jointly", "drawn independently", "nan", "up to 20 people"})
    EXPECT_FALSE(says(c, phrase)) << phrase << "\n" << comparison_text(c);
  const nlohmann::json json = nlohmann::json::parse(comparison_json(c))["limits"].at(0);
  EXPECT_EQ(json["people_drawn"], "none");
  EXPECT_EQ(json["people_a"], 1);
  EXPECT_EQ(json["people_b"], 1);
  EXPECT_EQ(json["interval"], nlohmann::json({nullptr, nullptr}));
  EXPECT_TRUE(json["open_draws"].is_null());
  EXPECT_NE(limits_csv(c).find(",,,false,1,1,none,,"), std::string::npos) << limits_csv(c);
  // Nor has what the study says of itself.
  const HowLoose own = analyse(a).modalities.at(0).how_loose.at("scapula");
  EXPECT_NEAR(own.limit, 0.08, 1e-9);
  EXPECT_TRUE(std::isnan(own.interval.low) && std::isnan(own.interval.high));
  EXPECT_EQ(in_words(own), "up to a BGM of 0.08");
}

TEST_F(Comparison, TellsHowMuchLooserOneStudyMayBe) {
  const StudyData a = study("a", kPeople + kMoreFits, limited(0.08)),
                  b = study("b", kPeople + kMoreFits, limited(0.12));
  const StudyComparison c = compare_studies(a, b);
  ASSERT_EQ(c.limits.size(), 1u);
  const LimitDifference& limits = c.limits[0];
  EXPECT_EQ(limits.modality, "imu-uncalibrated");
  EXPECT_EQ(limits.site, "scapula");
  EXPECT_NEAR(limits.difference, 0.04, 1e-9);
  EXPECT_NEAR(limits.interval.low, 0.04, 1e-9) << "all differ alike, whoever is drawn";
  EXPECT_NEAR(limits.interval.high, 0.04, 1e-9);
  // What each study says of itself.
  const auto own = [](const StudyData& data) {
    return analyse(data).modalities.at(0).how_loose.at("scapula").limit;
  };
  EXPECT_EQ(limits.limit_a.low, own(a));
  EXPECT_EQ(limits.limit_b.low, own(b));
  EXPECT_NEAR(limits.limit_a.low, 0.08, 1e-9);
  EXPECT_TRUE(says(c, "people are drawn jointly")) << comparison_text(c);
  EXPECT_TRUE(says(c, "+0.040  +0.040 to +0.040")) << comparison_text(c);
  EXPECT_TRUE(says(c, "0.080          0.120 ")) << comparison_text(c);
  const nlohmann::json json = nlohmann::json::parse(comparison_json(c))["limits"].at(0);
  EXPECT_EQ(json["people_drawn"], "jointly");
  EXPECT_NEAR(json["difference_bgm"].get<double>(), 0.04, 1e-9);
  EXPECT_NEAR(json["limit_b_bgm"].get<double>(), 0.12, 1e-9);
  EXPECT_EQ(json["differs"], false) << "three people";
  EXPECT_NE(limits_csv(c).find(",false,3,3,jointly,0,"), std::string::npos) << limits_csv(c);
}

/// The row of the table of limits.
std::string limits_row(const StudyComparison& comparison) {
  const std::string text = comparison_text(comparison);
  const std::size_t row = text.find("scapula", text.find("how loose may it be?"));
  return text.substr(row, text.find('\n', row) - row);
}

TEST_F(Comparison, MarksNoLimitOfFewPeople) {
  const auto of = [&](int people) {
    const std::string n = std::to_string(people);
    return compare_studies(study("a" + n, people_of(people) + kMoreFits, limited(0.0)),
                           study("b" + n, people_of(people) + kMoreFits, limited(0.15)));
  };
  const std::string scores = "of 20 such rows without any difference 2 would be so",
                    few =
                        "with up to 20 people about one row in four would differ without any "
                        "difference (half with 3), so none is marked";
  const StudyComparison twelve = of(12), many = of(21);
  EXPECT_GT(twelve.limits.at(0).interval.low, 0.03) << "far from zero";
  EXPECT_EQ(limits_row(twelve).find('*'), std::string::npos) << limits_row(twelve);
  EXPECT_TRUE(says(twelve, few)) << comparison_text(twelve);
  EXPECT_NE(comparison_json(twelve).find(few), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(comparison_json(twelve))["limits"].at(0)["differs"], false);
  EXPECT_TRUE(limits_row(many).ends_with(" *")) << limits_row(many);
  EXPECT_FALSE(says(many, few)) << comparison_text(many);
  EXPECT_NE(limits_csv(many).find(",true,21,21,jointly,"), std::string::npos) << limits_csv(many);
  // What is said of rows of scores stands under these.
  for (const StudyComparison& c : {twelve, many}) {
    const std::string text = comparison_text(c);
    EXPECT_LT(text.find(scores), text.find("how loose may it be?")) << text;
    EXPECT_EQ(text.find(scores), text.rfind(scores)) << text;
  }
}

TEST_F(Comparison, OfLimitsDrawsOtherPeopleIndependently) {
  const StudyComparison c = compare_studies(study("a", kPeople + kMoreFits, limited(0.08)),
                                            study("b", people_of(4) + kMoreFits, limited(0.12)));
  ASSERT_EQ(c.limits.size(), 1u);
  EXPECT_EQ(c.limits[0].drawn, PeopleDrawn::independently);
  EXPECT_EQ(c.limits[0].people_b, 4);
  EXPECT_NEAR(c.limits[0].difference, 0.04, 1e-9);
  // The worst of A is not drawn in 8 of 27 draws: its limit is then at least 0.01 higher.
  EXPECT_LT(c.limits[0].interval.low, 0.031);
  EXPECT_TRUE(says(c, "people are drawn independently")) << comparison_text(c);
  EXPECT_TRUE(says(c, "limits are of all cases of each study")) << comparison_text(c);
  EXPECT_NE(comparison_json(c).find("\"people_drawn\": \"independently\""), std::string::npos);
}

// By name, whatever the order of a file is; as many others are not the same.
TEST_F(Comparison, OfLimitsKnowsPeopleByTheirNames) {
  const std::map<std::string, double> heights = {
      {"ann", 1.61}, {"bob", 1.72}, {"cy", 1.83}, {"dan", 1.84}};
  const auto listed = [&](const std::string& name, const std::vector<std::string>& people,
                          double limit) {
    fs::create_directories(base);
    std::string csv = "name,height\n";
    for (const std::string& one : people) csv += fmt::format("{},{}\n", one, heights.at(one));
    const std::string file = (base / (name + ".csv")).string();
    io::write_text_file(file, csv);
    const std::string axis = "[[axis]]\nname = \"person\"\npeople = { file = \"" + file + "\" }\n";
    return study(name, axis + kMoreFits, [&, limit](const std::string& label, int) {
      const double own = 0.2 * (heights.at(label.substr(0, label.find(','))) - 1.61);
      return pass_mark() + limit + own - fit_of(label);
    });
  };
  const StudyData a = listed("a", {"ann", "bob", "cy"}, 0.08);
  const LimitDifference same =
      compare_studies(a, listed("b", {"cy", "ann", "bob"}, 0.12)).limits.at(0);
  EXPECT_EQ(same.drawn, PeopleDrawn::jointly);
  EXPECT_NEAR(same.interval.low, 0.04, 1e-9);
  EXPECT_NEAR(same.interval.high, 0.04, 1e-9);
  const LimitDifference other =
      compare_studies(a, listed("c", {"ann", "bob", "dan"}, 0.12)).limits.at(0);
  EXPECT_EQ(other.drawn, PeopleDrawn::independently);
  EXPECT_LT(other.interval.low, 0.03);
}

TEST_F(Comparison, InventsNoLimit) {
  const StudyData nowhere = study("a", kPeople + kMoreFits, limited(-0.2)),
                  beyond = study("b", kPeople + kMoreFits, limited(0.25));
  const StudyComparison c = compare_studies(nowhere, beyond);
  const nlohmann::json json = nlohmann::json::parse(comparison_json(c))["limits"].at(0);
  EXPECT_EQ(json["limit_a_bgm"], "nowhere");
  EXPECT_EQ(json["limit_b_bgm"], "beyond the loosest");
  EXPECT_TRUE(json["difference_bgm"].is_null());
  EXPECT_NEAR(json["interval"][0].get<double>(), 0.2, 1e-9) << "from the tightest to the loosest";
  EXPECT_TRUE(json["interval"][1].is_null());
  EXPECT_EQ(json["open_draws"], 1);
  EXPECT_EQ(json["differs"], false);
  EXPECT_NE(json["words"].get<std::string>().find("B still passes at 0.200, the loosest tried"),
            std::string::npos)
      << json;
  for (const char* phrase : {"nowhere", "beyond 0.200", "at least +0.200", "+0.200 to open"})
    EXPECT_NE(limits_row(c).find(phrase), std::string::npos) << phrase << ": " << limits_row(c);
  EXPECT_FALSE(says(c, "inf") || says(c, "nan")) << comparison_text(c);
  EXPECT_NE(limits_csv(c).find("imu-uncalibrated,scapula,nowhere,beyond the loosest,,0.2,inf,false,"
                               "3,3,jointly,1,"),
            std::string::npos)
      << limits_csv(c);
  // What is open on both sides is not what is not known.
  EXPECT_NE(limits_csv(compare_studies(beyond, beyond)).find(",,-inf,inf,false,3,3,jointly,1,"),
            std::string::npos);
}

// Nobody is rated at the loosest fit of B: its limit is at least the fit before.
TEST_F(Comparison, TellsALimitThatEndsWhereNobodyIsRated) {
  const StudyData a = study("a", kPeople + kMoreFits, limited(0.05)),
                  b = study("b", kPeople + kMoreFits, [](const std::string&label, int donning) {
                    return has(label, "fit 0.2") ? std::nan("") : limited(0.12)(label, donning);
                  });
  const StudyComparison c = compare_studies(a, b);
  for (const char* phrase : {"0.050", "at least 0.100", "at least +0.050", "+0.040 to open"})
    EXPECT_NE(limits_row(c).find(phrase), std::string::npos) << phrase << ": " << limits_row(c);
  const nlohmann::json json = nlohmann::json::parse(comparison_json(c))["limits"].at(0);
  EXPECT_EQ(json["limit_b_bgm"], "at least 0.100");
  EXPECT_TRUE(json["difference_bgm"].is_null());
  EXPECT_NE(limits_csv(c).find(",at least 0.100,,"), std::string::npos) << limits_csv(c);
  const StudyAnalysis own = analyse(b);
  const std::string words = "at least up to a BGM of 0.10, beyond which nobody is rated";
  EXPECT_NE(in_words(own.modalities.at(0).how_loose.at("scapula")).find(words), std::string::npos);
  EXPECT_NE(analysis_json(own).find("\"limit_bgm\": \"at least 0.100\""), std::string::npos);
}

TEST_F(Comparison, OfStudiesWithoutLoosenessHasNoLimits) {
  const ScoreOf same = [](const std::string&, int) { return 0.5; };
  const StudyData a = study("a", kPeople, same);
  const StudyComparison c = compare_studies(a, study("b", kPeople, same));
  EXPECT_TRUE(c.limits.empty());
  EXPECT_FALSE(says(c, "how loose")) << comparison_text(c);
  EXPECT_EQ(nlohmann::json::parse(comparison_json(c))["limits"], nlohmann::json::array());
}

TEST_F(Comparison, TellsOfAnotherScorecardOrProgram) {
  const ScoreOf same = [](const std::string&, int) { return 0.5; };
  const StudyData a = study("a", kPeople, same);
  StudyData b = study("b", kPeople, same);
  const char *const card = "imu-uncalibrated: its scorecard is not the same",
                    *const program = "differences may be those of the programs";
  EXPECT_FALSE(says(compare_studies(a, b), card) || says(compare_studies(a, b), program));
  b.plan.cards.at(0) += "# stricter\n";
  EXPECT_TRUE(says(compare_studies(a, b), card));
  b.plan.version = "0.0.1";
  EXPECT_TRUE(says(compare_studies(a, b), program));
}

// An axis of one study alone is no reason not to compare, but is told.
TEST_F(Comparison, TellsOfAxesThatOneStudyHasAlone) {
  const ScoreOf by_cloth = [](const std::string& label, int) {
    return has(label, "denim") ? 0.3 : 0.7;
  };
  const StudyData a = study("a", kPeople + kFits, by_cloth);
  const StudyData b = study(
      "b",
      kPeople + kFits + "[[axis]]\nname = \"cloth\"\nfabrics = [\"denim\", \"cotton-shirting\"]\n",
      by_cloth);
  const StudyComparison c = compare_studies(a, b);
  EXPECT_NEAR(c.differences.at(0).mean, -0.4, 1e-12);
  EXPECT_EQ(c.paired_b, 12);
  EXPECT_TRUE(says(c, "the axis cloth is in b alone: the worst of its 2 levels counts"))
      << comparison_text(c);
}

}  // namespace
}  // namespace loosefit::study
