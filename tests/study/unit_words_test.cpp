#include "loosefit/study/unit_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "loosefit/study/study_page.h"
#include "support/study_on_disk.h"

// What a study says in words: of whom, of how many, and nothing that its scores do not bear.
namespace loosefit::study {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const std::string kHeadOfStudy = "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n";
const std::string kPlaces =
    "[[axis]]\nname = \"cloth\"\nfabrics = [\"denim\", \"cotton-shirting\"]\n";
const std::string kOnlyFits =
    "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1]\n";

std::string drawn(int count) {
  return "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = " +
         std::to_string(count) + " }\n";
}

struct Sentences : StudyOnDisk {
  /// A study whose n-th case scores `scores[n]`; NaN: not rated, though the case is done.
  StudyAnalysis of(const std::string& axes, const std::vector<double>& scores,
                   const std::vector<std::string>& untold = {}) const {
    fs::create_directories(base);
    const Plan made = make_plan(parse_study_file(kHeadOfStudy + axes, (base / "x.toml").string()));
    const StudyFolder folder(base / "of");
    fs::remove_all(folder.path());
    folder.write_plan(made);
    EXPECT_EQ(made.cases.size(), scores.size());
    for (std::size_t c = 0; c < made.cases.size(); ++c) {
      CaseRecord record = made_up(made.cases[c].address, scores.at(c));
      if (std::isnan(scores[c])) record.samples[0].score = kNaN;
      if (!untold.empty()) record.untold["imu-uncalibrated"] = untold;
      write_whole(folder.result_file(record.address), record_json(record));
    }
    EXPECT_EQ(folder.state(folder.read_plan()).scored, read_study_data(folder).scored);
    return analyse(read_study_data(folder));
  }
  static std::string first(const StudyAnalysis& analysis) { return headlines(analysis).at(0); }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST(UnitWords, CountOneAndMany) {
  EXPECT_EQ(counted(1, "case", "cases"), "1 case");
  EXPECT_EQ(counted(1, UnitKind::people), "1 person");
  EXPECT_EQ(counted(0, UnitKind::people), "0 people");
  EXPECT_EQ(counted(2, UnitKind::listed_people), "2 listed people");
  EXPECT_EQ(counted(1, UnitKind::wearers_cases), "1 case of one wearer");
  EXPECT_EQ(rated_of_all(1, 3, UnitKind::people), "the 1 rated of 3 people");
  EXPECT_EQ(rated_of_all(3, 3, UnitKind::people), "3 people");
  EXPECT_EQ(rated_of_all(2, 2, UnitKind::listed_people), "the 2 people listed");
  EXPECT_EQ(for_most(40, UnitKind::listed_people), "for 95 % of the 40 people listed");
  EXPECT_EQ(for_most(20, UnitKind::listed_people), "for all 20 people listed");
  EXPECT_EQ(for_most(1, UnitKind::cases), "in the 1 case");
}

TEST_F(Sentences, OfPeopleWhoWereDrawn) {
  const StudyAnalysis few = of(drawn(4), {0.95, 0.96, 0.97, 0.98});
  EXPECT_EQ(first(few),
            "imu-uncalibrated: scapula ranks first; 100 % of 4 people pass there, the lowest score "
            "is 0.95");
  std::vector<double> scores(21, 0.97);
  scores[3] = 0.91;  // the second least is the 5th percentile of 21
  scores[4] = 0.92;
  EXPECT_TRUE(
      has(first(of(drawn(21), scores)), "of 21 people pass there, 95 % score 0.92 or more"));
  const nlohmann::json json = nlohmann::json::parse(analysis_json(few));
  EXPECT_EQ(json["people"], 4);
  EXPECT_EQ(json["units"], "people");
}

TEST_F(Sentences, OfCasesOfOneWearerSayNothingOfPeople) {
  const StudyAnalysis analysis = of(kPlaces, {0.96, 0.97});
  EXPECT_EQ(first(analysis),
            "imu-uncalibrated: scapula ranks first; 100 % of 2 cases of one wearer pass there, the "
            "lowest score is 0.96");
  const std::string page = study_html(analysis);
  EXPECT_TRUE(has(page, "2 cases of one wearer, 2 drapes; 2 cases have scores."));
  for (const char* word : {"% of people", "over people", "Scores of people", ">people<"})
    EXPECT_FALSE(has(page, word)) << word;
  const nlohmann::json json = nlohmann::json::parse(analysis_json(analysis));
  EXPECT_TRUE(json["people"].is_null());
  EXPECT_EQ(json["units"], "cases of one wearer");
  EXPECT_EQ(json["unit_count"], 2);
}

TEST_F(Sentences, OfFitsOfOneWearerSayNothingOfPeople) {
  const StudyAnalysis analysis = of(kOnlyFits, {0.1, 0.2});
  for (const std::string& sentence : headlines(analysis))
    EXPECT_FALSE(has(sentence, "people")) << sentence;
  EXPECT_EQ(headlines(analysis).back(),
            "comfort: in all 2 cases of one wearer comfortable at all fits tried");
  EXPECT_FALSE(has(study_html(analysis), "% of people"));
  // Each case has one fit, at which it alone could be rated.
  EXPECT_EQ(analysis.modalities[0].rankings[0][0].people, 1);
  EXPECT_EQ(analysis.modalities[0].metrics[0][0].people, 1);
  EXPECT_EQ(analysis.modalities[0].rankings[2][0].people, 2);
  EXPECT_TRUE(has(first(of(kOnlyFits + kPlaces, {0.1, 0.95, 0.2, 0.1})),
                  "no site works in all cases of any fit tried; nearest is scapula: 50 % of 2 "
                  "cases of one wearer pass at a BGM of 0.00"));
}

TEST_F(Sentences, OfPeopleFromAFileAreOfThoseAlone) {
  fs::create_directories(base);
  io::write_text_file((base / "people.csv").string(),
                      "name,sex,height,chest\nA,female,1.65,0.9\nB,male,1.8,1.0\n");
  const std::string listed = "[[axis]]\nname = \"person\"\npeople = { file = \"people.csv\" }\n";
  const StudyAnalysis analysis = of(listed, {0.95, 0.1});
  EXPECT_EQ(first(analysis),
            "imu-uncalibrated: scapula ranks first; 50 % of the 2 people listed pass there, the "
            "lowest score is 0.10");
  EXPECT_EQ(nlohmann::json::parse(analysis_json(analysis))["units"], "listed people");
  const StudyAnalysis fits = of(listed + kOnlyFits, {0.95, 0.1, 0.1, 0.1});
  EXPECT_TRUE(has(first(fits), "no site works for all 2 people listed at any fit tried"))
      << first(fits);
  EXPECT_FALSE(has(study_html(fits), "95 % of people"));
}

TEST_F(Sentences, NameNoWinnerWhereNobodyPasses) {
  EXPECT_EQ(first(of(drawn(3), {kNaN, -0.2195, kNaN})),
            "imu-uncalibrated: no site works: nobody of the 1 rated of 3 passes anywhere");
  EXPECT_EQ(first(of(drawn(2) + kOnlyFits, {kNaN, kNaN, 0.1, -1})),
            "imu-uncalibrated: no site works: nobody of the 1 rated of 2 passes anywhere");
  EXPECT_EQ(first(of(kPlaces, {0.1, 0.2})),
            "imu-uncalibrated: no site works: none of the 2 cases of one wearer passes anywhere");
  // Who passes in one cloth and fails in another passes nowhere in both.
  EXPECT_TRUE(has(first(of(drawn(1) + kPlaces, {0.95, 0.1})),
                  "nobody of the 1 passes anywhere in all that they went through"));
}

TEST_F(Sentences, SayWhereMostPassWhereNobodyDoesAtTheFirstSite) {
  const StudyAnalysis analysis = [&] {
    StudyAnalysis made = of(drawn(3), {0.5, 0.5, 0.5});
    StudyData data = made.data;
    SiteTable second = data.sites.at("imu-uncalibrated").front();
    second.site = "sternum";
    second.by_case = {0.95, 0.1, 0.1};
    data.sites["imu-uncalibrated"].push_back(second);
    return analyse(std::move(data));
  }();
  EXPECT_EQ(first(analysis),
            "imu-uncalibrated: scapula ranks first; 0 % of 3 people pass there, the lowest score "
            "is 0.50; most pass at sternum: 33 % of 3 people");
}

TEST_F(Sentences, CutNoNegativeScoreToAPositiveOne) {
  const std::string sentence = first(of(drawn(3), {0.95, -0.2195, kNaN}));
  EXPECT_TRUE(has(sentence, "50 % of the 2 rated of 3 people pass there")) << sentence;
  EXPECT_TRUE(has(sentence, "the lowest score is 0 (-0.22 before it is cut off)")) << sentence;
  std::vector<double> scores(21, 0.95);
  scores[0] = scores[1] = -0.5;
  EXPECT_TRUE(
      has(first(of(drawn(21), scores)), "5 % or more score 0 (-0.50 before it is cut off)"));
}

TEST_F(Sentences, CountCasesThatHaveAScoreAndNotThoseThatAreDone) {
  const StudyAnalysis analysis = of(drawn(2), {kNaN, 0.95});
  EXPECT_EQ(analysis.data.done, 2);
  EXPECT_EQ(analysis.data.scored, 1);
  ASSERT_EQ(analysis.data.troubles.size(), 1u);
  EXPECT_EQ(analysis.data.troubles[0].status, "no scores");
  const std::string page = study_html(analysis);
  EXPECT_TRUE(has(page, "1 case has scores."));
  EXPECT_TRUE(has(page, "1 of 2 cases has no scores: listed below"));
  EXPECT_EQ(nlohmann::json::parse(analysis_json(analysis))["scored"], 1);
}

TEST_F(Sentences, TellWhatIsLackingWhereNothingIsRated) {
  // As a case leaves it that can tell nothing of a scorecard: its only criterion needs postures.
  fs::create_directories(base);
  const std::string inclination = "[study]\nname = \"x\"\nmodalities = [\"imu-inclination\"]\n";
  const Plan made = make_plan(parse_study_file(inclination + drawn(2), (base / "x.toml").string()));
  const StudyFolder folder(base / "untold");
  folder.write_plan(made);
  for (const PlannedCase& one : made.cases) {
    CaseRecord record = made_up(one.address, 0);
    record.samples.clear();
    record.sites.front().modality = "imu-inclination";
    record.untold["imu-inclination"] = {"coe_rms_deg"};
    write_whole(folder.result_file(record.address), record_json(record));
  }
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_EQ(analysis.data.scored, 0);
  EXPECT_EQ(first(analysis), "imu-inclination: needs several postures: nothing is rated");
  EXPECT_TRUE(has(analysis.data.troubles.at(0).reason, "imu-inclination lacks "))
      << analysis.data.troubles.at(0).reason;
  EXPECT_TRUE(has(analysis.data.troubles.at(0).reason, "postures"));
  const std::string page = study_html(analysis);
  EXPECT_TRUE(has(page, "needs several postures: nothing is rated"));
  EXPECT_FALSE(has(page, "upper bounds"));
  EXPECT_FALSE(has(page, "coe_rms_deg"));
  EXPECT_FALSE(has(page, "100 %"));
  EXPECT_EQ(first(of(drawn(2), {kNaN, kNaN})), "imu-uncalibrated: no site could be rated");
  // What is lacking is another criterion: postures would not help.
  EXPECT_EQ(first(of(drawn(2), {kNaN, kNaN}, {"coe_rms_deg"})),
            "imu-uncalibrated: no site could be rated");
  EXPECT_TRUE(has(study_html(of(drawn(2), {0.95, 0.95}, {"coe_rms_deg"})), "upper bounds"));
}

TEST_F(Sentences, GiveNoIntervalToCasesOfChosenValues) {
  const StudyAnalysis chosen = of(kPlaces, {0.9, 0.4}), of_people = of(drawn(2), {0.9, 0.4});
  const auto interval = [](const StudyAnalysis& analysis) {
    return analysis.modalities.at(0).rankings.back().at(0).median_interval;
  };
  EXPECT_TRUE(std::isnan(interval(chosen).low) && std::isnan(interval(chosen).high));
  EXPECT_TRUE(std::isnan(chosen.modalities.at(0).rankings.back().at(0).first));
  EXPECT_EQ(interval(of_people).low, 0.4);
  EXPECT_EQ(interval(of_people).high, 0.9);
  EXPECT_TRUE(has(study_html(chosen), "are no sample"));
  EXPECT_FALSE(has(study_html(of_people), "are no sample"));
  // Draws of fabrics tell as much of sensors as draws of people.
  const std::string fabrics =
      "[[axis]]\nname = \"cloth\"\nfabrics = { population = \"618-measured\", count = 2 }\n";
  EXPECT_EQ(interval(of(fabrics, {0.9, 0.4})).low, 0.4);
  EXPECT_TRUE(has(study_html(of(fabrics, {0.9, 0.4})), "of rankings at one fit alone"));
  // So do histories of putting on.
  const std::string histories =
      "[scenario.donning]\nfirst = \"drawn\"\n[[axis]]\nname = \"put on\"\ndonnings = 2\n";
  EXPECT_EQ(interval(of(histories, {0.9, 0.4})).low, 0.4);
}

TEST_F(Sentences, TellWhatSomeCasesCannotTell) {
  of(drawn(2), {0.95, 0.95});
  const StudyFolder folder(base / "of");
  CaseRecord record = *folder.record(folder.read_plan().cases.front().address);
  record.untold["imu-uncalibrated"] = {"coe_rms_deg"};
  write_whole(folder.result_file(record.address), record_json(record));
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_TRUE(analysis.modalities[0].untold.empty());
  EXPECT_EQ(analysis.modalities[0].untold_in_part, std::vector<std::string>{"coe_rms_deg"});
  EXPECT_TRUE(has(study_html(analysis), "Not told by some cases"));
}

TEST_F(Sentences, OfComfortForAllCountTheWorst) {
  // 20 people, of whom one is pressed.
  of(drawn(20) + kOnlyFits, std::vector<double>(40, 0.95));
  const StudyFolder folder(base / "of");
  for (const FolderCase& one : folder.read_plan().cases)
    if (one.levels[0] == 7) {
      CaseRecord record = *folder.record(one.address);
      record.garment["uncomfortable_share"] = 0.5;
      write_whole(folder.result_file(record.address), record_json(record));
    }
  EXPECT_EQ(headlines(analyse(read_study_data(folder))).back(),
            "comfort: for 95 % of people not comfortable at any fit tried");
}

TEST_F(Sentences, ShowNoCorrelationOfFewPeople) {
  const auto falling = [](int people) {
    std::vector<double> scores;
    for (int c = 0; c < 2 * people; ++c) scores.push_back(0.95 - 0.3 * (c % 2) - 0.001 * c);
    return scores;
  };
  const std::string why = "Correlations of fewer than 8 people are not shown";
  const StudyAnalysis few = of(drawn(7) + kOnlyFits, falling(7));
  EXPECT_TRUE(has(study_html(few), why));
  EXPECT_EQ(few.modalities[0].sensitivity.at(0).units, 7);
  EXPECT_FALSE(has(study_html(of(drawn(8) + kOnlyFits, falling(8))), why));
  // Nor an interval in the headline; of some more it is told how few they are.
  EXPECT_FALSE(has(first(few), "interval")) << first(few);
  const StudyAnalysis eight = of(drawn(8) + kOnlyFits, falling(8));
  EXPECT_TRUE(has(first(eight), " of 8 people only")) << first(eight);
}

TEST_F(Sentences, NameMetricsInWords) {
  const StudyAnalysis analysis = of(drawn(2) + kOnlyFits, {0.95, 0.1, 0.95, 0.1});
  const std::string page = study_html(analysis);
  EXPECT_TRUE(has(page, "total rotation of the sensor against the body"));
  EXPECT_FALSE(has(page, "rotation_deg"));
}

}  // namespace
}  // namespace loosefit::study
