#include "loosefit/kinds/shirt/shirt_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/kinds/shirt/sleeve_ease.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

ShirtFit banded() {
  ShirtFit fit = usual_shirt_fit();
  fit.neckband = 0.02;
  fit.neckband_stretch = 0.12;
  fit.cuff = 0.05;
  fit.cuff_stretch = 0.2;
  return fit;
}

std::vector<std::string> size_names() { return {"child-142", "women-36", "women-44", "men-XL"}; }

double edge_length(const pattern::Pattern& p, const std::string& panel, const std::string& edge) {
  const pattern::Panel& piece = p.panels[p.find_part(panel)];
  return pattern::EdgePath(piece, pattern::find_edge_part(piece, edge)).length();
}

TEST(ShirtBands, StripsAreShorterThanTheirEdgesByTheAskedStretch) {
  for (const std::string& name : size_names()) {
    SCOPED_TRACE(name);
    const ShirtMeasures m = support::shirt_size(name).body;
    const ShirtFit fit = banded();
    const pattern::Pattern shirt = draft_shirt(m, fit);
    ASSERT_EQ(shirt.panels.size(), 12u);
    EXPECT_EQ(shirt.stitches.size(), 12u + 4u + 8u);
    for (const std::string half : {"front", "back"}) {
      const double neck = edge_length(shirt, half, "neck");
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "seam"), 0.88 * neck, 1e-9);
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "rim"), 0.88 * neck, 1e-9);
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "end_L"), 0.02, 1e-12);
      for (const std::string s : {"L_", "R_"}) {
        EXPECT_NEAR(edge_length(shirt, "cuff_" + s + half, "seam"),
                    0.8 * edge_length(shirt, "sleeve_" + s + half, "cuff"), 1e-9);
        EXPECT_NEAR(edge_length(shirt, "cuff_" + s + half, "under"), 0.05, 1e-12);
      }
    }
    // Ends of strips are sewn to ends: a corner of three pieces is one point.
    const garment::Garment sewn = garment::assemble(shirt, 0.02, fabric::Material{});
    const auto* shoulder = sewn.find_part("front", "shoulder_L");
    const auto* end = sewn.find_part("neckband_back", "end_L");
    ASSERT_TRUE(shoulder && end);
    int shared = 0;
    for (const int v : end->vertices)
      shared += v == shoulder->vertices.front() || v == shoulder->vertices.back();
    EXPECT_EQ(shared, 1);
  }
}

// Without stretch it is the part of the shirt that is cut away for it: as long as the neckline at
// its seam, as long as the neck base at its rim, with no corner anywhere.
TEST(ShirtBands, NeckbandWithoutStretchIsCutAsTheNecklineIs) {
  for (const std::string& name : size_names()) {
    SCOPED_TRACE(name);
    const ShirtMeasures m = support::shirt_size(name).body;
    ShirtFit fit = usual_shirt_fit();
    const pattern::Pattern plain = draft_shirt(m, fit);
    fit.neckband = 0.02;
    const pattern::Pattern shirt = draft_shirt(m, fit);
    double rim = 0;
    for (const std::string half : {"front", "back"}) {
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "seam"), edge_length(shirt, half, "neck"),
                  1e-9);
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "rim"), edge_length(plain, half, "neck"),
                  1e-9);
      EXPECT_NEAR(edge_length(shirt, "neckband_" + half, "end_L"), 0.02, 1e-9);
      rim += edge_length(shirt, "neckband_" + half, "rim");
    }
    EXPECT_NEAR(rim, (1 + fit.neck_ease) * m.neck, 1e-4);
  }
}

// The hem of the sleeve is that of its cuff: its ease as asked, and where it ends without one.
TEST(ShirtBands, CuffsAreWithinTheSleeve) {
  for (const double length : {1.0, 0.5}) {
    ShirtFit fit = banded();
    fit.sleeve_length = length;
    if (length < 1) fit.cap_ratio = 0.55;
    const ShirtMeasures m;
    const pattern::Pattern with = draft_shirt(m, fit);
    EXPECT_NEAR(shirt_girths(with, m.hps_to_waist).at("wrist"),
                (1 + fit.wrist) * arm_girth_at(m, length - 0.05 / m.arm_length), 1e-9);
    const std::vector<FitLevel> levels = shirt_levels(with, named(m), named(fit));
    EXPECT_NEAR(levels.back().garment / levels.back().body.value() - 1, fit.wrist, 1e-9);
    fit.cuff = 0;
    const pattern::Pattern without = draft_shirt(m, fit);
    EXPECT_NEAR(edge_length(with, "sleeve_L_front", "top") + 0.05,
                edge_length(without, "sleeve_L_front", "top"), 1e-9);
    // Stations reach down to the rim.
    fit.cuff = 0.05;
    const std::vector<FitStation> stations = shirt_stations(with, named(m), named(fit));
    double last = 0;
    for (const FitStation& s : stations)
      if (s.limb == "arm") last = std::max(last, s.along);
    EXPECT_GT(last, length * m.arm_length - kStationStep - 1e-9);
  }
}

// A neckband ends where the neck of a shirt without one does.
TEST(ShirtBands, NeckbandIsSewnOnAsFarOutAsItIsWide) {
  for (const std::string& name : size_names()) {
    const ShirtMeasures m = support::shirt_size(name).body;
    ShirtFit fit;
    const NeckOpening plain = fit_neck(m, fit);
    fit.neckband = 0.025;
    const NeckOpening wide = fit_neck(m, fit);
    EXPECT_NEAR(std::hypot(wide.half_width - plain.half_width, wide.shoulder), 0.025, 1e-12);
    EXPECT_NEAR(std::atan2(wide.shoulder, wide.half_width - plain.half_width), seam_slope(m),
                1e-9);
    EXPECT_NEAR(wide.drop_front - plain.drop_front, 0.025, 1e-12);
    EXPECT_NEAR(wide.drop_back - plain.drop_back, 0.025, 1e-12);
    // The shoulder point stays.
    const Vec2 a = draft_torso_half(m, fit, 0.16, true, 0).shoulder.end();
    fit.neckband = 0;
    EXPECT_NEAR((draft_torso_half(m, fit, 0.16, true, 0).shoulder.end() - a).norm(), 0, 1e-9);
  }
}

// A neck point of less than 180 degrees of cloth stands up as a spike.
TEST(ShirtBands, NecklineRunsSmoothlyAcrossTheShoulderSeam) {
  for (const std::string& name : support::shirt_size_names())
    for (const double band : {0.0, 0.02})
      for (const bool front : {true, false}) {
        const ShirtMeasures m = support::shirt_size(name).body;
        ShirtFit fit;
        fit.neckband = band;
        const TorsoHalf half = draft_torso_half(m, fit, 0.16, front, 0);
        const Vec2 along = half.shoulder.end() - half.shoulder.start;
        const Vec2 last = half.neck.end() - half.neck.curves.back().control[1];
        EXPECT_NEAR((half.neck.end() - half.shoulder.start).norm(), 0, 1e-12);
        EXPECT_GT(last.norm(), 0.003);
        EXPECT_NEAR(along.normalized().dot(last.normalized()), 0, 1e-9) << name;
      }
}

TEST(ShirtBands, HemsAreNotedOnFreeEdgesOnly) {
  ShirtFit fit = usual_shirt_fit();
  fit.edge_finish = 0.012;
  const auto finished = [](const pattern::Pattern& shirt) {
    std::set<std::string> edges;
    for (const pattern::Panel& panel : shirt.panels)
      for (const pattern::PanelEdge& edge : panel.edges)
        if (edge.finish == 0.012) edges.insert(panel.part + "." + edge.part);
    return edges;
  };
  EXPECT_EQ(finished(draft_shirt({}, fit)),
            (std::set<std::string>{"front.neck", "back.neck", "front.hem", "back.hem",
                                   "sleeve_L_front.cuff", "sleeve_L_back.cuff",
                                   "sleeve_R_front.cuff", "sleeve_R_back.cuff"}));
  fit.neckband = 0.02;
  fit.cuff = 0.05;
  EXPECT_EQ(finished(draft_shirt({}, fit)), (std::set<std::string>{"front.hem", "back.hem"}));
}

TEST(ShirtBands, WidthsAndStretchesOutOfRangeAreNamed) {
  const auto message = [](double ShirtFit::*field, double value) -> std::string {
    ShirtFit fit = usual_shirt_fit();
    fit.*field = value;
    try {
      draft_shirt({}, fit);
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message(&ShirtFit::neckband, 0.002),
            "fit.neckband_width: found 0.002 m, expected 0.005 to "
            "0.12 m");
  EXPECT_EQ(message(&ShirtFit::cuff, -0.01),
            "fit.cuff_width: found -0.01 m, expected 0.005 to 0.12 m");
  EXPECT_EQ(message(&ShirtFit::cuff_stretch, 0.7),
            "fit.cuff_stretch: found 0.7, expected 0 to 0.6");
  EXPECT_EQ(message(&ShirtFit::edge_finish, 0.2),
            "fit.edge_finish: found 0.2 m, expected 0 to "
            "0.05 m");
}

TEST(ShirtBands, SizesTakeBandsToo) {
  const GarmentKind& kind = garment_kind("t-shirt");
  const DraftedGarment plain = kind.draft({{}, "men-M", {}, {}});
  const DraftedGarment made = kind.draft(
      {{}, "men-M", {{"neckband_width", 0.02}, {"edge_finish", 0.02}, {"chest", 9}}, {}});
  EXPECT_EQ(made.pattern.panels.size(), 8u);
  EXPECT_GE(made.pattern.find_part("neckband_front"), 0);
  const auto chest = [&](const DraftedGarment& g) {
    return shirt_girths(g.pattern, 0.4).at("chest");
  };
  EXPECT_NEAR(chest(made), chest(plain), 1e-9);
}

struct Wearer {
  const char* name;
  double sex, age;
};
void PrintTo(const Wearer& w, std::ostream* out) { *out << w.name; }
class BandsOnBody : public ::testing::TestWithParam<std::tuple<Wearer, double>> {};

TEST_P(BandsOnBody, AreLaidWithoutCuts) {
  const auto& [wearer, length] = GetParam();
  body::BodyParameters parameters = support::adult_parameters();
  if (wearer.age < 18) parameters = support::slim_child_parameters();
  parameters.sex = wearer.sex;
  const body::Body body = support::standing(parameters, 30);
  ShirtFit fit = support::usual_fit(length < 1 ? "t-shirt" : "long-sleeve-shirt");
  fit.neckband = 0.02;
  fit.cuff = length < 1 ? 0.015 : 0.05;
  const std::string kind = length < 1 ? "t-shirt" : "long-sleeve-shirt";
  NamedValues measures;
  for (const KindMeasure& m : garment_kind(kind).measures)
    if (const auto found = body.measured.find(m.of_body); found != body.measured.end())
      measures[m.name] = found->second;
  const pattern::Pattern pattern = garment_kind(kind).draft({measures, {}, named(fit), {}}).pattern;
  for (const double edge : {0.03, 0.018}) {
    const garment::Garment shirt = garment::assemble(pattern, edge, fabric::Material{});
    const std::vector<Vec3> x = support::dress_shirt(shirt, body);
    EXPECT_TRUE(geometry::self_intersections(x, shirt.triangles).empty());
    // Outside the body, as other shirts: but for a few millimetres at a throat.
    const geometry::ClosestPointTree tree(body.surface);
    double deepest = 1;
    for (const Vec3& p : x) deepest = std::min(deepest, tree.signed_distance(p));
    EXPECT_GT(deepest, -0.005) << edge;
  }
}

INSTANTIATE_TEST_SUITE_P(Wearers, BandsOnBody,
                         ::testing::Combine(::testing::Values(Wearer{"woman", 0, 25},
                                                              Wearer{"man", 1, 25},
                                                              Wearer{"child", 0.4, 10}),
                                            ::testing::Values(1.0, 0.38)));

}  // namespace
}  // namespace loosefit::kinds
