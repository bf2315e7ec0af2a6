#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/validate/validation_json.h"
#include "loosefit/validate/validation_page.h"
#include "loosefit/validate/validation_table.h"
#include "support/artificial_benchmarks.h"

namespace loosefit::validate {
namespace {

Validation artificial_validation() {
  auto all = support::artificial_benchmarks();
  all[0].run = [](Effort, Progress&) {
    BenchmarkResult result;
    result.findings = {support::finding(2, 2.001, Finding::Gate::relative, 0.01),
                       support::finding(2, std::nan(""), Finding::Gate::absolute, 0.01)};
    report::Plot plot{"Elastica & points", "Γ", "H/W", true, true, {}};
    plot.series = {{"elastica", {0.01, 1, 100}, {1e-3, 0.1, 5}, true},
                   {"obtained", {0.01, 1, -1, 100}, {1e-3, 0.1, 1, 5}, false}};
    result.plots = {plot};
    result.notes = {"A note <b> to read."};
    return result;
  };
  Progress silent;
  return run_validation(all, Effort::full, silent, 1);
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(ValidationTable, HasEveryColumnAndTheVerdict) {
  const std::string table = outcome_table(artificial_validation().outcomes[0]);
  for (const char* column : {"figure", "expected", "obtained", "error", "gate", "mesh"})
    EXPECT_NE(table.find(column), std::string::npos) << column;
  EXPECT_NE(table.find("A1 Artificial: MISS"), std::string::npos) << table;
  EXPECT_NE(table.find("0.05 %"), std::string::npos) << table;
  EXPECT_NE(table.find("pass"), std::string::npos) << table;
  EXPECT_NE(table.find("not a number"), std::string::npos) << table;
}

TEST(ValidationTable, ShowsWhyABenchmarkBroke) {
  const std::string table = outcome_table(artificial_validation().outcomes[3]);
  EXPECT_NE(table.find("A4 Artificial: MISS"), std::string::npos) << table;
  EXPECT_NE(table.find("error: the loom broke"), std::string::npos) << table;
}

TEST(ValidationJson, HasTheKeysOfTheManual) {
  const auto json = nlohmann::json::parse(validation_json(artificial_validation()));
  for (const char* key :
       {"effort", "pass", "gated", "passed", "seconds", "settings", "benchmarks", "versions"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["effort"], "full");
  EXPECT_EQ(json["pass"], false);
  EXPECT_EQ(json["gated"], 4);
  EXPECT_EQ(json["missed"], 4);
  EXPECT_EQ(json["known_misses"], 0);
  const auto& first = json["benchmarks"][0];
  for (const char* key : {"id", "title", "reference", "gated", "pass", "seconds", "error",
                          "findings", "notes", "plots"})
    EXPECT_TRUE(first.contains(key)) << key;
  const auto& good = first["findings"][0];
  for (const char* key :
       {"what", "unit", "expected", "obtained", "error", "gate", "limit", "mesh", "pass"})
    EXPECT_TRUE(good.contains(key)) << key;
  for (const char* key : {"verdict", "known_miss", "share_of_gate"})
    EXPECT_TRUE(good.contains(key)) << key;
  EXPECT_EQ(good["gate"], "relative");
  EXPECT_EQ(good["pass"], true);
  EXPECT_TRUE(first["findings"][1]["obtained"].is_null()) << "NaN has no place in JSON";
  EXPECT_EQ(json["benchmarks"][3]["error"], "the loom broke");
  EXPECT_TRUE(json["benchmarks"][2]["findings"][0]["limit"].is_null());
  EXPECT_EQ(first["plots"][0]["series"][1]["x"].size(), 4u);
}

TEST(ValidationOutputs, KnownMissesAreToldWithTheirReasonInJsonAndPage) {
  Finding f = in_range("filling", "", std::nan(""), 1.05, 0, 1.02, "10 mm edges");
  f.known_miss = KnownMiss{0.1, "because of <folds>"};
  Progress silent;
  const Validation v = run_validation({support::with_findings("K1", {f})}, Effort::full, silent, 1);
  const auto json = nlohmann::json::parse(validation_json(v));
  EXPECT_EQ(json["pass"], true);
  EXPECT_EQ(json["known_misses"], 1);
  const auto& finding = json["benchmarks"][0]["findings"][0];
  EXPECT_EQ(json["benchmarks"][0]["verdict"], "known miss");
  EXPECT_EQ(finding["pass"], false);
  EXPECT_TRUE(finding["expected"].is_null());
  EXPECT_EQ(finding["limit"], (std::vector<double>{0, 1.02}));
  EXPECT_EQ(finding["known_miss"]["most"], 0.1);
  EXPECT_EQ(finding["known_miss"]["reason"], "because of <folds>");
  const std::string page = validation_html(v);
  EXPECT_NE(page.find("verdict-known\">known miss"), std::string::npos);
  EXPECT_NE(page.find("filling: known to miss by up to 0.1: because of &lt;folds&gt;"),
            std::string::npos);
  EXPECT_NE(page.find("the reason stands as far as it is known"), std::string::npos);
}

TEST(ValidationPage, IsSelfContainedAndShowsPlotsTablesAndSettings) {
  const std::string page = validation_html(artificial_validation());
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(count(page, "<svg"), 1);
  EXPECT_EQ(page.find("http"), std::string::npos) << "nothing is fetched";
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("A note &lt;b&gt; to read."), std::string::npos) << "texts are escaped";
  EXPECT_NE(page.find("the loom broke"), std::string::npos);
  EXPECT_NE(page.find("Reference: made up"), std::string::npos);
  EXPECT_NE(page.find("Settings, the same for all benchmarks"), std::string::npos);
  EXPECT_NE(page.find("1 of 4") == std::string::npos ? page.find("0 of 4") : page.find("1 of 4"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::validate
