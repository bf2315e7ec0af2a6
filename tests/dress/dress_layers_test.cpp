#include "loosefit/dress/dress_layers.h"

#include <gtest/gtest.h>

#include "loosefit/dress/garments_cut.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"
#include "support/simple_patterns.h"

namespace loosefit::dress {
namespace {

using support::shirt_for;

struct LayerCase {
  double arms, inner_fit, inner_sleeve, outer_fit, edge;
};
void PrintTo(const LayerCase& c, std::ostream* out) {
  *out << "arms " << c.arms << ", " << c.inner_fit << " (sleeve " << c.inner_sleeve << ") under "
       << c.outer_fit << ", edge " << c.edge;
}
class DressLayers : public ::testing::TestWithParam<LayerCase> {};

/// How often a line from `p` along y passes through front panels before it and back panels behind.
std::pair<int, int> sheets_round(const Vec3& p, const garment::Garment& g,
                                 const std::vector<Vec3>& x) {
  int before = 0, behind = 0;
  for (const Triangle& t : g.triangles) {
    const Vec3 &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
    const auto cross = [&](const Vec3& q, const Vec3& r) {
      return (q[0] - p[0]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[0] - p[0]);
    };
    const double u = cross(b, c), v = cross(c, a), w = cross(a, b), sum = u + v + w;
    if (u * sum <= 0 || v * sum <= 0 || w * sum <= 0) continue;
    const double y = (u * a[1] + v * b[1] + w * c[1]) / sum;
    ++(y < p[1] ? before : behind);
  }
  return {before, behind};
}

TEST_P(DressLayers, TheOuterShirtEnclosesTheInnerAndNothingCuts) {
  const LayerCase& c = GetParam();
  const body::Body body = support::standing(support::adult_parameters(), c.arms);
  const garment::Garment inner =
      garment::assemble(shirt_for(body, c.inner_fit, c.inner_sleeve), c.edge, fabric::Material{});
  const garment::Garment outer =
      garment::assemble(shirt_for(body, c.outer_fit), c.edge, fabric::Material{});
  const std::vector<Vec3> all =
      dress_layers({{&inner, kinds::lay_shirt}, {&outer, kinds::lay_shirt}}, body);
  const std::vector<Vec3> x(all.begin(), all.begin() + inner.vertex_count);
  const std::vector<Vec3> y(all.begin() + inner.vertex_count, all.end());
  ASSERT_EQ(static_cast<int>(y.size()), outer.vertex_count);
  EXPECT_TRUE(geometry::self_intersections(x, inner.triangles).empty());
  EXPECT_TRUE(geometry::self_intersections(y, outer.triangles).empty());
  EXPECT_TRUE(geometry::mesh_intersections(x, inner.triangles, y, outer.triangles).empty());
  // Seen from every vertex of the inner shirt that the outer one covers, one sheet of that passes
  // before it and one behind.
  int covered = 0;
  for (const Vec3& p : x) {
    const auto [before, behind] = sheets_round(p, outer, y);
    if (before + behind == 0) continue;  // above its neck or below its hem
    ++covered;
    EXPECT_EQ(before, 1);
    EXPECT_EQ(behind, 1);
  }
  EXPECT_GT(covered, 0.9 * inner.vertex_count);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, DressLayers,
    ::testing::Values(LayerCase{25, 0.05, 0.36, 0.20, 0.028}, LayerCase{40, 0.05, 0.36, 0.20, 0.02},
                      LayerCase{25, 0.20, 0.40, 0.05, 0.028},  // outer tighter than inner
                      LayerCase{40, 0.10, 1.0, 0.30, 0.035},   // two long-sleeved shirts
                      LayerCase{25, 0.05, 0.5, 0.80, 0.05}));

TEST(DressLayers, OneLayerIsDressedAsIfAlone) {
  const body::Body body = support::standing(support::adult_parameters(), 25);
  const garment::Garment shirt = garment::assemble(shirt_for(body, 0.1), 0.03, fabric::Material{});
  EXPECT_EQ(dress_layers({{&shirt, kinds::lay_shirt}}, body), support::dress_shirt(shirt, body));
}

TEST(DressLayers, PlacedPanelsThatCutTheGarmentUnderThemAreAnError) {
  const body::Body body = support::standing(support::adult_parameters(), 25);
  const garment::Garment shirt = garment::assemble(shirt_for(body, 0.1), 0.03, fabric::Material{});
  pattern::Pattern pattern;
  pattern.panels = {testing_support::rectangle_panel("plate", 0.4, 0.4)};
  const garment::Garment square = garment::assemble(pattern, 0.05, fabric::Material{});
  const auto place = [&](const body::PosedBody&) {  // level at the waist
    std::vector<Vec3> x;
    for (const Vec2& uv : square.vertex_uv) x.emplace_back(uv[0] - 0.2, uv[1] - 0.2, 1.0);
    return x;
  };
  try {
    dress_layers({{&shirt, kinds::lay_shirt}, {&square, {}, place}}, body);
    FAIL();
  } catch (const GarmentsCut& error) {
    EXPECT_NE(std::string(error.what()).find("under them"), std::string::npos) << error.what();
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(DressLayers, WhatIsPlacedOverAShirtGoesRoundPaddingThatEnclosesIt) {
  const body::Body body = support::standing(support::adult_parameters(), 40);
  const garment::Garment shirt =
      garment::assemble(shirt_for(body, 0.1, 0.36), 0.03, fabric::Material{});
  pattern::Pattern pattern;
  pattern.panels = {testing_support::rectangle_panel("plate", 0.4, 0.4)};
  const garment::Garment square = garment::assemble(pattern, 0.05, fabric::Material{});
  std::vector<body::Body> wearers;
  const auto place = [&](const body::PosedBody& wearer) {  // clear of the shirt from the third on
    wearers.push_back(wearer);
    std::vector<Vec3> x;
    for (const Vec2& uv : square.vertex_uv)
      x.emplace_back(uv[0] - 0.2, uv[1] - 0.2, wearers.size() < 3 ? 1.0 : 3.0);
    return x;
  };
  const std::vector<Vec3> x =
      dress_layers({{&shirt, kinds::lay_shirt}, {&square, {}, place}}, body);
  ASSERT_EQ(wearers.size(), 3);
  const auto moved = [&](const body::Body& wearer, std::size_t v) {
    return (wearer.surface.vertices[v] - body.surface.vertices[v]).norm();
  };
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    EXPECT_LE(moved(wearers[0], v), moved(wearers[1], v) + 1e-12);
    EXPECT_LE(moved(wearers[1], v), moved(wearers[2], v) + 1e-12);
    if (body.segment[v] == body::Segment::foot) {
      EXPECT_EQ(moved(wearers[2], v), 0) << "vertex " << v;
    }
  }
  const auto count_inside = [&](const body::Body& wearer) {
    const geometry::ClosestPointTree tree(wearer.surface);
    int inside = 0;
    for (int i = 0; i < shirt.vertex_count; ++i) inside += tree.signed_distance(x[i]) < 1e-6;
    return inside;
  };
  EXPECT_LT(count_inside(body), 0.01 * shirt.vertex_count);
  EXPECT_GT(count_inside(wearers[2]), 0.95 * shirt.vertex_count);
  // The neck and the hands have only what the neckline and the cuffs beside them ask for.
  const auto hand_moves = [&](const body::Body& wearer) {
    double least = 1;
    for (std::size_t v = 0; v < body.segment.size(); ++v)
      if (body.segment[v] == body::Segment::hand) least = std::min(least, moved(wearer, v));
    return least;
  };
  EXPECT_EQ(hand_moves(wearers[2]), 0);
}

}  // namespace
}  // namespace loosefit::dress
