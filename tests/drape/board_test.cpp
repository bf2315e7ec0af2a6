#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/contact/distance_field.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/solver/quasi_static.h"
#include "support/simple_patterns.h"

// Rigid boards on cloth against statics.
namespace loosefit::drape {
namespace {

garment::Board rectangle(const Vec2& at, const Vec2& size, double mass) {
  garment::Board board;
  board.centre = at;
  board.size = size;
  board.mass = mass;
  return board;
}

/// A sheet of cloth with a rigid board, and what it is draped on.
struct Sheet {
  fabric::Material material;
  pattern::Pattern pattern;
  garment::Garment garment;
  particles::VectorField x;
  std::unique_ptr<ClothModel> model;
  geometry::TriangleMesh ground;
  std::unique_ptr<geometry::ClosestPointTree> tree;

  Sheet(double width, double height, double edge, const garment::Board& board) {
    material.stiffness_warp = material.stiffness_weft = 300;
    material.stiffness_shear = 60;
    material.friction_body = 0;
    pattern.panels = {testing_support::rectangle_panel("cloth", width, height)};
    garment = garment::assemble(pattern, edge, material, {{"board", "cloth", board}});
    model = std::make_unique<ClothModel>(garment, material, DrapeOptions{}, 1e-4);
    model->system().held.assign(garment.vertex_count, 0);
  }
  void lay(const geometry::TriangleMesh& surface) {
    ground = surface;
    tree = std::make_unique<geometry::ClosestPointTree>(ground);
    geometry::Box3 box;
    for (const Vec3& p : x) box.extend(p);
    const Vec3 margin = Vec3::Constant(0.04);
    model->body().set_field(std::make_shared<contact::DistanceField>(
        *tree, geometry::Box3(box.min() - margin, box.max() + margin), 0.005));
  }
  solver::SettleOutcome settle(double tolerance = 1e-6) {
    solver::SettleOptions options;
    options.tolerance = tolerance;
    return solver::make_quasi_static(model->system())->settle(x, options);
  }
  Vec3 normal(int t) const {
    const auto& [a, b, c] = garment.triangles[t];
    return (x[b] - x[a]).cross(x[c] - x[a]).normalized();
  }
  const garment::Garment::RigidBoard& board() const { return garment.rigid_boards.at(0); }
  Vec3 board_normal() const { return normal(board().triangles[0]); }
  /// Largest angle between two triangles of the board [°].
  double bent() const {
    double most = 0;
    for (int t : board().triangles) most = std::max(most, board_normal().cross(normal(t)).norm());
    return degrees(std::asin(most));
  }
  /// Of cloth and board, with the board's own one off the cloth [m].
  Vec3 centre_of_mass() const {
    Vec3 sum = board().mass * board().offset * board_normal();
    double mass = 0;
    for (int v = 0; v < garment.vertex_count; ++v) {
      sum += garment.vertex_mass[v] * x[v];
      mass += garment.vertex_mass[v];
    }
    return sum / mass;
  }
};

TEST(RigidBoard, HangsWithItsCentreOfMassUnderTheEdgeThatHoldsIt) {
  // A narrow strip of light cloth ends in a board as wide: t/2 off the cloth and h/2 below its
  // edge, so that it leans by atan(t/h).
  for (const double thickness : {0.0, 0.004, 0.009})
    for (const auto side : {garment::Board::Side::outside, garment::Board::Side::inside}) {
      const double height = 0.03, width = 0.04;
      garment::Board board = rectangle({width / 2, height / 2}, {width, height}, 0.05);
      board.thickness = thickness;
      board.side = side;
      Sheet s(width, 0.15, 0.01, board);
      for (int v = 0; v < s.garment.vertex_count; ++v) {
        const Vec2& uv = s.garment.vertex_uv[v];
        s.x.emplace_back(uv.x(), 0, uv.y());
        s.model->system().held[v] = uv.y() > 0.15 - 1e-9;
      }
      EXPECT_EQ(s.settle(1e-7).reason, solver::SettleOutcome::Reason::converged);
      EXPECT_LT(s.bent(), 1e-4);
      // Outside is −y here (the normal of u × v is −y), so an outside board pulls its top to +y.
      const double lean = std::asin(std::abs(s.board_normal().z()));
      // The cloth pulls from a little above the edge: what it weighs and bends is 2 % of the board.
      EXPECT_NEAR(degrees(lean), degrees(std::atan(thickness / height)),
                  0.05 + 0.03 * degrees(std::atan(thickness / height)))
          << thickness;
      const double sign = side == garment::Board::Side::outside ? -1 : 1;
      if (thickness > 0) {
        EXPECT_GT(sign * s.board_normal().z(), 0) << "the side with the mass turns down";
      }
    }
}

TEST(RigidBoard, EccentricMassHangsUnderThePinsAndLoadsThemByItsLever) {
  for (const Vec2& at : {Vec2(0.06, 0.10), Vec2(0.20, 0.05)}) {
    garment::Board board = rectangle(at, {0.04, 0.03}, 0.08);
    board.thickness = 0.01;
    Sheet s(0.26, 0.2, 0.02, board);
    std::vector<int> pins;
    for (int v = 0; v < s.garment.vertex_count; ++v) {
      const Vec2& uv = s.garment.vertex_uv[v];
      s.x.emplace_back(uv.x(), 0.001 * std::sin(40 * uv.x()), uv.y());
      if (uv.y() > 0.2 - 1e-9 && (uv.x() < 1e-9 || uv.x() > 0.26 - 1e-9)) pins.push_back(v);
    }
    ASSERT_EQ(pins.size(), 2u);
    for (int v : pins) s.x[v].y() = 0, s.model->system().held[v] = 1;
    EXPECT_EQ(s.settle(1e-6).reason, solver::SettleOutcome::Reason::converged);
    EXPECT_LT(s.bent(), 1e-4);
    const Vec3 centre = s.centre_of_mass();
    EXPECT_NEAR(centre.y(), 0, 2e-6) << "under the line through the pins";
    // What each pin bears: lever of the whole weight.
    particles::VectorField g(s.x.size(), Vec3::Zero());
    for (const particles::Energy* e : s.model->system().energies) e->add_gradient(s.x, g);
    double weight = 0;
    for (double m : s.garment.vertex_mass) weight += m * kGravity;
    const double share = (centre.x() - s.x[pins[0]].x()) / (s.x[pins[1]].x() - s.x[pins[0]].x());
    EXPECT_NEAR(g[pins[1]].z(), share * weight, 1e-3 * weight);
    EXPECT_NEAR(g[pins[0]].z(), (1 - share) * weight, 1e-3 * weight);
  }
}

/// A wide slab whose upper side leans about the x axis.
geometry::TriangleMesh incline(double angle) {
  geometry::TriangleMesh slab;
  const Eigen::AngleAxisd turn(angle, Vec3::UnitX());
  for (int i = 0; i < 8; ++i)
    slab.vertices.push_back(turn * Vec3(i & 1 ? 0.4 : -0.4, i & 2 ? 0.4 : -0.4, i & 4 ? 0 : -0.1));
  slab.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return slab;
}

TEST(RigidBoard, LiesFlatOnAnInclineAndBearsTheCosineOfItsWeight) {
  for (const double angle : {radians(15), radians(40)})
    for (const double thickness : {0.0, 0.005}) {
      garment::Board board = rectangle({0.11, 0.08}, {0.05, 0.04}, 0.06);
      board.thickness = thickness;
      board.side = garment::Board::Side::inside;
      Sheet s(0.2, 0.2, 0.02, board);
      const Eigen::AngleAxisd turn(angle, Vec3::UnitX());
      for (int v = 0; v < s.garment.vertex_count; ++v) {
        const Vec2& uv = s.garment.vertex_uv[v];
        s.x.push_back(turn * Vec3(uv.x() - 0.1, uv.y() - 0.1, 0.001 + thickness));
        s.model->system().held[v] = uv.y() > 0.2 - 1e-9;
      }
      s.lay(incline(angle));
      EXPECT_EQ(s.settle(1e-6).reason, solver::SettleOutcome::Reason::converged);
      EXPECT_LT(s.bent(), 1e-4);
      const Vec3 up = turn * Vec3::UnitZ();
      if (thickness == 0) {
        EXPECT_LT(degrees(std::acos(s.board_normal().dot(up))), 0.05);
      }
      // As far from the slab as it is thick, cloth beside it as near as ever.
      for (int v : s.board().leaders)
        EXPECT_NEAR(s.x[v].dot(up), thickness + 0.5 * s.material.thickness,
                    0.5 * s.material.thickness + 0.02 * thickness);
      std::vector<double> force(s.x.size(), 0.0);
      s.model->body().add_normal_force(s.x, force);
      double sum = 0, weight = 0;
      for (double f : force) sum += f;
      for (double m : s.garment.vertex_mass) weight += m * kGravity;
      // The upper edge is held a little off the slab, and so bears a little.
      EXPECT_NEAR(sum, std::cos(angle) * weight, 0.04 * weight);
    }
}

TEST(RigidBoard, OneWithMeasuredFiguresIsFlexible) {
  garment::Board board = rectangle({0.1, 0.1}, {0.06, 0.05}, 0.03);
  board.bending = 1e-6;
  board.membrane_factor = 1;
  Sheet s(0.2, 0.2, 0.02, board);
  EXPECT_TRUE(s.garment.rigid_boards.empty());
  EXPECT_TRUE(s.model->system().plates.empty());
}

}  // namespace
}  // namespace loosefit::drape
