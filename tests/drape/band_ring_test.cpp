#include "loosefit/drape/band_ring.h"

#include <gtest/gtest.h>

#include <set>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/phases/close_seams.h"
#include "loosefit/drape/worn.h"
#include "loosefit/garment/assemble.h"
#include "support/body_fixture.h"
#include "support/shirt_on_body.h"
#include "support/unsewn_garments.h"
#include "support/worn_and_settled.h"

namespace loosefit::drape {
namespace {

using testing_support::from_nothing;
using testing_support::unsewn_trousers;
using testing_support::unsewn_tshirt;
using testing_support::upright_strip;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

pattern::Pattern banded_tshirt() {
  pattern::Pattern pattern = unsewn_tshirt(0.56 * woman()->measured.at("chest"));
  const double wrist = 2 * 0.9 * 0.155;
  pattern.panels.push_back(upright_strip("neckband", 0.39, 0.03));
  pattern.panels.push_back(upright_strip("cuff_left", 0.85 * wrist, 0.05));
  pattern.panels.push_back(upright_strip("cuff_right", 0.85 * wrist, 0.05));
  return pattern;
}

pattern::Pattern banded_trousers() {
  const auto& m = woman()->measured;
  pattern::Pattern pattern = unsewn_trousers(1.04 * m.at("waist"), 1.06 * m.at("hip"),
                                             m.at("waist_level") - m.at("crotch_height") + 0.02,
                                             m.at("waist_level") - 0.12);
  pattern.panels.push_back(upright_strip("waistband", 1.02 * m.at("waist"), 0.04));
  return pattern;
}

pattern::Pattern bound_tank_top() {
  pattern::Pattern pattern = unsewn_tshirt(0.56 * woman()->measured.at("chest"));
  pattern.panels.resize(2);
  pattern.panels.push_back(upright_strip("neckband", 0.39, 0.03));
  pattern.panels.push_back(upright_strip("armhole_left", 0.36, 0.03));
  pattern.panels.push_back(upright_strip("armhole_right", 0.36, 0.03));
  return pattern;
}

int panel_called(const garment::Garment& g, const std::string& name) {
  const auto& names = g.panel_names;
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The edge of an upright strip at u = 0 or at u = width, whichever is free, in order.
std::vector<int> free_edge(const garment::OpenSeams& open, int panel) {
  const garment::Garment& g = open.garment;
  std::set<int> sewn;  // to another panel
  for (const auto& of : open.partners)
    for (int v : of)
      for (int w : of)
        if (g.vertex_panel[v] != g.vertex_panel[w]) sewn.insert(v);
  std::map<double, int> low, high;
  double width = 0;
  for (int v = 0; v < g.vertex_count; ++v)
    if (g.vertex_panel[v] == panel) width = std::max(width, g.vertex_uv[v][0]);
  bool low_sewn = false;
  for (int v = 0; v < g.vertex_count; ++v) {
    if (g.vertex_panel[v] != panel) continue;
    const auto& uv = g.vertex_uv[v];
    if (uv[0] < 1e-9) {
      low[uv[1]] = v;
      low_sewn = low_sewn || sewn.count(v);
    }
    if (uv[0] > width - 1e-9) high[uv[1]] = v;
  }
  std::vector<int> loop;
  for (const auto& [s, v] : low_sewn ? high : low) loop.push_back(v);
  return loop;
}

void expect_rings(const pattern::Pattern& pattern,
                  const std::vector<std::pair<std::string, LimbNumbers>>& expected) {
  const garment::Garment sewn = garment::assemble(pattern, 0.02, fabric::Material{});
  const garment::OpenSeams open = garment::open_seams(sewn);
  const ArrangedPanels panels = arrange_panels(sewn, open, pattern, woman());
  for (const auto& [name, round] : expected) {
    SCOPED_TRACE(name);
    const int panel = panel_called(open.garment, name);
    EXPECT_TRUE(BandRing::find(open, panel));
    EXPECT_TRUE(panels.outside[panel].isZero());
    const std::vector<int> edge = free_edge(open, panel);
    ASSERT_GT(edge.size(), 5u);
    EXPECT_EQ(limbs_through_openings(edge, panels.x, limb_lines(woman().body())), round);
    for (int v = 0; v < open.garment.vertex_count; ++v) {
      if (open.garment.vertex_panel[v] != panel) continue;
      EXPECT_GT(woman().tree().signed_distance(panels.x[v]), 0.005) << v;
    }
    // It lies in the direction of what it is sewn to, seen from the limb: fronts and backs are flat
    // yet, so that angles differ.
    Vec3 middle = Vec3::Zero();
    for (int v : edge) middle += panels.x[v] / static_cast<double>(edge.size());
    double sum = 0, count = 0;
    for (const auto& of : open.partners)
      for (int v : of)
        for (int w : of) {
          if (open.garment.vertex_panel[v] != panel || open.garment.vertex_panel[w] == panel)
            continue;
          Vec3 a = panels.x[v] - middle, b = panels.x[w] - middle;
          if (round == kRoundNeck || round == kRoundTrunk) a.z() = b.z() = 0;
          const double cosine = a.normalized().dot(b.normalized());
          EXPECT_GT(cosine, -0.7) << v;
          sum += cosine, ++count;
        }
    EXPECT_GT(sum / count, 0.6);
  }
  const ClosedSeams closed = close_seams(sewn, open, panels, woman(), 3);
  EXPECT_EQ(closed.cuts, 0);
  EXPECT_FALSE(closed.in_limb);
  EXPECT_LT(closed.gap, 0.02);
}

TEST(BandRing, BandsGoRoundNeckAndArmsWhereTheyAreSewnOn) {
  expect_rings(from_nothing(banded_tshirt()), {{"neckband", kRoundNeck},
                                               {"cuff_left", round_limb(kLeftArm)},
                                               {"cuff_right", round_limb(kRightArm)}});
}

TEST(BandRing, AWaistbandGoesRoundTheTrunk) {
  expect_rings(from_nothing(banded_trousers()), {{"waistband", kRoundTrunk}});
}

TEST(BandRing, BindingsOfATankTopGoRoundTheArms) {
  expect_rings(from_nothing(bound_tank_top()), {{"neckband", kRoundNeck},
                                                {"armhole_left", round_limb(kLeftArm)},
                                                {"armhole_right", round_limb(kRightArm)}});
}

TEST(BandRing, FindsNoBandInSleevesFrontsOrLegs) {
  for (const bool trousers : {false, true}) {
    const pattern::Pattern pattern = from_nothing(trousers ? unsewn_trousers() : unsewn_tshirt());
    const garment::Garment sewn = garment::assemble(pattern, 0.03, fabric::Material{});
    const garment::OpenSeams open = garment::open_seams(sewn);
    for (int k = 0; k < 4; ++k) EXPECT_FALSE(BandRing::find(open, k)) << k;
  }
}

TEST(BandRing, ABandedGarmentIsWornAndSettled) {
  for (const pattern::Pattern& unsewn : {banded_tshirt(), banded_trousers(), bound_tank_top()}) {
    SCOPED_TRACE(unsewn.name);
    const pattern::Pattern pattern = from_nothing(unsewn);
    testing_support::expect_worn_and_settled(pattern, 0.025, woman());
  }
}

}  // namespace
}  // namespace loosefit::drape
