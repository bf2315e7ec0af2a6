#include "loosefit/garment/hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/panel_mesh.h"

namespace loosefit::garment {
namespace {

/// Euler characteristic and number of boundary loops of a sewn mesh.
std::pair<int, int> topology(const Garment& g) {
  std::set<std::pair<int, int>> edges, directed;
  for (const Triangle& t : g.triangles)
    for (int i = 0; i < 3; ++i) {
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
      directed.insert({t[i], t[(i + 1) % 3]});
    }
  std::map<int, int> next;
  for (const auto& [a, b] : directed)
    if (!directed.contains({b, a})) next[b] = a;
  int loops = 0;
  while (!next.empty()) {
    ++loops;
    for (int v = next.begin()->first; next.contains(v);) {
      const int to = next[v];
      next.erase(v);
      v = to;
    }
  }
  return {g.vertex_count - static_cast<int>(edges.size()) + static_cast<int>(g.triangles.size()),
          loops};
}

TEST(Hierarchy, CoarsestEdgeIsBetweenEighteenAndThirtySixMillimetres) {
  for (const double h : {.002, .003, .005, .008, .010, .015, .018, .030}) {
    const double coarsest = h * (1 << hierarchy_refinements(h));
    EXPECT_GE(coarsest, .018) << h;
    EXPECT_LT(coarsest, .036) << h;
  }
  EXPECT_EQ(hierarchy_refinements(.050), 0);
}

TEST(Hierarchy, TheCoarsestLevelAloneIsThatOfTheWhole) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const GarmentHierarchy whole = build_hierarchy(shirt, .010, {});
  const GarmentHierarchy alone = build_coarsest_level(shirt, .010, {});
  ASSERT_EQ(whole.levels.size(), 2u);
  ASSERT_EQ(alone.levels.size(), 1u);
  ASSERT_EQ(alone.parents.size(), 1u);
  EXPECT_EQ(alone.parents[0], whole.parents[0]);
  EXPECT_EQ(alone.finest().triangles, whole.levels[0].triangles);
  EXPECT_EQ(alone.finest().vertex_mass, whole.levels[0].vertex_mass);
}

TEST(Hierarchy, LevelsOfTheShirtAreNestedAndSewn) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const fabric::Material cloth;
  const GarmentHierarchy h = build_hierarchy(shirt, .005, cloth);
  ASSERT_EQ(h.levels.size(), 3u);
  ASSERT_EQ(h.parents.size(), 3u);
  double true_area = 0;
  for (const pattern::Panel& p : shirt.panels)
    true_area += pattern::signed_area(pattern::outline_polygon(p, 400));

  for (std::size_t l = 0; l < h.levels.size(); ++l) {
    SCOPED_TRACE(l);
    const Garment& g = h.levels[l];
    // One tube with two sleeves: a sphere with four holes (neck, hem, two cuffs).
    EXPECT_EQ(topology(g), std::make_pair(-2, 4));
    EXPECT_NEAR(g.area, true_area, 1e-3 * true_area);
    EXPECT_NEAR(g.mass, g.area * cloth.areal_density, 1e-12);
    EXPECT_NEAR(std::accumulate(g.vertex_mass.begin(), g.vertex_mass.end(), 0.0), g.mass, 1e-12);
    EXPECT_EQ(g.triangle_membrane_factor.size(), g.triangles.size());
    EXPECT_EQ(g.triangle_added_bending.size(), g.triangles.size());
    double smallest = kPi, mean = 0;
    for (const auto& uv : g.triangle_uv) {
      EXPECT_GT(geometry::flat_area(uv), 0);
      const double angle = pattern::smallest_angle(uv[0], uv[1], uv[2]);
      smallest = std::min(smallest, angle);
      mean += angle / double(g.triangles.size());
    }
    EXPECT_GT(degrees(smallest), 20);
    EXPECT_GT(degrees(mean), 47);
    for (int v = 0; v < g.vertex_count; ++v) {
      const auto [a, b] = h.parents[l][v];
      if (l == 0) {
        EXPECT_EQ(a, v);
        EXPECT_EQ(b, v);
        continue;
      }
      const Garment& coarse = h.levels[l - 1];
      ASSERT_LT(std::max(a, b), coarse.vertex_count);
      if (v < coarse.vertex_count) {
        EXPECT_EQ(a, v);  // kept vertices keep their numbers
        EXPECT_EQ(b, v);
      } else {
        EXPECT_NE(a, b);
      }
    }
    if (l == 0) continue;
    EXPECT_EQ(g.triangles.size(), 4 * h.levels[l - 1].triangles.size());
    EXPECT_EQ(topology(h.levels[l - 1]).first, topology(g).first);
  }
}

TEST(Hierarchy, ChainsFollowWholePatternEdgesOnEveryLevel) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const GarmentHierarchy h = build_hierarchy(shirt, .010, {});
  for (const Garment& g : h.levels) {
    std::size_t edges = 0;
    for (const pattern::Panel& p : shirt.panels) edges += p.edges.size();
    EXPECT_EQ(g.edge_chains.size(), edges);
    for (const pattern::Stitch& s : shirt.stitches) {
      const auto chain = [&](const pattern::Stitch::Side& side) {
        const pattern::Panel& p = shirt.panels[side.panel];
        const Garment::EdgeChain* found = g.find_chain(p.name, p.edges[side.edge].name);
        EXPECT_NE(found, nullptr);
        return found->vertices;
      };
      std::vector<int> a = chain(s.first), b = chain(s.second);
      std::reverse(b.begin(), b.end());
      EXPECT_EQ(a, b) << s.name << ": both sides are the same vertices";
    }
    // Rest points of the armhole lie on its curve, even in arc length.
    const pattern::Panel& front = shirt.panels[0];
    const int e = pattern::find_edge(front, "armhole_L");
    const pattern::EdgePath path(front, e);
    const auto& vertices = g.find_chain("front", "armhole_L")->vertices;
    const int n = static_cast<int>(vertices.size()) - 1;
    for (int i = 0; i <= n; ++i)
      EXPECT_LT((g.vertex_uv[vertices[i]] - path.at(double(i) / n)).norm(), 1e-12) << i;
  }
}

TEST(Hierarchy, FlatEdgeLengthsOfBothSidesOfASeamAgree) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const Garment g = build_hierarchy(shirt, .010, {}).finest();
  // Every inner mesh edge on a seam: its flat length in one panel against that in the other.
  std::map<std::pair<int, int>, std::vector<std::pair<int, double>>> sides;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      sides[std::minmax(g.triangles[t][i], g.triangles[t][j])].push_back(
          {g.triangle_panel[t], (g.triangle_uv[t][j] - g.triangle_uv[t][i]).norm()});
    }
  int seam_edges = 0;
  for (const auto& [edge, two] : sides) {
    ASSERT_LE(two.size(), 2u);
    if (two.size() < 2 || two[0].first == two[1].first) continue;
    ++seam_edges;
    EXPECT_NEAR(two[0].second, two[1].second, .02 * two[0].second);
  }
  EXPECT_GT(seam_edges, 350);
}

TEST(Hierarchy, SameInputGivesTheSameMesh) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const Garment a = build_hierarchy(shirt, .012, {}).finest();
  const Garment b = build_hierarchy(shirt, .012, {}).finest();
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.vertex_uv, b.vertex_uv);
  EXPECT_EQ(a.vertex_mass, b.vertex_mass);
}

TEST(Hierarchy, ManyShirtsAndEdgeLengthsAreManifold) {
  for (const double chest : {-.2, 0., .45})
    for (const double sleeve : {-.2, .6})
      for (const double edge : {.006, .010, .018, .035, .060}) {
        SCOPED_TRACE(testing::Message() << chest << " " << sleeve << " " << edge);
        kinds::ShirtFit fit;
        fit.chest = fit.hip = chest;
        fit.sleeve = fit.wrist = sleeve;
        const GarmentHierarchy h = build_hierarchy(kinds::draft_shirt({}, fit), edge, {});
        EXPECT_EQ(topology(h.finest()), std::make_pair(-2, 4));
      }
}

}  // namespace
}  // namespace loosefit::garment
