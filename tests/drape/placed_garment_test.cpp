#include <gtest/gtest.h>

#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/phases/sew_on.h"
#include "loosefit/dress/dress_layers.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/registry.h"
#include "support/shirt_on_body.h"
#include "support/simple_patterns.h"

namespace loosefit::drape {
namespace {

using namespace testing_support;

/// A sleeveless top of two equal panels, sewn at the sides below the arms and on the shoulders.
pattern::Pattern tank_top(double half_width, double front_y, double back_y, double hem_height) {
  const double w = half_width, top = 0.58, under = 0.33, neck = 0.10, slope = 0.03;
  const std::vector<Vec2> outline = {
      {-w, 0},     {w, 0},          {w, under},   {0.75 * w, top - slope},
      {neck, top}, {0, top - 0.10}, {-neck, top}, {-0.75 * w, top - slope},
      {-w, under}};
  pattern::Pattern pattern;
  pattern.panels = {polygon_panel("front", outline), polygon_panel("back", outline)};
  Mat3 front, back;
  front.col(0) = Vec3::UnitX(), front.col(1) = Vec3::UnitZ(), front.col(2) = -Vec3::UnitY();
  back.col(0) = -Vec3::UnitX(), back.col(1) = Vec3::UnitZ(), back.col(2) = Vec3::UnitY();
  pattern.panels[0].rotation = front, pattern.panels[1].rotation = back;
  pattern.panels[0].translation = Vec3(0, front_y, hem_height);
  pattern.panels[1].translation = Vec3(0, back_y, hem_height);
  // Edge 1: left side of the front, sewn to the right edge of the back, which is turned round.
  pattern.stitches = {stitch(0, 1, 1, 8), stitch(0, 8, 1, 1), stitch(0, 3, 1, 6),
                      stitch(0, 6, 1, 3)};
  return pattern;
}

TEST(PlacedGarment, SettlesFromPanelsThatCrossEachOtherWithinTheTorso) {
  const body::BodyParameters wearer = support::adult_parameters();
  const body::Body body = support::standing(wearer, 40);
  const Vec3 shoulder = body.joints.at("shoulder_L");
  // Both panels upright in the middle of the trunk, the back 2 cm before the front.
  const pattern::Pattern pattern =
      tank_top(0.27, shoulder.y() + 0.01, shoulder.y() - 0.01, shoulder.z() + 0.07 - 0.58);
  fabric::Material material;
  material.bending_warp = material.bending_weft = 5e-6;
  const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, 0.03, material);
  Progress silent;
  DrapeOptions options;
  options.time_budget = 60;
  const Drape d = drape_garment(
      garment, material, [&](double) { return body; }, options, silent);
  EXPECT_TRUE(d.certificate.settled())
      << d.certificate.stop_reason << (d.unsettled ? d.unsettled->why : "");
  EXPECT_TRUE(geometry::self_intersections(d.positions, garment.finest().triangles).empty());
  // It hangs round the trunk: front panel before the body, back panel behind it.
  const garment::Garment& g = garment.finest();
  double front = 0, back = 0;
  for (int v = 0; v < g.vertex_count; ++v)
    if (std::abs(g.vertex_uv[v].x()) < 0.1 && g.vertex_uv[v].y() < 0.4)
      (g.panel_names[g.vertex_panel[v]] == "front" ? front : back) += d.positions[v].y();
  EXPECT_LT(front, -0.05);
  EXPECT_GT(back, 0.05);
}

TEST(PlacedGarment, AHoodieIsSewnRoundATShirt) {
  const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  const auto drafted = [&](const char* name) {
    const kinds::GarmentKind& kind = kinds::garment_kind(name);
    return kind.draft({kinds::draft_measures(kind, body->measured), "", {}, {}}).pattern;
  };
  const pattern::Pattern over = drafted("hoodie");
  const garment::Garment tee = garment::assemble(drafted("t-shirt"), 0.03, fabric::Material{}),
                         hoodie = garment::assemble(over, 0.03, fabric::Material{});
  const auto sew = [&](const body::PosedBody& wearer) { return sew_on(hoodie, over, wearer); };
  const std::vector<Vec3> all =
      dress::dress_layers({{&tee, kinds::garment_kind("t-shirt").lay}, {&hoodie, {}, sew}}, body);
  const std::vector<Vec3> x(all.begin(), all.begin() + tee.vertex_count),
      y(all.begin() + tee.vertex_count, all.end());
  EXPECT_TRUE(geometry::mesh_intersections(x, tee.triangles, y, hoodie.triangles).empty());
  EXPECT_TRUE(geometry::self_intersections(y, hoodie.triangles).empty());
  EXPECT_TRUE(geometry::mesh_intersections(y, hoodie.triangles, body.tree()).empty());
}

}  // namespace
}  // namespace loosefit::drape
