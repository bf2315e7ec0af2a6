#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"

namespace loosefit::pipeline {
namespace {

CaseResult worn(const std::string& body, const std::string& garment) {
  const scenario::Scenario scenario = io::parse_scenario(
      "[body]\n" + body + "[garment]\n" + garment +
          "[donning]\nmovements = []\n[simulation]\nedge_length = 0.03\ntime_budget = 600\n",
      "case.toml");
  Progress silent;
  RunOptions options;
  options.only_drape = true;
  return run_case(scenario, silent, options);
}

double mean_height(const CaseResult& result, const std::string& part, const std::string& edge) {
  const auto* chain = result.studied().mesh().find_part(part, edge);
  EXPECT_TRUE(chain);
  double sum = 0;
  for (const int v : chain->vertices) sum += result.studied().drape.positions[v].z();
  return sum / static_cast<double>(chain->vertices.size());
}

TEST(TrousersWorn, HangByTheirWaistbandOnWomanManAndChild) {
  for (const char* body : {"sex = \"female\"\n", "sex = \"male\"\nheight = 1.80\n",
                           "sex = 0.4\nage = 9\nheight = 1.35\n"}) {
    SCOPED_TRACE(body);
    const CaseResult result = worn(body, "pattern = \"trousers\"\n");
    EXPECT_TRUE(result.certificate().holds()) << result.certificate().stop_reason;
    EXPECT_EQ(result.certificate().worn_reasons, std::vector<std::string>{});
    const auto& measured = result.body.body->measured;
    EXPECT_NEAR(mean_height(result, "waistband_front", "rim"), measured.at("waist_level"), 0.05);
    const double hem = mean_height(result, "front_L", "hem");
    EXPECT_GT(hem, 0.03);
    EXPECT_LT(hem, 0.2 * measured.at("crotch_height"));
  }
}

TEST(TrousersWorn, LeggingsOfAKnitLieOnTheLegs) {
  const CaseResult result =
      worn("sex = \"female\"\n", "pattern = \"leggings\"\n[material]\nname = \"cotton-jersey\"\n");
  EXPECT_TRUE(result.certificate().holds()) << result.certificate().stop_reason;
  EXPECT_EQ(result.certificate().worn_reasons, std::vector<std::string>{});
}

}  // namespace
}  // namespace loosefit::pipeline
