#include "loosefit/io/scorecard_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/io/text_file.h"
#include "loosefit/placement/derived_metrics.h"
#include "support/mutate.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

const std::string kHead =
    "title = \"t\"\nabout = \"a\"\n[footprint]\nradius = 0.01\n";  // four lines
const std::string kWords = "reason = \"r\"\nsource = \"s\"\n";

std::string criterion(const std::string& metric, const std::string& unit,
                      const std::string& limits) {
  return "[[criterion]]\nmetric = \"" + metric + "\"\nunit = \"" + unit + "\"\n" + limits + "\n" +
         kWords;
}

std::string refusal(const std::string& text) {
  try {
    parse_scorecard(text, "my.toml");
  } catch (const InvalidInput& e) {
    return std::string(e.what()) + " | " + e.hint();
  }
  return "accepted";
}

/// Names in the first table of docs/scorecards.md, in alphabetical order.
std::vector<std::string> documented_scorecards() {
  std::ifstream file(LOOSEFIT_SOURCE_DIR "/docs/scorecards.md");
  std::set<std::string> names;
  bool shipped = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) shipped = line == "## Shipped scorecards";
    if (shipped && line.rfind("| `", 0) == 0) names.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return {names.begin(), names.end()};
}

TEST(Scorecards, ShippedOnesAreReadAndComplete) {
  std::vector<std::string> all = scorecard_names(), of_lines = line_scorecard_names();
  all.insert(all.end(), of_lines.begin(), of_lines.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, documented_scorecards())
      << "found in data/scorecards, expected as in docs/scorecards.md";
  for (const std::string& name : scorecard_names()) {
    SCOPED_TRACE(name);
    const placement::Scorecard card = load_scorecard(name);
    EXPECT_EQ(card.name, name);
    EXPECT_GT(card.about.size(), 40u);
    EXPECT_GT(placement::outer_radius(card.footprint), 0);
    for (const placement::Criterion& c : card.criteria) {
      EXPECT_GE(c.source.size(), 10u);
      EXPECT_GT(c.reason.size(), 15u);
    }
    // With every measured word of the vocabulary a card can be rated, whatever it derives.
    placement::MetricValues values;
    for (const placement::MetricName& m : placement::metric_vocabulary()) values[m.name] = 0.5;
    for (const char* derived :
         {"usable_signal_ratio", "pre_strain_margin", "strain_peak", "capacitance_pF",
          "capacitance_swing", "temperature_error_K", "sensor_diameter_mm"})
      values.erase(derived);
    EXPECT_TRUE(placement::score(values, card).q.has_value())
        << placement::score(values, card).reason;
  }
}

TEST(Scorecards, OfLinesAreReadAndCompleteAndJudgeNoPlaces) {
  EXPECT_EQ(line_scorecard_names(), (std::vector<std::string>{"lead", "stretch"}));
  placement::MetricValues all;
  for (const placement::MetricName& m : placement::line_vocabulary()) all[m.name] = 0.5;
  for (const std::string& name : line_scorecard_names()) {
    const placement::Scorecard card = load_scorecard(name, true);
    EXPECT_TRUE(card.of_lines);
    EXPECT_TRUE(placement::score(all, card).q.has_value());
    for (const placement::Criterion& c : card.criteria) EXPECT_GE(c.source.size(), 10u);
    EXPECT_THROW(load_scorecard(name), InvalidInput) << "a place";
  }
  EXPECT_THROW(load_scorecard("ecg", true), InvalidInput) << "a line";
  const std::string head = "title = \"t\"\nabout = \"a\"\njudges = \"lines\"\n";
  const std::string criterion =
      "[[criterion]]\nmetric = \"M\"\nunit = \"-\"\ngood = 0.1\nfail = 0.2\nreason = \"r\"\n"
      "source = \"s\"\n";
  const auto with = [&](const std::string& metric, const std::string& more = {}) {
    std::string text = head + more + criterion;
    return parse_scorecard(text.replace(text.find("\"M\""), 3, '"' + metric + '"'), "c.toml");
  };
  EXPECT_NO_THROW(with("line_slack"));
  EXPECT_THROW(with("slack"), InvalidInput);
  EXPECT_THROW(with("line_slack", "regions = [\"chest\"]\n"), InvalidInput);
}

TEST(Scorecards, ManualNamesEveryWord) {
  // Metrics that are read of an array stand in the table of maps too.
  std::string docs;
  for (const char* page : {"/docs/scorecards.md", "/docs/maps.md"})
    docs += read_text_file(std::string(LOOSEFIT_SOURCE_DIR) + page, 1000000);
  const auto named = [&](const std::string& word) {
    EXPECT_NE(docs.find("`" + word + "`"), std::string::npos) << word;
  };
  for (const placement::MetricName& m : placement::metric_vocabulary()) named(m.name);
  for (const placement::MetricName& m : placement::line_vocabulary()) named(m.name);
  for (const placement::SensorParameter& p : placement::sensor_parameters()) named(p.name);
  for (const std::string& name : scorecard_names()) named(name);
}

// docs/theory/sensor_metrics.md 3.4 and 8.
TEST(Scorecards, LimitsAreTheDocumentedOnes) {
  const placement::Scorecard imu = load_scorecard("imu-inclination");
  EXPECT_DOUBLE_EQ(placement::score({{"coe_rms_deg", 8.5}}, imu).q.value(), 0.5);
  EXPECT_GE(placement::score({{"coe_rms_deg", 4.98}}, imu).q.value(), imu.pass)
      << "usable to 5 degrees";
  EXPECT_LT(placement::score({{"coe_rms_deg", 5.02}}, imu).q.value(), imu.pass);
  const placement::MetricValues pressed = {{"contact_ratio", 1}, {"contact_duty", 1},
                                           {"pressed_ratio", 1}, {"pressed_duty", 1},
                                           {"gap_worst_mm", 0},  {"pressure_kPa", 5.0}};
  EXPECT_DOUBLE_EQ(placement::score(pressed, load_scorecard("ppg")).q.value(), 1);
  EXPECT_EQ(placement::score(pressed, load_scorecard("eda")).q.value(), 0)
      << "too hard for the trunk";
  const placement::Scorecard temperature = load_scorecard("temperature");
  EXPECT_NEAR(
      placement::with_derived({{"gap_mm", 0.5}}, temperature.parameters, temperature.footprint)
          .at("temperature_error_K"),
      0.24, 0.005);
}

TEST(Scorecards, ReadByPathToo) {
  const support::ScratchFolder scratch;
  const auto path = scratch / "my_card.toml";
  write_text_file(path.string(), kHead + criterion("gap_mm", "mm", "good = 0.1\nfail = 1"));
  const placement::Scorecard card = load_scorecard(path.string());
  EXPECT_EQ(card.name, "my_card");
  EXPECT_DOUBLE_EQ(card.criteria.at(0).limit.fail, 1);
  std::filesystem::remove(path);
  EXPECT_THROW(load_scorecard(path.string()), IoError);
}

TEST(Scorecards, UnknownNameAsksBack) {
  try {
    load_scorecard("ecq");
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("modality: found \"ecq\""), std::string::npos);
    EXPECT_EQ(e.hint(), "did you mean \"ecg\"?");
  }
}

TEST(Scorecards, WithoutDataSaysWhereTheyAre) {
  setenv("LOOSEFIT_SHARE", "/nowhere", 1);
  EXPECT_TRUE(scorecard_names().empty());
  EXPECT_THROW(load_scorecard("ecg"), IoError);
  unsetenv("LOOSEFIT_SHARE");
}

TEST(ScorecardFile, RangesAndShapes) {
  placement::Scorecard card =
      parse_scorecard(kHead + criterion("pressure_kPa", "kPa", "good = [1, 2]\nfail = [0, 4]") +
                          "reason_above = \"too much\"\n",
                      "dir/my.toml");
  EXPECT_EQ(card.name, "my");
  EXPECT_DOUBLE_EQ(card.pass, 0.5);
  ASSERT_TRUE(card.criteria[0].upper.has_value());
  EXPECT_DOUBLE_EQ(card.criteria[0].upper->fail, 4);
  EXPECT_EQ(card.criteria[0].reason_above, "too much");
  card = parse_scorecard(
      "title = \"t\"\nabout = \"a\"\n[footprint]\nshape = \"rectangle\"\nlength "
      "= 0.03\nwidth = 0.04\n" +
          criterion("slack", "-", "good = 0\nfail = 0.2"),
      "my.toml");
  EXPECT_DOUBLE_EQ(placement::outer_radius(card.footprint), 0.025);
}

TEST(ScorecardFile, RefusalsNamePlaceAndRemedy) {
  const std::string gap = criterion("gap_mm", "mm", "good = 0.1\nfail = 1");
  EXPECT_EQ(refusal(kHead + gap), "accepted");
  const auto says = [](const std::string& text, const std::string& part) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  says(kHead + criterion("gap", "mm", "good = 0.1\nfail = 1"),
       "my.toml:6: criterion[0].metric: found \"gap\", expected the name of a metric");
  says(kHead + criterion("slip_mn", "mm", "good = 1\nfail = 2"), "did you mean \"slip_mm\"?");
  says(kHead + criterion("gap_mm", "cm", "good = 0.1\nfail = 1"),
       "my.toml:7: criterion[0].unit: found \"cm\", expected \"mm\"");
  says(kHead + criterion("gap_mm", "mm", "good = 1\nfail = 1"),
       "expected another number than good");
  says(kHead + criterion("gap_mm", "mm", "good = 1\nfail = [0, 2]"),
       "expected a number, as good is");
  says(kHead + criterion("gap_mm", "mm", "good = [1, 2]\nfail = [1.5, 3]"),
       "expected [below 1, above 2]");
  says(kHead + criterion("gap_mm", "mm", "good = [2, 1]\nfail = [0, 3]"),
       "good: found an array of 2, expected [low, high], the lower one first");
  says(kHead + criterion("gap_mm", "mm", "good = [1, 2, 3]\nfail = 3"), "[low, high] of a range");
  says(kHead + criterion("gap_mm", "mm", "good = 1"), "fail: found nothing");
  says(kHead + criterion("gap_mm", "mm", "good = [1, 2]\nfail = [0, 4]"),
       "reason_above: found nothing");
  says(kHead +
           "[[criterion]]\nmetric = \"gap_mm\"\nunit = \"mm\"\ngood = 0\nfail = 1\nreason = "
           "\"r\"\n",
       "source: found nothing");
  says(kHead + criterion("usable_signal_ratio", "-", "good = 3\nfail = 1"),
       "expected sensor.strain_error beside it | usable_signal_ratio is computed with it");
  says(kHead + gap + "weight = 2\n", "criterion[0].weight: found an unknown key");
  says(kHead + gap + "goods = 2\n", "did you mean \"good\"?");
  says("titel = \"t\"\n" + kHead + gap, "did you mean \"title\"?");
  says(kHead, "criterion: found nothing, expected at least one [[criterion]]");
  says("title = \"t\"\nabout = \"a\"\n" + gap, "footprint: found nothing");
  says("title = \"t\"\nabout = \"a\"\n[footprint]\nradius = 12\n" + gap,
       "lengths are in metres: 12 cm is 0.12");
  says("title = \"t\"\nabout = \"a\"\n[footprint]\nshape = \"disk\"\nradius = 0.01\n" + gap,
       "did you mean \"disc\"?");
  says(kHead + "[sensor]\nstrain_eror = 0.1\n" + gap, "did you mean \"strain_error\"?");
  says(kHead + "[sensor]\nskin_temperature = 306\n" + gap, "degrees Celsius from 20 to 45");
  says("regions = [\"chset\"]\n" + kHead + gap, "did you mean \"chest\"?");
  says("pass = 2\n" + kHead + gap, "pass: found 2");
  says("about = \"a\"\n", "title: found nothing, expected what the sensor is");
}

// Damaged files: never a crash; what is accepted gives scores from 0 to 1.
TEST(ScorecardFile, DamagedOnesAreRefusedOrSound) {
  const std::string whole =
      read_text_file((data_directory() / "scorecards" / "ecg.toml").string(), 100000);
  Mutator damage(5);
  int refused = 0, accepted = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string text = damage(whole);
    try {
      const placement::Scorecard card = parse_scorecard(text, "damaged.toml");
      ++accepted;
      placement::MetricValues all;
      for (const placement::MetricName& m : placement::metric_vocabulary()) all[m.name] = 0.7;
      const placement::Score s = placement::score(all, card);
      ASSERT_TRUE(s.q.has_value() && *s.q >= 0 && *s.q <= 1 && s.limiting >= 0) << text;
    } catch (const InvalidInput& e) {
      ++refused;
      ASSERT_EQ(std::string(e.what()).rfind("damaged.toml", 0), 0u) << e.what() << "\n" << text;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(accepted, 100);
}

TEST(ScorecardFile, SlipsAreNamedBeforeWhatIsThenMissing) {
  try {
    parse_scorecard("titel = \"x\"\n", "card.toml");
    FAIL() << "a misspelt title";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("titel: found an unknown key"), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace loosefit::io
