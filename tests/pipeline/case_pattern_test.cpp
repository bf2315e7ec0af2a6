#include "loosefit/pipeline/case_pattern.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/simulation_options.h"
#include "support/measured_woman.h"

namespace loosefit::pipeline {
namespace {

using support::measured_woman;

TEST(MakePattern, DraftHasTheWishedMobilityAtEveryLevel) {
  scenario::GarmentSpec wished;
  wished.fit["chest"] = 0.15;
  wished.fit["waist"] = 0.22;
  wished.fit["hip"] = 0.05;
  wished.fit["sleeve"] = 0.30;
  wished.fit["wrist"] = 0.40;
  const CasePattern made = make_pattern(wished, measured_woman());
  EXPECT_NEAR(made.fit.at("chest"), 0.15, 1e-6);
  EXPECT_NEAR(made.fit.at("waist"), 0.22, 1e-6);
  EXPECT_NEAR(made.fit.at("hip"), 0.05, 1e-6);
  EXPECT_NEAR(made.fit.at("sleeve"), 0.30, 1e-6);
  EXPECT_NEAR(made.fit.at("wrist"), 0.40, 1e-6);
  EXPECT_EQ(made.pattern.stitches.size(), 12u);
}

// One garment on two bodies: its girths stay, its mobility follows the body.
TEST(MakePattern, SizeIsTheSameGarmentForEveryBody) {
  scenario::GarmentSpec wished;
  wished.size = "child-142";
  body::Body slim = measured_woman(), heavy = measured_woman();
  slim.measured["chest"] = 0.63;
  heavy.measured["chest"] = 0.75;
  const CasePattern a = make_pattern(wished, slim), b = make_pattern(wished, heavy);
  EXPECT_EQ(a.girths.at("chest"), b.girths.at("chest"));
  EXPECT_NEAR((1 + a.fit.at("chest")) * 0.63, (1 + b.fit.at("chest")) * 0.75, 1e-9);
  EXPECT_EQ(io::garmentcode_text(a.pattern), io::garmentcode_text(b.pattern));
}

TEST(MakePattern, ShortSleeveIsComparedWithTheArmWhereItEnds) {
  scenario::GarmentSpec wished;
  wished.kind = "t-shirt";
  wished.fit["sleeve_length"] = 0.36;
  wished.fit["wrist"] = 0.12;
  const CasePattern made = make_pattern(wished, measured_woman());
  EXPECT_EQ(made.pattern.name, "t-shirt");
  EXPECT_NEAR(made.fit.at("cuff"), 0.12, 1e-9);
  // At 0.36 of the arm it is on its way from the upper arm, taped at 0.168, to the elbow at 0.56.
  const double elbow = 0.160 + 0.82 * (0.284 - 0.160);
  const double arm = 0.284 + (0.36 - 0.168) / (0.56 - 0.168) * (elbow - 0.284);
  EXPECT_NEAR(made.girths.at("cuff"), 1.12 * arm, 1e-9);
  EXPECT_EQ(made.fit.count("wrist"), 0u);
  EXPECT_EQ(made.girths.count("wrist"), 0u);

  scenario::GarmentSpec sized = wished;
  sized.size = "women-38";
  const CasePattern fixed = make_pattern(sized, measured_woman());
  EXPECT_NEAR(fixed.girths.at("cuff") / arm, fixed.girths.at("sleeve") / 0.284, 1e-6)
      << "as loose as the sleeve";
}

TEST(MakePattern, MissingMeasureIsNamed) {
  body::Body body = measured_woman();
  body.measured.erase("scye_depth");
  try {
    make_pattern({}, body);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("body.scye_depth"), std::string::npos) << e.what();
    EXPECT_NE(e.hint().find("size"), std::string::npos);
  }
}

TEST(DrapeOptions, FollowTheScenario) {
  scenario::ScenarioSimulation simulation;
  simulation.integrator = "implicit-euler";
  simulation.seed = 40;
  simulation.gravity = 9.8;
  EXPECT_EQ(drape_options(simulation).integrator, drape::IntegratorKind::implicit_euler);
  EXPECT_EQ(drape_options(simulation).gravity, 9.8);
  EXPECT_EQ(drape_options(simulation, 2).seed, 42u);
  simulation.integrator = "magic";
  EXPECT_THROW(drape_options(simulation), InvalidInput);
}

}  // namespace
}  // namespace loosefit::pipeline
