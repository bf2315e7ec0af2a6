#include "loosefit/pattern/mesher.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/outline.h"
#include "support/simple_patterns.h"

namespace loosefit::pattern {
namespace {

using namespace testing_support;

double mesh_area(const PanelMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += signed_area({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return area;
}

TEST(Mesher, TrianglesAreNearlyEquilateralAtEverySize) {
  const Pattern shirt = kinds::draft_shirt({});
  for (const double h : {.008, .020, .035}) {
    const auto divisions = edge_divisions(shirt, h);
    for (std::size_t p = 0; p < shirt.panels.size(); ++p) {
      SCOPED_TRACE(testing::Message() << shirt.panels[p].name << " at " << h);
      const PanelMesh mesh = mesh_panel(shirt.panels[p], divisions[p], h);
      const MeshQuality q = mesh_quality(mesh);
      EXPECT_GT(degrees(q.smallest_angle), 22);
      EXPECT_GT(degrees(q.mean_angle), 48);
      EXPECT_NEAR(q.mean_edge, h, .08 * h);
      EXPECT_NEAR(mesh_area(mesh), signed_area(divided_outline(shirt.panels[p], divisions[p])),
                  1e-12);
    }
  }
}

TEST(Mesher, AddsNoPointOnTheOutline) {
  const Panel front = kinds::draft_shirt({}).panels[0];
  const std::vector<int> divisions(front.edges.size(), 9);
  const PanelMesh mesh = mesh_panel(front, divisions, .02);
  const std::vector<Vec2> outline = divided_outline(front, divisions);
  for (std::size_t i = 0; i < outline.size(); ++i) EXPECT_EQ(mesh.vertices[i], outline[i]);
  for (std::size_t i = outline.size(); i < mesh.vertices.size(); ++i)
    EXPECT_GT((closest_on_polygon(outline, mesh.vertices[i]) - mesh.vertices[i]).norm(), .003);
  for (std::size_t e = 0; e < front.edges.size(); ++e) {
    ASSERT_EQ(mesh.edge_vertices[e].size(), 10u);
    EXPECT_EQ(mesh.vertices[mesh.edge_vertices[e].front()], front.vertices[front.edges[e].start]);
    EXPECT_EQ(mesh.vertices[mesh.edge_vertices[e].back()], front.vertices[front.edges[e].end]);
  }
}

TEST(Mesher, NeighboursInThePanelAreNeighboursInTheList) {
  const Panel front = kinds::draft_shirt({}).panels[0];
  const std::vector<int> divisions(front.edges.size(), 20);
  const PanelMesh mesh = mesh_panel(front, divisions, .012);
  ASSERT_GT(mesh.triangles.size(), 1000u);
  // What a run of 64 fills of the square round it: 0.25 in the mean, 0.02 in a random order.
  double filled = 0;
  int runs = 0;
  for (std::size_t from = 0; from + 64 <= mesh.triangles.size(); from += 64, ++runs) {
    Vec2 low(1e9, 1e9), high = -low;
    double area = 0;
    for (std::size_t t = from; t < from + 64; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      area += signed_area({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
      for (int v : mesh.triangles[t]) {
        low = low.cwiseMin(mesh.vertices[v]);
        high = high.cwiseMax(mesh.vertices[v]);
      }
    }
    filled += area / std::pow((high - low).maxCoeff(), 2);
  }
  EXPECT_GT(filled / runs, 0.15);
}

TEST(Mesher, IsIrregular) {
  const Panel square = rectangle_panel("square", .4, .4);
  const PanelMesh mesh = mesh_panel(square, {20, 20, 20, 20}, .02);
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) ++valence[v];
  int other = 0, inner = 0;
  for (std::size_t v = 80; v < valence.size(); ++v) ++inner, other += valence[v] != 6;
  EXPECT_GT(inner, 250);
  EXPECT_GT(other, inner / 20);
}

TEST(Mesher, EdgesShorterThanTheMeshSizeKeepTheirEnds) {
  // Fragments of 0.9 mm and 5.6 mm as sewing splits leave them.
  const Panel panel =
      polygon_panel("sliver", {{0, 0}, {.2, 0}, {.2, .0009}, {.2, .3}, {.0056, .3}, {0, .3}});
  Pattern pattern;
  pattern.panels = {panel};
  const auto divisions = edge_divisions(pattern, .02);
  EXPECT_EQ(divisions[0], (std::vector<int>{10, 1, 15, 10, 1, 15}));
  const PanelMesh mesh = mesh_panel(panel, divisions[0], .02);
  EXPECT_LT(mesh.vertices.size(), 250u);
  EXPECT_NEAR(mesh_area(mesh), .06, 1e-12);
  EXPECT_NEAR(
      (mesh.vertices[mesh.edge_vertices[1][1]] - mesh.vertices[mesh.edge_vertices[1][0]]).norm(),
      .0009, 1e-12);
}

TEST(Mesher, BothSidesOfASeamGetTheCountOfTheLonger) {
  Pattern pattern;
  pattern.panels = {rectangle_panel("short", .2, .1), rectangle_panel("long", .31, .1)};
  pattern.stitches = {stitch(0, 2, 1, 0)};
  const auto divisions = edge_divisions(pattern, .01);
  EXPECT_EQ(divisions[0], (std::vector<int>{20, 10, 31, 10}));
  EXPECT_EQ(divisions[1], (std::vector<int>{31, 10, 31, 10}));
}

TEST(Mesher, NoInnerEdgeJoinsTwoSeamsOfANarrowPiece) {
  const Panel strap = rectangle_panel("strap", .012, .3);
  Pattern pattern;
  pattern.panels = {strap};
  const auto divisions = edge_divisions(pattern, .02);
  const PanelMesh mesh = mesh_panel(strap, divisions[0], .02);
  const int outline = 2 * (divisions[0][0] + divisions[0][1]);
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = std::min(t[i], t[(i + 1) % 3]), b = std::max(t[i], t[(i + 1) % 3]);
      if (b >= outline) continue;
      EXPECT_LE(std::min(b - a, outline - (b - a)), 2);
    }
}

TEST(Mesher, SubdivisionPutsMidpointsOnTheCurve) {
  const Pattern shirt = kinds::draft_shirt({});
  const Panel& front = shirt.panels[0];
  const auto divisions = edge_divisions(shirt, .03);
  std::vector<std::array<int, 2>> parents;
  const PanelMesh coarse = mesh_panel(front, divisions[0], .03);
  const PanelMesh fine = subdivide(coarse, front, parents);
  ASSERT_EQ(parents.size(), fine.vertices.size());
  EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  for (std::size_t e = 0; e < front.edges.size(); ++e) {
    const EdgePath path(front, static_cast<int>(e));
    const auto& chain = fine.edge_vertices[e];
    const double n = static_cast<double>(chain.size()) - 1;
    for (std::size_t i = 0; i < chain.size(); ++i)
      EXPECT_LT((fine.vertices[chain[i]] - path.at(i / n)).norm(), 1e-12);
  }
  EXPECT_GT(degrees(mesh_quality(fine).smallest_angle), 20);
  const double truth = signed_area(outline_polygon(front, 400));
  EXPECT_LT(std::abs(mesh_area(fine) - truth), .5 * std::abs(mesh_area(coarse) - truth));
}

TEST(Mesher, CurvedLensOfTwoEdgesIsMeshedAtAnySize) {
  Panel lens;
  lens.name = "lens";
  lens.vertices = {{0, 0}, {.1, 0}};
  PanelEdge lower, upper;
  lower.start = 0, lower.end = 1, lower.name = "lower";
  upper.start = 1, upper.end = 0, upper.name = "upper";
  for (PanelEdge* edge : {&lower, &upper}) {
    edge->curves[0].kind = EdgeCurve::Kind::circle;
    edge->curves[0].radius = .06;
    edge->curves[0].sweep = true;
  }
  lens.edges = {lower, upper};
  Pattern pattern;
  pattern.panels = {lens};
  const double half_angle = std::asin(.05 / .06);
  const double truth = .06 * .06 * (2 * half_angle - std::sin(2 * half_angle));
  EXPECT_NEAR(signed_area(outline_polygon(lens, 2000)), truth, 1e-8);
  for (const double h : {.005, .05, .5}) {
    const PanelMesh mesh = mesh_panel(lens, edge_divisions(pattern, h)[0], h);
    EXPECT_GT(mesh_area(mesh), .5 * truth) << h;
  }
}

std::string error_of(const Pattern& pattern, double h) {
  try {
    edge_divisions(pattern, h);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Mesher, RefusesWhatItCannotMesh) {
  Pattern pattern = kinds::draft_shirt({});
  EXPECT_NE(error_of(pattern, 0).find("edge_length: found 0 m, expected a positive"),
            std::string::npos);
  EXPECT_NE(error_of(pattern, std::nan("")).find("edge_length"), std::string::npos);
  EXPECT_NE(error_of(pattern, 1e-9).find("edge_length: found 1e-09 m, expected at least"),
            std::string::npos);
  EXPECT_NE(error_of(pattern, 3e-4).find("for a garment of"), std::string::npos);
  Pattern bow;
  bow.panels = {polygon_panel("bow", {{0, 0}, {.2, .2}, {.2, 0}, {0, .2}})};
  EXPECT_NE(error_of(bow, .01).find("panel bow: found an outline that crosses itself"),
            std::string::npos);
  Pattern clockwise;
  clockwise.panels = {polygon_panel("back", {{0, 0}, {0, .2}, {.2, .2}, {.2, 0}})};
  EXPECT_NE(error_of(clockwise, .01).find("clockwise outline"), std::string::npos);
  pattern.stitches.push_back(pattern.stitches[0]);
  EXPECT_NE(error_of(pattern, .01).find("a second time"), std::string::npos);
}

/// A turned rectangle.
MeshInset drawn_inset(const Vec2& at, const Vec2& half, double angle, double spacing) {
  MeshInset inset;
  const Eigen::Rotation2Dd turn(angle);
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    inset.outline.push_back(at + turn * half.cwiseProduct(corner));
  inset.spacing = spacing;
  return inset;
}

TEST(Mesher, InsetsAreEdgesOfAMeshThatGrowsAwayFromThem) {
  const Panel panel = rectangle_panel("square", .4, .4);
  const double h = .03;
  for (const double spacing : {.004, .010, .030})
    for (const double angle : {0.0, 0.4, 2.0}) {
      SCOPED_TRACE(testing::Message() << spacing << " turned by " << angle);
      const MeshInset inset = drawn_inset({.19, .22}, {.03, .02}, angle, spacing);
      const PanelMesh mesh = mesh_panel(panel, {13, 13, 13, 13}, h, {inset});
      EXPECT_NEAR(mesh_area(mesh), .16, 1e-12);
      EXPECT_GT(degrees(mesh_quality(mesh).smallest_angle), 15);
      double inside = 0, near = 0, far = 0;
      int near_count = 0, far_count = 0;
      for (const auto& [a, b, c] : mesh.triangles) {
        const Vec2 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const double area = signed_area({p, q, r});
        const Vec2 centre = (p + q + r) / 3;
        if (inside_polygon(inset.outline, centre)) {
          inside += area;
          near += area, ++near_count;
        } else if ((closest_on_polygon(inset.outline, centre) - centre).norm() > .1) {
          far += area, ++far_count;
        }
      }
      EXPECT_NEAR(inside, .06 * .04, 1e-12) << "no triangle lies on both sides";
      const auto edge = [](double area, int n) { return std::sqrt(4 / std::sqrt(3.0) * area / n); };
      EXPECT_NEAR(edge(near, near_count), spacing, .3 * spacing);
      EXPECT_NEAR(edge(far, far_count), h, .15 * h);
    }
}

TEST(Mesher, WhatAnInsetCannotHaveIsLeftOut) {
  const Panel panel = rectangle_panel("square", .2, .2);
  // Over the rim, in a corner, over each other, next to each other.
  const std::vector<std::vector<MeshInset>> cases = {
      {drawn_inset({.01, .1}, {.03, .02}, 0, .01)},
      {drawn_inset({0, 0}, {.03, .02}, 0.3, .01)},
      {drawn_inset({.1, .1}, {.03, .02}, 0, .01), drawn_inset({.11, .11}, {.03, .02}, 0.5, .01)},
      {drawn_inset({.07, .1}, {.03, .02}, 0, .01), drawn_inset({.1305, .1}, {.03, .02}, 0, .01)},
      {drawn_inset({.1, .1}, {.2, .2}, 0, .01)}};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const PanelMesh mesh = mesh_panel(panel, {10, 10, 10, 10}, .02, cases[k]);
    EXPECT_NEAR(mesh_area(mesh), .04, 1e-12) << k;
    EXPECT_GT(degrees(mesh_quality(mesh).smallest_angle), 8) << k;
  }
}

}  // namespace
}  // namespace loosefit::pattern
