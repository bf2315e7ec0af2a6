#include "loosefit/pattern/known_one_shoulder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/unsewn_garments.h"

// Tops that hang on one shoulder.
namespace loosefit::pattern {
namespace {

using namespace testing_support;

/// As a front for the left shoulder: hem, side, armhole, shoulder, slant, side.
std::vector<CurveChain> outline() {
  return {straight({-0.28, 0}, {0.28, 0}),
          straight({0.28, 0}, {0.26, 0.40}),
          curved({0.26, 0.40}, {0.22, 0.40}, {0.17, 0.46}, {0.17, 0.60}),
          straight({0.17, 0.60}, {0.08, 0.63}),
          curved({0.08, 0.63}, {-0.03, 0.52}, {-0.15, 0.44}, {-0.26, 0.40}),
          straight({-0.26, 0.40}, {-0.28, 0})};
}

Pattern one_shoulder(bool left) {
  Pattern pattern;
  pattern.panels = {left ? numbered_panel("FRONT", outline()) : mirrored_panel("FRONT", outline()),
                    left ? mirrored_panel("BACK", outline()) : numbered_panel("BACK", outline())};
  return pattern;
}

/// Whether both sides of a seam are as long and no open edge is in it.
double longest_difference(const Pattern& pattern, const KnownGarment& known) {
  double worst = 0;
  for (const ChainSeam& seam : known.seams)
    worst = std::max(
        worst, std::abs(chain_length(pattern, seam.first) - chain_length(pattern, seam.second)));
  return worst;
}

TEST(KnownOneShoulder, SidesAndTheShoulderAreSewnAndTheRestStaysOpen) {
  for (const bool left : {true, false}) {
    const Pattern pattern = one_shoulder(left);
    const KnownGarment known = know_garment(pattern);
    EXPECT_EQ(known.kind, "one-shoulder top");
    EXPECT_TRUE(known.certain()) << known.doubts.front();
    ASSERT_EQ(known.seams.size(), 3u);
    EXPECT_LT(longest_difference(pattern, known), 1e-9);
    EXPECT_EQ(known.seams[2].name, left ? "shoulder_L" : "shoulder_R");
    EXPECT_EQ(known.seams[0].name, left ? "side_L" : "side_R");
    EXPECT_NEAR(chain_length(pattern, known.seams[2].first), std::hypot(0.09, 0.03), 1e-9);
  }
}

TEST(KnownOneShoulder, FrontAndBackOfOneOutlineThatWouldHangOnBothShouldersAreNone) {
  Pattern pattern = one_shoulder(true);
  pattern.panels[1] = numbered_panel("BACK", outline());
  EXPECT_TRUE(know_garment(pattern).kind.empty());
}

TEST(KnownOneShoulder, SixSidedPiecesOfOneHandDoNotHideASkirt) {
  Pattern pattern = unsewn_skirt();
  for (const char* name : {"pouch", "pouch_2"})
    pattern.panels.push_back(numbered_panel(name, outline()));
  const KnownGarment known = know_garment(pattern);
  EXPECT_EQ(known.kind, "skirt");
  EXPECT_FALSE(known.certain()) << "they are no part of it";
}

TEST(KnownOneShoulder, AHalfOfAnOrdinaryFrontIsNone) {
  Panel half =
      numbered_panel("FRONT", {straight({0, 0}, {0.27, 0}), straight({0.27, 0}, {0.25, 0.38}),
                               curved({0.25, 0.38}, {0.20, 0.38}, {0.17, 0.46}, {0.18, 0.56}),
                               straight({0.18, 0.56}, {0.07, 0.60}),
                               curved({0.07, 0.60}, {0.065, 0.55}, {0.04, 0.50}, {0, 0.50}),
                               straight({0, 0.50}, {0, 0})});
  EXPECT_FALSE(as_one_shoulder(outline_sections(half)));
  EXPECT_TRUE(as_one_shoulder(outline_sections(one_shoulder(true).panels[0])));
}

TEST(KnownOneShoulder, HalvesOfAHalterOnAnUnmarkedFoldAreNotSewnAlongIt) {
  const auto half = [](double neck) {
    return std::vector<CurveChain>{
        straight({0, 0}, {0.27, 0}),
        straight({0.27, 0}, {0.27, 0.36}),
        curved({0.27, 0.36}, {0.17, 0.37}, {0.11, 0.42}, {0.10, 0.60}),
        straight({0.10, 0.60}, {0.06, 0.61}),
        curved({0.06, 0.61}, {0.055, neck + 0.03}, {0.03, neck}, {0, neck}),
        straight({0, neck}, {0, 0})};
  };
  Pattern pattern;
  pattern.panels = {numbered_panel("FRONT", half(0.500)), mirrored_panel("BACK", half(0.505))};
  EXPECT_NE(know_garment(pattern).kind, "one-shoulder top");
}

TEST(KnownOneShoulder, ItIsPlacedWithTheShoulderOnItsSide) {
  for (const bool left : {true, false}) {
    const Pattern pattern = from_nothing(one_shoulder(left));
    for (const Panel& panel : pattern.panels) {
      const auto highest =
          std::ranges::max_element(panel.vertices, {}, [](const Vec2& v) { return v.y(); });
      const Vec3 at = panel.rotation * Vec3(highest->x(), highest->y(), 0) + panel.translation;
      EXPECT_GT(at.x() * (left ? 1 : -1), 0.05) << panel.name;
      // By its armhole a wearer is asked whether it is on.
      for (const PanelEdge& edge : panel.edges) {
        const bool armhole = edge.curves.front().kind == EdgeCurve::Kind::cubic &&
                             edge.name == (&panel == &pattern.panels[left ? 0 : 1] ? "e3" : "e4");
        EXPECT_EQ(edge.label, !armhole ? "" : left ? "left_armhole" : "right_armhole") << edge.name;
      }
    }
  }
}

}  // namespace
}  // namespace loosefit::pattern
