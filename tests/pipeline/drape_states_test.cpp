#include "loosefit/pipeline/drape_states.h"

#include <gtest/gtest.h>

#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

/// A tank top in two postures besides the first, put on twice, on a mesh that settles in seconds.
CaseResult worn_on(int threads, const std::string& postures) {
  const std::string text =
      "[garment]\npattern = \"tank-top\"\n[postures]\nlist = [\"standing\", " + postures +
      "]\n[donning]\nrepeats = 2\nmovements = [\"breath\"]\n" +
      "[simulation]\nedge_length = 0.05\nthreads = " + std::to_string(threads) + "\n";
  Progress silent;
  RunOptions options;
  options.only_drape = true;
  return run_case(io::parse_scenario(text, "case.toml"), silent, options);
}

TEST(DrapeStates, SameBitsSideBySideAsOneByOneInAnotherOrderOfPostures) {
  const CaseResult alone = worn_on(1, "\"forward-bend-30\", \"forward-bend-15\"");
  const CaseResult beside = worn_on(2, "\"forward-bend-15\", \"forward-bend-30\"");
  ASSERT_EQ(alone.wear.states.size(), 5u);
  ASSERT_EQ(beside.wear.states.size(), 5u);
  // Postures of the first donning, then each further donning with its reference posture first.
  const StateId order[] = {{1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
  const int in_other[] = {1, 0, 2, 4, 3};
  for (int k = 0; k < 5; ++k) {
    const CaseState& state = alone.wear.states[k];
    EXPECT_EQ(state.id, order[k]);
    EXPECT_GT(state.seconds, 0);
    const CaseState& same = beside.wear.states[in_other[k]];
    EXPECT_EQ(state.counts(), same.counts()) << state.certificate().stop_reason;
    EXPECT_EQ(state.name, same.name);
    EXPECT_EQ(state.drape().positions, same.drape().positions) << state.name;
  }
  // As when the run is read again: the person has not been asked for anything yet.
  Progress silent;
  const CaseBody body = make_body(alone.scenario.body);
  EXPECT_EQ(body.body->surface.vertices, alone.body_in(0)->surface.vertices);
  const std::vector<PosedWearer> again =
      pose_wearers(body, plan_wear(alone.scenario).postures, silent);
  for (int p = 1; p < 3; ++p)
    EXPECT_EQ(again[p].body->surface.vertices, alone.body_in(p)->surface.vertices) << p;
  EXPECT_NE(alone.wear.states[0].drape().positions, alone.wear.states[3].drape().positions)
      << "another donning";
}

/// A tank top that is put on so: its last drape.
std::vector<Vec3> put_on_so(const std::string& donning) {
  const std::string text = donning +
                           "[garment]\npattern = \"tank-top\"\n[body]\nposture = \"a-pose\"\n"
                           "[simulation]\nedge_length = 0.05\n";
  Progress silent;
  RunOptions options;
  options.only_drape = true;
  const CaseResult result = run_case(io::parse_scenario(text, "case.toml"), silent, options);
  EXPECT_TRUE(result.certificate().holds()) << donning;
  return result.wear.states.empty() ? result.studied().drape.positions
                                    : result.wear.states.back().drape().positions;
}

TEST(DrapeStates, ADrawnFirstDonningIsDrapedAsADrawnSecondOne) {
  // Of the same draws, but for the order and size of movements.
  const std::string still = "movements = [\"breath\"]\nmovement_spread = 0\nseed = 3\n";
  const auto first = put_on_so("[donning]\nfirst = \"drawn\"\n" + still);
  EXPECT_EQ(first, put_on_so("[donning]\nrepeats = 2\n" + still));
  EXPECT_NE(first, put_on_so("[donning]\nmovements = [\"breath\"]\n"));
}

}  // namespace
}  // namespace loosefit::pipeline
