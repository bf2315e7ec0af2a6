#include "loosefit/pipeline/rank_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/prepare_case.h"
#include "loosefit/pipeline/simulation_options.h"

namespace loosefit::pipeline {
namespace {

TEST(SamePieces, CountByNameAndShapeAndNotByHowCurvesAreDivided) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  pattern::Pattern other = shirt;
  EXPECT_TRUE(same_pieces(shirt, other));
  other.panels[0].vertices[0].x() += 1e-4;
  EXPECT_TRUE(same_pieces(shirt, other)) << "a tenth of a millimetre";
  other.panels[0].vertices[0].x() += 2e-3;
  EXPECT_FALSE(same_pieces(shirt, other));
  other = shirt;
  other.panels[0].name = "fore";
  EXPECT_FALSE(same_pieces(shirt, other));
  other.panels.pop_back();
  EXPECT_FALSE(same_pieces(shirt, other));
}

TEST(RankCases, WithoutRunsIsRefused) { EXPECT_THROW(rank_cases({}, {}, true), InvalidInput); }

/// A shirt as it is put on, without time to settle, with its maps all the same.
CaseResult worn_shirt() {
  const scenario::Scenario scenario = io::parse_scenario(
      "[[site]]\nname = \"spine\"\nlandmark = \"mid_back\"\n[output]\npreset_sites = false\n"
      "[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n",
      "case.toml");
  Progress silent;
  CaseResult result = prepare_case(scenario, silent);
  CaseGarment& shirt = result.studied();
  shirt.drape = drape::drape_garment(shirt.hierarchy, scenario.studied().material.material,
                                     result.body.path, drape_options(scenario.simulation), silent);
  shirt.maps = make_studied_maps(result, true);
  return result;
}

TEST(RankCases, RunsOfOneCutKeepTheSewnPlaceAndOthersFindTheirOwn) {
  placement::RankingWish wish;
  wish.scorecard.name = "gap";
  wish.scorecard.criteria = {{"gap_mm", {0, 100}, {}, "hangs off", "", "test"}};
  const CaseResult one = worn_shirt();
  CaseResult away = one;
  const std::vector<RankedRun> runs = {{"one", &one}, {"away", &away}};
  for (Vec3& p : away.studied().drape.positions) p.y() += 0.010;  // the back 10 mm farther off
  away.studied().maps = make_studied_maps(away, true);
  const placement::RankingTable same = rank_cases(runs, wish, true);
  EXPECT_EQ(same.sample_names, (std::vector<std::string>{"one", "away"}));
  EXPECT_EQ(same.notes.at(0),
            "samples are the runs one, away: sensors stay where they are sewn in the first");
  ASSERT_EQ(same.sites.size(), 1u);
  ASSERT_EQ(same.sites[0].samples.size(), 2u);
  EXPECT_NEAR(same.sites[0].samples[1].at("gap_mm") - same.sites[0].samples[0].at("gap_mm"), 10, 2);
  EXPECT_EQ(same.ranking.sites[0].score.robust_sample, 1);

  away.scenario.body.posture.forward_bend = 0.5;
  away.studied().pattern.pattern.panels[0].vertices[0].x() += 0.01;
  const placement::RankingTable cut = rank_cases(runs, wish, true);
  EXPECT_NE(cut.notes.at(0).find("cut differently"), std::string::npos) << cut.notes[0];
  EXPECT_NE(cut.notes.at(1).find("different postures"), std::string::npos) << cut.notes[1];
  EXPECT_FALSE(cut.places[0].tolerance);
  wish.best = 1;
  EXPECT_THROW(rank_cases(runs, wish, true), InvalidInput);
  wish.best = 0;
  away.scenario.sites[0].name = "other";
  EXPECT_THROW(rank_cases(runs, wish, true), InvalidInput);
}

}  // namespace
}  // namespace loosefit::pipeline
