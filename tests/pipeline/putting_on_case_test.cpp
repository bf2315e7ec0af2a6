#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "loosefit/base/text.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/prepare_case.h"

namespace loosefit::pipeline {
namespace {

/// What is said of a garment in this cloth on a woman, before it is draped.
PuttingOn on_woman(const std::string& kind, const std::string& cloth, const std::string& fit = "") {
  Progress silent;
  const std::string text = fmt::format(
      "[body]\nsex = \"female\"\nage = 30\nheight = 1.68\n"
      "measurements = {{ chest = 0.92, waist = 0.74, hip = 0.98 }}\n"
      "[garment]\npattern = \"{}\"\nfit = {{ {} }}\n[material]\nname = \"{}\"\n"
      "[simulation]\nedge_length = 0.04\n",
      kind, fit, cloth);
  return prepare_case(io::parse_scenario(text, "case.toml"), silent).putting_on;
}

bool says(const PuttingOn& on, const std::string& part) {
  return join(on.reasons, "; ").find(part) != std::string::npos;
}

TEST(PuttingOnCase, AWovenNeckThatIsNarrowerThanTheHead) {
  std::mt19937 draw(14);
  std::uniform_real_distribution<double> ease(-0.2, 0.05);
  for (const std::string cloth : {"wool-measured", "cotton-shirting", "wool-tropical"}) {
    const PuttingOn on = on_woman("t-shirt", cloth, fmt::format("neck_ease = {:.3f}", ease(draw)));
    EXPECT_EQ(on.possible, false) << cloth;
    EXPECT_TRUE(says(on, "the neck opens to")) << join(on.reasons, "; ");
    EXPECT_TRUE(says(on, "(the head)")) << join(on.reasons, "; ");
    EXPECT_FALSE(says(on, "the hem")) << join(on.reasons, "; ");
  }
  EXPECT_EQ(on_woman("t-shirt", "cotton-shirting", "neck_ease = 0.5").possible, true);
}

TEST(PuttingOnCase, ACrewNeckOfAKnitPassesByItsStretch) {
  const PuttingOn jersey = on_woman("t-shirt", "cotton-jersey");
  EXPECT_EQ(jersey.possible, true) << join(jersey.reasons, "; ");
  EXPECT_EQ(on_woman("t-shirt", "cotton-jersey", "neck_ease = -0.15").possible, false);
}

TEST(PuttingOnCase, AWovenCuffThatIsNarrowerThanTheHand) {
  const PuttingOn narrow =
      on_woman("long-sleeve-shirt", "cotton-shirting", "wrist = 0.1, neck_ease = 0.5");
  EXPECT_EQ(narrow.possible, false);
  EXPECT_TRUE(says(narrow, "the left cuff")) << join(narrow.reasons, "; ");
  EXPECT_TRUE(says(narrow, "(the right hand)")) << join(narrow.reasons, "; ");
  EXPECT_FALSE(says(narrow, "the neck"));
  EXPECT_EQ(
      on_woman("long-sleeve-shirt", "cotton-shirting", "wrist = 0.6, neck_ease = 0.5").possible,
      true);
}

TEST(PuttingOnCase, LegsOverTheHeelAndAnElasticWaistOverTheHips) {
  EXPECT_EQ(on_woman("leggings", "compression-knit").possible, true);
  const PuttingOn woven = on_woman("leggings", "cotton-shirting");
  EXPECT_EQ(woven.possible, false);
  EXPECT_TRUE(says(woven, "(the left heel and instep)")) << join(woven.reasons, "; ");
  // Its waistband is softer than its fabric: it gives until the fabric lies flat.
  const PuttingOn trousers = on_woman("trousers", "cotton-shirting");
  EXPECT_EQ(trousers.possible, true) << join(trousers.reasons, "; ");
  const PuttingOn stiff = on_woman("trousers", "cotton-shirting", "waistband_stiffness = 2");
  EXPECT_EQ(stiff.possible, false);
  EXPECT_TRUE(says(stiff, "the waist opens to")) << join(stiff.reasons, "; ");
}

}  // namespace
}  // namespace loosefit::pipeline
