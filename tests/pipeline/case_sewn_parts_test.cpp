#include "loosefit/pipeline/case_sewn_parts.h"

#include <gtest/gtest.h>

#include <atomic>

#include "loosefit/base/error.h"
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

/// Counts what a drape reports.
struct Listener : Progress {
  mutable std::atomic<int> checks{0};
  void check_cancelled() const override { ++checks; }
};

struct Placed {
  SewnParts parts;
  int checks = 0;
  explicit Placed(const std::string& sites) {
    const scenario::Scenario scenario = scenario_with(sites);
    const CaseBody body = make_body(scenario.body);
    Listener listener;
    parts = place_sewn_parts(scenario, body, make_patterns(scenario, body.body), listener);
    checks = listener.checks;
  }
};

const char* const kBoard = "board = { mass = 0.02 }\n";
const char* const kSpine = "[[site]]\nname = \"spine\"\nlandmark = \"upper_back\"\n";
const char* const kFlat = "[[site]]\nname = \"flat\"\npanel = \"front\"\nat = [0.1, -0.3]\n";

// From the side of the front onto the back: the axis leads on.
TEST(CaseSewnParts, ABoardThatIsShiftedInThePatternNeedsNoDrape) {
  const Placed placed(std::string(kFlat) + kBoard +
                      "shift = [0.2, 0]\nangle_deg = 90\nfootprint = { size = [0.02, 0.04] }\n");
  EXPECT_EQ(placed.checks, 0);
  EXPECT_GT(Placed(std::string(kSpine) + kBoard).checks, 0) << "as a drape does";
  const placement::SiteSpec& site = placed.parts.sites[0];
  EXPECT_EQ(site.panel, "back");
  EXPECT_TRUE(site.shift.isZero());
  const garment::Board& board = std::get<garment::Board>(placed.parts.attachments[0].part);
  EXPECT_EQ(board.centre, site.at);
  EXPECT_EQ(board.angle, site.angle);
  EXPECT_EQ(placed.parts.attachments[0].panel, "back");
  // Back along its axis, which lay along the shift at the start (90 degrees: along −u).
  const scenario::Scenario scenario = scenario_with(kFlat);
  const CaseBody body = make_body(scenario.body);
  const std::vector<CaseGarment> mesh =
      mesh_garments(scenario, make_patterns(scenario, body.body), {}, MeshLevels::coarsest);
  placement::SiteSpec back = site;
  back.shift = 0.2 * placement::axis_in_pattern(site.angle);
  back = placement::without_shift(back, mesh.back().mesh());
  EXPECT_EQ(back.panel, "front");
  EXPECT_LT((back.at - Vec2(0.1, -0.3)).norm(), 1e-6);
}

// As from the place in the pattern that the landmark has by itself.
TEST(CaseSewnParts, ABoardThatIsShiftedFromALandmarkTakesItsAxisAlong) {
  const std::string waist =
      "[[site]]\nlandmark = \"waist_L\"\nangle_deg = 30\n" + std::string(kBoard) + "name = ";
  const Placed placed(waist + "\"still\"\n" + waist + "\"one\"\nshift = [0.08, 0.01]\n" + waist +
                      "\"other\"\nshift = [-0.08, 0.01]\n");
  const scenario::Scenario scenario = scenario_with("");
  const CaseBody body = make_body(scenario.body);
  const std::vector<CaseGarment> mesh =
      mesh_garments(scenario, make_patterns(scenario, body.body), {}, MeshLevels::coarsest);
  int over_a_seam = 0;
  for (const std::size_t i : {1, 2}) {
    placement::SiteSpec from = placed.parts.sites[0];
    from.shift = {i == 1 ? 0.08 : -0.08, 0.01};
    const placement::SiteSpec expected = placement::without_shift(from, mesh.back().mesh());
    const placement::SiteSpec& site = placed.parts.sites[i];
    EXPECT_EQ(site.panel, expected.panel);
    EXPECT_LT((site.at - expected.at).norm(), 1e-6);
    EXPECT_NEAR(site.angle, expected.angle, 1e-9);
    if (site.panel == from.panel) continue;
    ++over_a_seam;
    EXPECT_GT(std::abs(site.angle - radians(30.0)), radians(1.0)) << "the sides slant";
    EXPECT_EQ(std::get<garment::Board>(placed.parts.attachments[i].part).angle, site.angle);
  }
  EXPECT_GT(over_a_seam, 0);
}

std::string refused_key(const std::string& sites) {
  try {
    Placed{sites};
  } catch (const InvalidInput& error) {
    return error.place().key;
  }
  return "accepted";
}

// A sensor without a board that ends over the edge is warned of once the garment is worn.
TEST(CaseSewnParts, OnlyABoardMustEndOnTheCloth) {
  const std::string over = "shift = [0, -0.2]\n",
                    low = "[[site]]\nname = \"low\"\npanel = \"front\"\nat = [0.1, -0.55]\n" + over;
  const std::string spine = std::string(kSpine) + kBoard;
  EXPECT_EQ(refused_key(low + spine), "accepted");
  EXPECT_EQ(refused_key("[[site]]\nname = \"knee\"\nlandmark = \"patella_L\"\n" + spine),
            "accepted");
  EXPECT_EQ(refused_key(kFlat + low + kBoard), "site[1].shift");
  EXPECT_EQ(refused_key(low + "[[site]]\nname = \"neck\"\nlandmark = \"c7\"\n" + kBoard +
                        "shift = [0, 0.15]\n"),
            "site[1].shift");
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
