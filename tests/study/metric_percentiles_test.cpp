#include "loosefit/study/metric_percentiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/quantile.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "loosefit/study/draws.h"
#include "loosefit/study/study_page.h"
#include "support/study_on_disk.h"

// What the sensors of a population meet: order statistics of the case that serves each person
// worst, with intervals whose ends have closed forms.
namespace loosefit::study {
namespace {

using placement::Scorecard;

Scorecard card_of(const std::string& metric, double good, double fail) {
  Scorecard card;
  placement::Criterion& criterion = card.criteria.emplace_back();
  criterion.metric = metric;
  criterion.limit = {good, fail};
  return card;
}

/// People with one case at each level, and one site; `values` by level and person.
struct MadeUp {
  StudyData data;
  std::vector<SiteTable> sites;

  MadeUp(const std::string& metric, const std::vector<std::vector<double>>& values) {
    for (std::size_t p = 0; p < values.front().size(); ++p)
      data.units.push_back("person " + std::to_string(p + 1));
    SiteTable& site = sites.emplace_back();
    site.site = "scapula";
    for (std::size_t level = 0; level < values.size(); ++level) {
      data.level_bgm.push_back(0.1 * static_cast<double>(level));
      data.level_labels.push_back(std::to_string(level));
      for (std::size_t p = 0; p < values[level].size(); ++p) {
        data.unit_of_case.push_back(static_cast<int>(p));
        data.level_of_case.push_back(static_cast<int>(level));
        site.by_case.push_back(kNotKnown);
        site.metrics[metric].push_back(values[level][p]);
      }
    }
  }
};

TEST(MetricPercentiles, AreOrderStatisticsOfPeople) {
  std::vector<double> degrees;
  for (int p = 0; p <= 100; ++p) degrees.push_back(37 * p % 101);  // 0 … 100, each once
  const MadeUp hundred("rotation_deg", {degrees});
  const auto levels =
      metric_percentiles(hundred.data, hundred.sites, card_of("rotation_deg", 2, 15));
  ASSERT_EQ(levels.size(), 1u) << "one level alone is all of them";
  ASSERT_EQ(levels[0].size(), 1u);
  const MetricPercentiles& row = levels[0][0];
  EXPECT_EQ(row.site, "scapula");
  EXPECT_EQ(row.metric, "rotation_deg");
  EXPECT_EQ(row.known, 101);
  EXPECT_EQ(row.median, 50);
  EXPECT_EQ(row.p5, 5);    // ⌈5.05⌉-th
  EXPECT_EQ(row.p95, 95);  // ⌈95.95⌉-th
  const MadeUp four("rotation_deg", {{4, 1, 8, 2}});
  EXPECT_EQ(metric_percentiles(four.data, four.sites, card_of("rotation_deg", 2, 15))[0][0].median,
            3);
}

// Of nine people drawn nine times, P(greatest ≤ k-th) = (k/9)^9: 0.026 for k = 6 and 0.104 for 7.
// P(median ≤ k-th) = P(Bin(9, k/9) ≥ 5): 0.030 for k = 2 and 0.145 for 3. So the ends of 90 % are
// known people, and those of the other side by symmetry.
TEST(MetricPercentiles, IntervalsEndAtThePeopleThatTheBinomialSays) {
  const MadeUp nine("rotation_deg", {{1, 4, 9, 16, 25, 36, 49, 64, 81}});
  const MetricPercentiles row =
      metric_percentiles(nine.data, nine.sites, card_of("rotation_deg", 2, 15))[0][0];
  EXPECT_EQ(row.median, 25);
  EXPECT_EQ(row.median_interval.low, 9);
  EXPECT_EQ(row.median_interval.high, 49);
  EXPECT_EQ(row.p5_interval.low, 1);
  EXPECT_EQ(row.p5_interval.high, 9);
  EXPECT_EQ(row.p95_interval.low, 49);
  EXPECT_EQ(row.p95_interval.high, 81);
}

// The slow twin sorts each draw anew.
TEST(MetricPercentiles, IntervalsAreThoseOfTheBootstrapOfScores) {
  Draws draws(3);
  std::vector<double> values;
  for (int p = 0; p < 43; ++p) values.push_back(p % 7 == 2 ? kNotKnown : draws.normal());
  const MadeUp made("tilt_sagittal_deg", {values});
  const BootstrapOptions options{.seed = 9, .resamples = 500, .confidence = 0.8};
  const MetricPercentiles row =
      metric_percentiles(made.data, made.sites, card_of("tilt_sagittal_deg", 2, 15), options)[0][0];
  const auto twin = [&](auto statistic) {
    return bootstrap(
        43,
        [&](const std::vector<int>& draw) {
          std::vector<double> drawn;
          for (const int p : draw)
            if (!std::isnan(values[p])) drawn.push_back(values[p]);
          return statistic(drawn);
        },
        options);
  };
  const Bounds middle = twin([](const std::vector<double>& v) { return median(v); });
  const Bounds low = twin([](const std::vector<double>& v) { return quantile(v, 0.05); });
  const Bounds high = twin([](const std::vector<double>& v) { return quantile(v, 0.95); });
  EXPECT_EQ(row.median_interval.low, middle.low);
  EXPECT_EQ(row.median_interval.high, middle.high);
  EXPECT_EQ(row.p5_interval.low, low.low);
  EXPECT_EQ(row.p5_interval.high, low.high);
  EXPECT_EQ(row.p95_interval.low, high.low);
  EXPECT_EQ(row.p95_interval.high, high.high);
}

TEST(MetricPercentiles, CountTheFitThatServesEachPersonWorst) {
  const std::vector<std::vector<double>> by_fit = {{1, 8, 5}, {4, 2, 7}};
  const auto medians = [&](const Scorecard& card) {
    const MadeUp made(card.criteria[0].metric, by_fit);
    std::vector<double> found;
    for (const auto& rows : metric_percentiles(made.data, made.sites, card))
      found.push_back(rows.at(0).median);
    return found;
  };
  // Less is better: 4, 8, 7 are the worst of the two fits.
  EXPECT_EQ(medians(card_of("slip_mm", 2, 6)), (std::vector<double>{5, 4, 7}));
  // More is better: 1, 2, 5.
  EXPECT_EQ(medians(card_of("pressure_min_kPa", 6, 2)), (std::vector<double>{5, 4, 2}));
  // Good between 4 and 6: of person 2 the 2 is as far out as the 8, and the first counts: 1, 8, 7.
  Scorecard between = card_of("pressure_kPa", 4, 0);
  between.criteria[0].upper = placement::Ramp{6, 10};
  EXPECT_EQ(medians(between), (std::vector<double>{5, 4, 7}));
  // The same as two criteria of one metric is one row.
  Scorecard two = card_of("pressure_kPa", 4, 0);
  two.criteria.push_back(card_of("pressure_kPa", 6, 10).criteria[0]);
  EXPECT_EQ(medians(two), medians(between));
  const MadeUp made("pressure_kPa", by_fit);
  EXPECT_EQ(metric_percentiles(made.data, made.sites, two)[0].size(), 1u);
}

TEST(MetricPercentiles, LeaveOutWhatIsNotKnownAndCountIt) {
  const MadeUp made("slip_mm", {{1, kNotKnown, kNotKnown, 5}, {3, kNotKnown, 4, 2}});
  const auto levels = metric_percentiles(made.data, made.sites, card_of("slip_mm", 2, 6));
  ASSERT_EQ(levels.size(), 3u);
  const auto expect = [&](std::size_t level, int known, int known_cases, int cases, double middle) {
    SCOPED_TRACE(level);
    const MetricPercentiles& row = levels[level].at(0);
    EXPECT_EQ(row.people, 4);
    EXPECT_EQ(row.known, known);
    EXPECT_EQ(row.known_cases, known_cases);
    EXPECT_EQ(row.cases, cases);
    EXPECT_EQ(row.median, middle);
  };
  expect(0, 2, 2, 4, 3);
  expect(1, 3, 3, 4, 3);
  expect(2, 3, 5, 8, 4);
}

TEST(MetricPercentiles, HaveNoIntervalOfOnePersonOrWithoutDraws) {
  const MadeUp alone("slip_mm", {{1, kNotKnown, kNotKnown}}), three("slip_mm", {{1, 2, 3}});
  const Scorecard card = card_of("slip_mm", 2, 6);
  const MetricPercentiles one = metric_percentiles(alone.data, alone.sites, card)[0][0];
  EXPECT_EQ(one.median, 1);
  EXPECT_TRUE(std::isnan(one.median_interval.low) && std::isnan(one.p95_interval.high));
  const MetricPercentiles undrawn =
      metric_percentiles(three.data, three.sites, card, {.resamples = 0})[0][0];
  EXPECT_EQ(undrawn.p95, 3);
  EXPECT_TRUE(std::isnan(undrawn.median_interval.low) && std::isnan(undrawn.p95_interval.high));
}

TEST(MetricPercentiles, TellDerivedMetricsOfWhatWasMeasured) {
  MadeUp made("strain", {{0.05, 0.06, kNotKnown}});
  made.sites[0].metrics["strain_swing"] = {0.02, 0.01, kNotKnown};
  Scorecard card = card_of("pre_strain_margin", 0, -0.01);  // strain − swing
  card.criteria.push_back(card_of("sensor_diameter_mm", 20, 10).criteria[0]);
  card.criteria.push_back(card_of("slip_mm", 2, 6).criteria[0]);
  card.footprint.kind = placement::FootprintShape::Kind::disc;
  card.footprint.radius = 0.012;
  const std::vector<MetricPercentiles> rows = metric_percentiles(made.data, made.sites, card)[0];
  ASSERT_EQ(rows.size(), 2u) << "nobody has a slip";
  EXPECT_NEAR(rows[0].p5, 0.03, 1e-15);
  EXPECT_NEAR(rows[0].median, 0.04, 1e-15);
  EXPECT_NEAR(rows[0].p95, 0.05, 1e-15);
  EXPECT_NEAR(rows[1].median, 24, 1e-12);
  EXPECT_EQ(rows[1].known, 2) << "a case that was not measured has no sensor";
}

// The fixture's sensor is turned by 10 − 5 score = 5.5 + 1.5 fit − 0.25 person degrees.
TEST_F(StudyOnDisk, ReportTellsWhatTheSensorsMeet) {
  const StudyAnalysis analysis = analyse(read_study_data(finished("a")));
  const nlohmann::json levels = nlohmann::json::parse(
      analysis_json(analysis))["modalities"]["imu-uncalibrated"]["metric_percentiles"];
  ASSERT_EQ(levels.size(), 4u);
  const auto row = [&](std::size_t level) { return levels[level]["metrics"].at(0); };
  EXPECT_EQ(levels[0]["bgm"], 0.0);
  EXPECT_EQ(levels[3]["level"], "all");
  EXPECT_NEAR(row(0)["median"], 5.125, 1e-12);
  EXPECT_NEAR(row(1)["median"], 6.625, 1e-12);
  EXPECT_NEAR(row(3)["median"], 8.125, 1e-12) << "the loosest turns everybody most";
  EXPECT_NEAR(row(3)["p5"], 7.75, 1e-12);
  EXPECT_NEAR(row(3)["p95"], 8.5, 1e-12);
  EXPECT_NEAR(row(3)["p95_interval"][1], 8.5, 1e-12);
  EXPECT_LT(row(3)["p95_interval"][0], 8.4);
  EXPECT_EQ(row(3)["site"], "scapula");
  EXPECT_EQ(row(3)["metric"], "rotation_deg");
  EXPECT_EQ(row(3)["unit"], "deg");
  EXPECT_EQ(row(3)["n"], 4);
  EXPECT_EQ(row(3)["left_out"], 0);
  const std::string page = study_html(analysis);
  EXPECT_NE(page.find("What the sensors meet, over all fits together"), std::string::npos);
  EXPECT_NE(page.find("total rotation of the sensor against the body"), std::string::npos);
  EXPECT_NE(page.find("7.75 to 8.5"), std::string::npos);
}

TEST_F(StudyOnDisk, ReportCountsPeopleAndCasesWithoutAMetric) {
  const StudyFolder folder = planned("a");
  for (const PlannedCase& one : plan.cases)
    if (one.levels[0] > 0 && (one.levels[0] > 1 || one.levels[1] == 0)) finish(folder, one);
  const nlohmann::json levels = nlohmann::json::parse(analysis_json(
      analyse(read_study_data(folder))))["modalities"]["imu-uncalibrated"]["metric_percentiles"];
  const nlohmann::json all = levels.at(3)["metrics"].at(0);
  EXPECT_EQ(all["n"], 3);
  EXPECT_EQ(all["left_out"], 1);
  EXPECT_EQ(all["cases_left_out"], 5);  // three of the first person, two of the second
  EXPECT_EQ(levels.at(0)["metrics"].at(0)["cases_left_out"], 1);
}

// Cases without people are no sample of anybody.
TEST_F(StudyOnDisk, ReportGivesMetricsWithoutPeopleNoInterval) {
  const Plan fits =
      make_plan(parse_study_file("[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
                                 "[[axis]]\nname = \"cloth\"\n"
                                 "fabrics = [\"denim\", \"cotton-shirting\"]\n",
                                 "x.toml"));
  const StudyFolder folder(base / "fits");
  fs::create_directories(base);
  folder.write_plan(fits);
  for (std::size_t c = 0; c < fits.cases.size(); ++c)
    write_whole(folder.result_file(fits.cases[c].address),
                record_json(made_up(fits.cases[c].address, 0.2 * static_cast<double>(c))));
  const nlohmann::json row = nlohmann::json::parse(analysis_json(
      analyse(read_study_data(folder))))["modalities"]["imu-uncalibrated"]["metric_percentiles"]
                                 .at(0)["metrics"]
                                 .at(0);
  EXPECT_EQ(row["n"], 2);
  EXPECT_NEAR(row["median"], 9.5, 1e-12);
  EXPECT_TRUE(row["median_interval"][0].is_null());
}

}  // namespace
}  // namespace loosefit::study
