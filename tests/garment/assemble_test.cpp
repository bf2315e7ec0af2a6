#include "loosefit/garment/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/garment/sew_panels.h"
#include "loosefit/garment/surface_check.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/mesher.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

fabric::Material cloth() {
  fabric::Material m;
  m.areal_density = .2;
  return m;
}

std::string error_of(const pattern::Pattern& pattern, double h = .02) {
  try {
    assemble(pattern, h, cloth());
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

int boundary_edges(const Garment& g) {
  std::map<std::pair<int, int>, int> count;
  for (const Triangle& t : g.triangles)
    for (int i = 0; i < 3; ++i)
      ++count[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  return static_cast<int>(
      std::count_if(count.begin(), count.end(), [](const auto& c) { return c.second == 1; }));
}

TEST(Assemble, OnePanelSewnToItselfIsATube) {
  pattern::Pattern tube;
  tube.panels = {rectangle_panel("tube", .4, .3)};
  tube.stitches = {stitch(0, 1, 0, 3)};
  const Garment g = assemble(tube, .02, cloth());
  EXPECT_EQ(g.find_chain("tube", "edge_1")->vertices.size(), 16u);
  EXPECT_EQ(boundary_edges(g), 40);
  EXPECT_NEAR(g.area, .12, 1e-12);
  EXPECT_NEAR(g.mass, .024, 1e-12);
  EXPECT_EQ(g.find_chain("tube", "edge_9"), nullptr);
  EXPECT_EQ(g.find_chain("cube", "edge_1"), nullptr);
}

// Whichever panel comes first in the file.
TEST(Assemble, ALapelIsTurnedOverAndNotTheCoat) {
  for (const bool lapel_first : {false, true}) {
    pattern::Pattern coat;
    coat.panels = {rectangle_panel("coat", .4, .3), rectangle_panel("lapel", .1, .3)};
    coat.stitches = {stitch(0, 1, 1, 1, true)};
    if (lapel_first) {
      std::swap(coat.panels[0], coat.panels[1]);
      std::swap(coat.stitches[0].first.panel, coat.stitches[0].second.panel);
    }
    const Garment g = assemble(coat, .05, cloth());
    for (std::size_t t = 0; t < g.triangles.size(); ++t) {
      const auto& uv = g.triangle_uv[t];
      const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
      const bool as_drawn = a.x() * b.y() - a.y() * b.x() > 0;
      EXPECT_EQ(as_drawn, g.panel_names[g.triangle_panel[t]] == "coat") << lapel_first;
    }
  }
}

TEST(Assemble, VertexMassIsAThirdOfTheAreaAround) {
  pattern::Pattern square;
  square.panels = {rectangle_panel("square", .1, .1)};
  const Garment g = assemble(square, .1, cloth());
  std::vector<double> expected(g.vertex_count, 0);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const auto& uv = g.triangle_uv[t];
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    for (const int v : g.triangles[t]) expected[v] += (a.x() * b.y() - a.y() * b.x()) / 6 * .2;
  }
  for (int v = 0; v < g.vertex_count; ++v) EXPECT_NEAR(g.vertex_mass[v], expected[v], 1e-15);
}

TEST(Assemble, DartClosesToAConeWithItsTipKept) {
  // Notch of 40 mm at the hem, 150 mm deep; its sides are edges 1 and 2.
  pattern::Pattern dart;
  dart.panels = {
      polygon_panel("front", {{0, 0}, {.18, 0}, {.20, .15}, {.22, 0}, {.4, 0}, {.4, .4}, {0, .4}})};
  dart.stitches = {stitch(0, 1, 0, 2)};
  const Garment g = assemble(dart, .02, cloth());
  const auto &left = g.find_chain("front", "edge_1")->vertices,
             &right = g.find_chain("front", "edge_2")->vertices;
  std::vector<int> back(right.rbegin(), right.rend());
  EXPECT_EQ(left, back);
  EXPECT_EQ(left.size(), 9u);
  EXPECT_EQ(boundary_edges(g), 20 + 20 + 20 + 9 + 9);
}

TEST(Assemble, GathersShareVerticesAndKeepTheirFlatLengths) {
  // Waist ratio 1.54 as in gathered trousers.
  pattern::Pattern skirt;
  skirt.panels = {rectangle_panel("band", .30, .04), rectangle_panel("skirt", .462, .3)};
  skirt.stitches = {stitch(0, 0, 1, 2)};
  const Garment g = assemble(skirt, .02, cloth());
  const auto& chain = g.find_chain("band", "edge_0")->vertices;
  EXPECT_EQ(chain.size(), 24u);
  double band = 0, gathered = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = g.triangles[t][i], b = g.triangles[t][(i + 1) % 3];
      for (std::size_t k = 0; k + 1 < chain.size(); ++k)
        if (std::minmax(a, b) == std::minmax(chain[k], chain[k + 1]))
          (g.triangle_panel[t] == 0 ? band : gathered) +=
              (g.triangle_uv[t][(i + 1) % 3] - g.triangle_uv[t][i]).norm();
    }
  EXPECT_NEAR(band, .30, 1e-12);
  EXPECT_NEAR(gathered, .462, 1e-12);
}

TEST(Assemble, RightWrongSeamStartsTogetherAndTurnsTheSecondPanelOver) {
  pattern::Pattern lapel;
  lapel.panels = {rectangle_panel("body", .2, .2), rectangle_panel("lapel", .2, .1)};
  lapel.stitches = {stitch(0, 2, 1, 2, true)};
  const Garment g = assemble(lapel, .02, cloth());
  EXPECT_EQ(g.find_chain("body", "edge_2")->vertices, g.find_chain("lapel", "edge_2")->vertices);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const auto& uv = g.triangle_uv[t];
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    EXPECT_EQ(a.x() * b.y() - a.y() * b.x() > 0, g.triangle_panel[t] == 0);
  }
}

TEST(Assemble, SeamsThatCannotCloseAreNamed) {
  pattern::Pattern p;
  p.panels = {rectangle_panel("a", .1, .1), rectangle_panel("b", .5, .1)};
  p.stitches = {stitch(0, 0, 1, 0)};
  EXPECT_NE(error_of(p).find("stitch seam: found sides of 0.1000 m and 0.5000 m"),
            std::string::npos)
      << error_of(p);

  pattern::Pattern moebius;
  moebius.panels = {rectangle_panel("band", .5, .1)};
  moebius.stitches = {stitch(0, 1, 0, 3, true)};
  EXPECT_NE(error_of(moebius).find("one-sided"), std::string::npos) << error_of(moebius);

  // Neighbouring edges sewn far end to far end collapse at the shared corner's opposite.
  pattern::Pattern folded;
  folded.panels = {rectangle_panel("a", .2, .2)};
  folded.stitches = {stitch(0, 0, 0, 1, true)};
  EXPECT_NE(error_of(folded), "accepted");
}

TEST(Assemble, SurfaceCheckFindsPointContactsAndTripleEdges) {
  Garment g;
  g.panel_names = {"a", "b"};
  const auto add = [&](Triangle t, int panel) {
    g.triangles.push_back(t);
    g.triangle_uv.push_back({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)});
    g.triangle_panel.push_back(panel);
  };
  const auto verdict = [&] {
    try {
      check_surface(g);
    } catch (const GeometryError& e) {
      return std::string(e.what());
    }
    return std::string("sound");
  };
  g.vertex_count = 6;
  add({0, 1, 2}, 0);
  add({2, 1, 3}, 0);
  EXPECT_EQ(verdict(), "sound");
  add({0, 4, 5}, 1);
  EXPECT_NE(verdict().find("touch in one point"), std::string::npos);
  g.triangles[2] = {1, 2, 5};
  EXPECT_NE(verdict().find("an edge it shares with two others"), std::string::npos);
  g.triangles[2] = {4, 4, 5};
  EXPECT_NE(verdict().find("corners are sewn together"), std::string::npos);
}

TEST(Assemble, UnequalCountsAcrossASeamAreRefused) {
  pattern::Pattern p;
  p.panels = {rectangle_panel("a", .2, .2), rectangle_panel("b", .2, .2)};
  p.stitches = {stitch(0, 0, 1, 0)};
  const std::vector<pattern::PanelMesh> meshes{
      pattern::mesh_panel(p.panels[0], {10, 10, 10, 10}, .02),
      pattern::mesh_panel(p.panels[1], {9, 10, 10, 10}, .02)};
  EXPECT_THROW(sew_panels(p, meshes, cloth()), GeometryError);
}

}  // namespace
}  // namespace loosefit::garment
