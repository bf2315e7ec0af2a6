#include "loosefit/pattern/hole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/mesher.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::pattern {
namespace {

Panel rectangle(double width, double height) {
  Panel panel;
  panel.name = "tunic";
  panel.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (int e = 0; e < 4; ++e) {
    PanelEdge edge;
    edge.start = e, edge.end = (e + 1) % 4;
    edge.name = "e" + std::to_string(e + 1);
    panel.edges.push_back(edge);
  }
  return panel;
}

PanelHole ellipse(const std::string& name, const Vec2& centre, double rx, double ry, int n = 72) {
  PanelHole hole{name, {}};
  for (int i = 0; i < n; ++i)
    hole.points.push_back(centre +
                          Vec2(rx * std::cos(2 * kPi * i / n), ry * std::sin(2 * kPi * i / n)));
  return hole;
}

double mesh_area(const PanelMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2 u = mesh.vertices[b] - mesh.vertices[a], v = mesh.vertices[c] - mesh.vertices[a];
    area += 0.5 * (u.x() * v.y() - u.y() * v.x());
  }
  return area;
}

std::size_t rims(const PanelMesh& mesh) {
  return geometry::MeshTopology(mesh.triangles).boundary_loops().size();
}

TEST(PanelHole, MeshOfAnyPieceWithHolesHasItsAreaAndItsRims) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int k = 0; k < 12; ++k) {
    Pattern pattern;
    Panel panel = rectangle(between(0.4, 0.8), between(0.8, 1.4));
    const Vec2 size = panel.vertices[2];
    const int count = k % 3;
    for (int h = 0; h < count; ++h)
      panel.holes.push_back(ellipse("hole " + std::to_string(h),
                                    {size.x() * between(0.45, 0.55), size.y() * (0.3 + 0.4 * h)},
                                    between(0.05, 0.13), between(0.05, 0.13)));
    pattern.panels = {panel};
    check_pattern(pattern);
    const double edge = between(0.02, 0.05);
    PanelMesh mesh = mesh_panel(panel, edge_divisions(pattern, edge)[0], edge);
    EXPECT_EQ(rims(mesh), 1u + count);
    EXPECT_NEAR(mesh_area(mesh) / cloth_area(panel), 1, 0.02);
    EXPECT_GT(mesh_quality(mesh).smallest_angle, 0.15);
    // Finer meshes come nearer to the rim as drawn.
    std::vector<std::array<int, 2>> parents;
    for (int level = 0; level < 2; ++level) mesh = subdivide(mesh, panel, parents);
    EXPECT_EQ(rims(mesh), 1u + count);
    EXPECT_NEAR(mesh_area(mesh) / cloth_area(panel), 1, 0.0015);
  }
}

TEST(PanelHole, CornersOfASquareHoleStay) {
  Pattern pattern;
  Panel panel = rectangle(0.6, 0.8);
  panel.holes = {{"window", {{0.2, 0.3}, {0.37, 0.3}, {0.37, 0.41}, {0.2, 0.41}}}};
  pattern.panels = {panel};
  const PanelMesh mesh = mesh_panel(panel, edge_divisions(pattern, 0.04)[0], 0.04);
  EXPECT_NEAR(mesh_area(mesh), 0.6 * 0.8 - 0.17 * 0.11, 1e-12);
}

TEST(PanelHole, MirroredTwiceIsAsBefore) {
  const std::vector<PanelHole> holes{ellipse("a", {0.1, 0.4}, 0.05, 0.08)};
  const std::vector<PanelHole> once = mirrored_holes(holes), twice = mirrored_holes(once);
  EXPECT_GT(signed_area(once[0].points), 0);
  EXPECT_NEAR(once[0].points[0].x(), -0.15, 1e-12);
  for (std::size_t i = 0; i < holes[0].points.size(); ++i)
    EXPECT_EQ(twice[0].points[i], holes[0].points[i]);
}

TEST(PanelHole, OneThatTouchesTheOutlineOrAnotherIsRefusedByName) {
  const std::vector<Vec2> outline = outline_polygon(rectangle(0.6, 0.8));
  const PanelHole middle = ellipse("neck hole", {0.3, 0.4}, 0.1, 0.1);
  EXPECT_EQ(hole_fault(middle, outline, {}), "");
  EXPECT_NE(hole_fault(ellipse("b", {0.1, 0.4}, 0.1, 0.1), outline, {}), "");
  EXPECT_NE(hole_fault(ellipse("b", {0.05, 0.4}, 0.1, 0.1), outline, {}), "");
  EXPECT_NE(hole_fault(ellipse("b", {2, 0.4}, 0.1, 0.1), outline, {}), "");
  EXPECT_NE(hole_fault(ellipse("b", {0.3, 0.4}, 0.5, 0.6), outline, {}), "");
  const std::string twice = hole_fault(ellipse("b", {0.35, 0.4}, 0.1, 0.1), outline, {middle});
  EXPECT_NE(twice.find("\"neck hole\""), std::string::npos) << twice;
  EXPECT_NE(hole_fault(ellipse("b", {0.3, 0.4}, 0.03, 0.03), outline, {middle}), "");
  Pattern pattern;
  pattern.panels = {rectangle(0.6, 0.8)};
  pattern.panels[0].holes = {ellipse("b", {0.1, 0.4}, 0.1, 0.1)};
  try {
    check_pattern(pattern);
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("hole b"), std::string::npos) << error.what();
  }
}

TEST(PanelHole, SlotsThatCrossAreRefusedThoughNoCornerIsInTheOther) {
  const std::vector<Vec2> outline = outline_polygon(rectangle(0.6, 0.8));
  for (const double half : {0.06, 0.12}) {
    const auto slot = [&](const char* name, double x, double y) {
      return PanelHole{
          name, {{0.3 - x, 0.4 - y}, {0.3 + x, 0.4 - y}, {0.3 + x, 0.4 + y}, {0.3 - x, 0.4 + y}}};
    };
    const std::string fault =
        hole_fault(slot("across", half, 0.02), outline, {slot("upright", 0.02, half)});
    EXPECT_NE(fault.find("\"upright\""), std::string::npos) << fault;
  }
}

TEST(PanelHole, HolesThatMeetAtCoarseEdgesAreRefusedByName) {
  Pattern pattern;
  Panel panel = rectangle(0.6, 0.8);
  PanelHole ring{"ring", {}};  // most of one, round a disc
  for (int i = 0; i <= 60; ++i) {
    const double turn = radians(30 + 5 * i);
    ring.points.push_back(Vec2(0.3, 0.4) + 0.07 * Vec2(std::cos(turn), std::sin(turn)));
  }
  for (int i = 60; i >= 0; --i) {
    const double turn = radians(30 + 5 * i);
    ring.points.push_back(Vec2(0.3, 0.4) + 0.05 * Vec2(std::cos(turn), std::sin(turn)));
  }
  panel.holes = {ring, ellipse("disc", {0.3, 0.4}, 0.045, 0.045)};
  pattern.panels = {panel};
  check_pattern(pattern);
  EXPECT_EQ(rims(mesh_panel(panel, edge_divisions(pattern, 0.01)[0], 0.01)), 3u);
  try {
    mesh_panel(panel, edge_divisions(pattern, 0.08)[0], 0.08);
    FAIL() << "holes that cross were meshed";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("hole disc"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("\"ring\""), std::string::npos) << error.what();
  }
}

TEST(PanelHole, OneTooSmallForAMeshIsRefused) {
  const std::vector<Vec2> outline = outline_polygon(rectangle(0.6, 0.8));
  EXPECT_EQ(hole_fault(ellipse("b", {0.3, 0.4}, 0.0115, 0.0115), outline, {}), "");
  EXPECT_NE(hole_fault(ellipse("b", {0.3, 0.4}, 0.011, 0.011), outline, {}).find("4 cm2"),
            std::string::npos);
}

TEST(PanelHole, NamesAreGivenOnce) {
  std::vector<PanelHole> holes;
  for (const char* wished : {"", "neck", "neck", "", "neck 2"})
    holes.push_back({free_hole_name(wished, holes), {}});
  std::vector<std::string> names;
  for (const PanelHole& hole : holes) names.push_back(hole.name);
  EXPECT_EQ(names, (std::vector<std::string>{"hole", "neck", "neck 2", "hole 2", "neck 2 2"}));
}

}  // namespace
}  // namespace loosefit::pattern
