#include "loosefit/pipeline/case_sewn_parts.h"

#include <gtest/gtest.h>

#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::pipeline {
namespace {

// Without time to settle: the place is then that of the garment as it is put on.
scenario::Scenario scenario_with(const std::string& sites) {
  return io::parse_scenario("[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n" + sites,
                            "case.toml");
}

TEST(CaseSewnParts, ABoardWantedOnTheBodyGetsAPlaceInThePattern) {
  scenario::Scenario scenario = scenario_with(
      "[[site]]\nname = \"spine\"\nlandmark = \"upper_back\"\nboard = { mass = 0.02 }\n"
      "[[site]]\nname = \"arm\"\nsegment = \"upper_arm\"\nside = \"right\"\n"
      "ratios = [100, 50, 50]\nboard = { mass = 0.01 }\n"
      "[[site]]\nname = \"bare\"\nlandmark = \"sternum\"\n"
      "[[site]]\nname = \"flat\"\npanel = \"front\"\nat = [0.1, -0.3]\nboard = {}\n");
  Progress silent;
  const CaseBody body = make_body(scenario.body);
  const std::vector<CasePattern> patterns = make_patterns(scenario, body.body);
  const SewnParts parts = place_sewn_parts(scenario, body, patterns, silent);
  const std::vector<placement::SiteSpec>& sites = parts.sites;
  EXPECT_EQ(sites[0].panel, "back");
  EXPECT_NEAR(sites[0].at.x(), 0, 0.005);
  // T3 is about 13 cm below the high point shoulder of this woman.
  EXPECT_NEAR(sites[0].at.y(), -0.13, 0.05);
  EXPECT_TRUE(sites[1].panel.starts_with("sleeve_R")) << sites[1].panel;
  EXPECT_TRUE(sites[2].panel.empty()) << "nothing to carry: found on the drape itself";
  EXPECT_EQ(sites[3].at, Vec2(0.1, -0.3));

  const std::vector<garment::Attachment>& all = parts.attachments;
  ASSERT_EQ(all.size(), 3u);
  const garment::Garment garment =
      garment::build_hierarchy(patterns[0].pattern, 0.03, {}, all).finest();
  const garment::Garment bare = garment::build_hierarchy(patterns[0].pattern, 0.03, {}).finest();
  EXPECT_NEAR(garment.mass - bare.mass, 0.03, 1e-12);
}

// Once it has its place in the pattern there is nothing left to shift.
TEST(CaseSewnParts, ABoardThatIsShiftedIsSewnOnWhereItsShiftLeads) {
  const std::string board = "board = { mass = 0.02 }\n";
  const std::string spine = "landmark = \"upper_back\"\n" + board;
  const std::string flat = "panel = \"front\"\nat = [0.1, -0.3]\n" + board;
  const std::string shift = "shift = [0.015, -0.02]\n";
  scenario::Scenario scenario = scenario_with(
      "[[site]]\nname = \"a\"\n" + spine + "[[site]]\nname = \"b\"\n" + spine + shift +
      "[[site]]\nname = \"c\"\n" + flat + "[[site]]\nname = \"d\"\n" + flat + shift);
  Progress silent;
  const CaseBody body = make_body(scenario.body);
  const SewnParts parts =
      place_sewn_parts(scenario, body, make_patterns(scenario, body.body), silent);
  for (const std::size_t still : {0, 2}) {
    const placement::SiteSpec &from = parts.sites[still], &to = parts.sites[still + 1];
    EXPECT_EQ(to.panel, from.panel);
    EXPECT_LT((to.at - from.at - Vec2(0.015, -0.02)).norm(), 1e-6);
    EXPECT_EQ(to.shift, Vec2(Vec2::Zero()));
    EXPECT_EQ(std::get<garment::Board>(parts.attachments[still + 1].part).centre, to.at);
  }
  EXPECT_EQ(parts.sites[0].landmark, "upper_back");
  EXPECT_TRUE(parts.sites[1].landmark.empty())
      << "20 mm from there on purpose, not worth a warning";
}

TEST(CaseSewnParts, MovedFarFromWhereTheyWereWantedAreTold) {
  CaseResult result;
  result.scenario = scenario_with(
      "[[site]]\nname = \"spine\"\nlandmark = \"upper_back\"\nboard = { mass = 0.02 }\n"
      "[[site]]\nname = \"flat\"\npanel = \"front\"\nat = [0.1, -0.3]\nboard = {}\n");
  result.body = make_body(result.scenario.body);
  const Vec3 wanted = placement::SitePoints(result.body.body).at("upper_back");
  placement::Site spine, flat;
  spine.name = "spine";
  spine.body_point = wanted + Vec3(0, 0, 0.010);
  flat.name = "flat";
  result.sites = {spine, flat};
  EXPECT_TRUE(moved_board_warnings(result).empty());
  result.sites[0].body_point = wanted + Vec3(0, 0, 0.020);
  const std::vector<std::string> warnings = moved_board_warnings(result);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("board of site spine lies 20 mm"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::pipeline
