#include "loosefit/pattern/skirt_below.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/unsewn_garments.h"

// Dresses that are drawn as a bodice and a skirt.
namespace loosefit::pattern {
namespace {

using namespace testing_support;

/// \param gathered the skirt's waist over the bodice's lower edge
Pattern bodice_and_skirt(double gathered = 1, bool sleeves = false) {
  Pattern pattern = unsewn_tshirt(0.5, 0.45);
  if (!sleeves) pattern.panels.resize(2);
  pattern.panels[0].name = "FRONT BODICE", pattern.panels[1].name = "BACK BODICE";
  const Pattern skirt = unsewn_skirt(gathered * 1.0, gathered * 1.5);
  for (const Panel& panel : skirt.panels) pattern.panels.push_back(panel);
  (pattern.panels.end() - 2)->name = "FRONT SKIRT", pattern.panels.back().name = "BACK SKIRT";
  return pattern;
}

const ChainSeam* seam(const KnownGarment& known, const std::string& name) {
  const auto at = std::ranges::find(known.seams, name, &ChainSeam::name);
  return at == known.seams.end() ? nullptr : &*at;
}

TEST(SkirtBelow, TheSkirtIsSewnToTheBodiceAtTheWaist) {
  for (const bool sleeves : {false, true}) {
    const Pattern pattern = bodice_and_skirt(1, sleeves);
    const int skirt = sleeves ? 4 : 2;
    const KnownGarment known = know_garment(pattern);
    EXPECT_EQ(known.kind, sleeves ? "t-shirt with a skirt" : "tank top with a skirt");
    EXPECT_TRUE(known.certain()) << known.doubts.front();
    const ChainSeam* front = seam(known, "waist_front");
    ASSERT_TRUE(front && seam(known, "waist_back") && seam(known, "skirt_side_L"));
    EXPECT_EQ(front->first.front().panel, 0);
    EXPECT_EQ(front->second.front().panel, skirt);
    EXPECT_NEAR(chain_length(pattern, front->first), chain_length(pattern, front->second), 1e-6);
  }
}

TEST(SkirtBelow, OneThatIsGatheredIsProposedAndAsked) {
  const KnownGarment known = know_garment(bodice_and_skirt(1.6));
  EXPECT_TRUE(seam(known, "waist_front"));
  EXPECT_FALSE(known.certain());
}

TEST(SkirtBelow, ATopThatEndsBelowTheWaistIsNotSewnToASkirtUnasked) {
  Pattern pattern = unsewn_tshirt(0.5, 0.66);
  pattern.panels.resize(2);
  EXPECT_TRUE(know_garment(pattern).certain());
  const Pattern skirt = unsewn_skirt(1.0, 1.5);
  for (const Panel& panel : skirt.panels) pattern.panels.push_back(panel);
  pattern.panels[2].name = "FRONT SKIRT", pattern.panels[3].name = "BACK SKIRT";
  const KnownGarment known = know_garment(pattern);
  EXPECT_TRUE(seam(known, "waist_front")) << "it is proposed";
  EXPECT_FALSE(known.certain());
}

TEST(SkirtBelow, OneThatIsTooNarrowOrManyTimesAsWideIsNotSewnThere) {
  for (const double gathered : {0.7, 3.0}) {
    const KnownGarment known = know_garment(bodice_and_skirt(gathered));
    EXPECT_EQ(known.kind, "tank top");
    EXPECT_FALSE(seam(known, "waist_front"));
    EXPECT_FALSE(known.certain());
  }
}

TEST(SkirtBelow, ItHangsBelowTheBodice) {
  const Pattern pattern = from_nothing(bodice_and_skirt());
  for (int p = 0; p < 2; ++p) {
    const Panel &bodice = pattern.panels[p], &skirt = pattern.panels[p + 2];
    EXPECT_NEAR(bodice.rotation.col(2).y(), skirt.rotation.col(2).y(), 1e-9);
    // The skirt's waist, 0.55 m above its hem, is where the lower edge of the bodice is.
    EXPECT_NEAR(skirt.translation.z() + 0.55, bodice.translation.z(), 1e-6);
  }
}

}  // namespace
}  // namespace loosefit::pattern
