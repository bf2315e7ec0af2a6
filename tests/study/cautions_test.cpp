#include "loosefit/study/cautions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "loosefit/study/study_page.h"
#include "support/study_on_disk.h"

// Warnings of many cases in few lines, none of them lost.
namespace loosefit::study {
namespace {

StudyData warned(const std::vector<std::vector<std::string>>& warnings) {
  StudyData data;
  data.warnings = warnings;
  data.plan.cases.resize(warnings.size());
  for (std::size_t c = 0; c < warnings.size(); ++c)
    data.plan.cases[c].number = static_cast<int>(c) + 1;
  data.ran = static_cast<int>(warnings.size());
  return data;
}

TEST(Cautions, FiguresAreWhatWarningsDifferIn) {
  EXPECT_EQ(without_figures("waist: local change +0.31 is beyond ±0.3; look"),
            "waist: local change # is beyond ±#; look");
  EXPECT_EQ(without_figures("-1.5e-03 kPa, 12.5 % of C7. 3."), "# kPa, # % of C7. #.");
  EXPECT_EQ(without_figures("a_2 to-3"), "a_2 to-#");
}

TEST(Cautions, MetricsHaveTheirWords) {
  EXPECT_EQ(metrics_in_words("rotation_deg: 3"),
            "total rotation of the sensor against the body: 3");
  EXPECT_EQ(metrics_in_words("no_metric, strain"), "no_metric, strain");
}

TEST(Cautions, AreGroupedAndTheCommonestComesFirst) {
  const StudyData data = warned({
      {"presses with 353 kPa"},
      {"strained beyond the range in which the constants of denim hold: warp on 3 % of the cloth",
       "strained beyond the range in which the constants of denim hold: weft on 9 % of the cloth"},
      {},
      {"strained beyond the range in which the constants of silk hold: shear on 5 % of the cloth"},
  });
  const std::vector<Caution> cautions = group_warnings(data);
  ASSERT_EQ(cautions.size(), 2u);
  EXPECT_EQ(cautions[0].cases, 2) << "a case counts once";
  EXPECT_EQ(cautions[0].number, 2);
  EXPECT_NE(cautions[0].example.find("denim hold: warp on 3 %"), std::string::npos);
  EXPECT_EQ(cautions[1].cases, 1);
  EXPECT_EQ(warned_cases(data), 3);
  EXPECT_EQ(cautions_in_words(data), "3 of 4 cases carry warnings: see Cautions on the page");
  EXPECT_EQ(cautions_in_words(warned({{"a"}})),
            "1 of 1 case carries warnings: see Cautions on the page");
  EXPECT_EQ(cautions_in_words(warned({{}, {}})), "");
  EXPECT_EQ(cautions_html(warned({{}})), "");
}

TEST(Cautions, MoreThanADozenAreFoldedAway) {
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < kOpenCautions; ++i) kinds.push_back(std::string(i + 1, 'a'));
  EXPECT_EQ(cautions_html(warned({kinds})).find("<details>"), std::string::npos);
  kinds.push_back("the <last> kind");
  const std::string html = cautions_html(warned({kinds}));
  const std::size_t fold = html.find("<details>");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_NE(html.find("1 more"), std::string::npos);
  EXPECT_GT(html.find("the &lt;last&gt; kind"), fold);
  EXPECT_LT(html.find(std::string(kOpenCautions, 'a')), fold);
}

TEST_F(StudyOnDisk, CautionsStandInPageReportAndHeadlines) {
  const StudyFolder folder = finished("a");
  CaseRecord record = made_up(plan.cases[5].address, score(plan.cases[5]));
  record.warnings = {"the waistband lies 0.13 m above the waist"};
  write_whole(folder.result_file(record.address), record_json(record));
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_EQ(headlines(analysis).back(), "1 of 12 cases carries warnings: see Cautions on the page");
  const std::string page = study_html(analysis);
  const std::size_t at = page.find("<h2>Cautions</h2>");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(at, page.find("<h3>How loose may it be?</h3>"));
  EXPECT_NE(page.find("the waistband lies 0.13 m above the waist"), std::string::npos);
  EXPECT_NE(page.find("in 1 of 12 cases"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(analysis_json(analysis));
  EXPECT_EQ(json["warned"], 1);
  EXPECT_EQ(json["cautions"].at(0)["number"], 6);
  EXPECT_EQ(json["cautions"].at(0)["cases"], 1);
  EXPECT_EQ(study_html(analyse(read_study_data(finished("b")))).find("Cautions"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::study
