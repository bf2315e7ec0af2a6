#include <gtest/gtest.h>

#include "loosefit/contact/self_contact.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/solver/quasi_static.h"
#include "support/cloth_scene.h"

namespace loosefit::drape {
namespace {

using support::ClothScene;
constexpr double kFriction = 0.3, kThickness = 1e-3;

/// A stiff little sheet on a larger one that is held, in a plane tilted by `slope` [rad] about the
/// y axis.
struct ClothOnCloth {
  std::unique_ptr<ClothScene> scene;
  std::unique_ptr<contact::SelfContact> self;
  Vec3 down_hill;
  int below = 0;

  explicit ClothOnCloth(double slope) {
    const Eigen::AngleAxisd tilt(slope, Vec3::UnitY());
    down_hill = tilt * Vec3::UnitX();
    geometry::TriangleMesh mesh = support::sheet(0.16, 0.06, 0.01, 0.15, 1);
    const geometry::TriangleMesh upper = support::sheet(0.03, 0.03, 0.01, 0.1, 2);
    below = static_cast<int>(mesh.vertices.size());
    particles::VectorField start;
    for (const Vec3& p : mesh.vertices) start.push_back(tilt * p);
    for (const Vec3& p : upper.vertices)
      start.push_back(tilt * (p + Vec3(0.03, 0.0151, 0.9 * kThickness)));
    for (const Triangle& t : upper.triangles)
      mesh.triangles.push_back({t[0] + below, t[1] + below, t[2] + below});
    mesh.vertices.insert(mesh.vertices.end(), upper.vertices.begin(), upper.vertices.end());
    fabric::Material m;
    m.stiffness_warp = m.stiffness_weft = 2000;
    m.stiffness_shear = 800;
    m.bending_warp = m.bending_weft = 1e-3;
    geometry::TriangleMesh far_body = support::box_mesh({0.01, 0.01, 0.01});
    for (Vec3& p : far_body.vertices) p[2] -= 1;
    scene = std::make_unique<ClothScene>(mesh, std::map<int, int>{}, start, far_body, m,
                                         ClothScene::Contact{});
    contact::SelfContact::Options options;
    options.thickness = kThickness;
    options.friction = kFriction;
    self = std::make_unique<contact::SelfContact>(scene->triangles, scene->area,
                                                  static_cast<int>(start.size()), options);
    scene->system.energies.push_back(self.get());
    for (int i = 0; i < below; ++i) scene->system.held[i] = 1;
  }

  double moved(const particles::VectorField& from) const {
    double sum = 0;
    for (std::size_t i = below; i < from.size(); ++i)
      sum += down_hill.dot(scene->x[i] - from[i]) / static_cast<double>(from.size() - below);
    return sum;
  }
};

TEST(ClothOnCloth, SticksJustBelowTheFrictionAngleAndSlidesJustAbove) {
  for (double share : {0.5, 0.99, 1.01, 1.2}) {
    ClothOnCloth incline(std::atan(share * kFriction));
    const particles::VectorField start = incline.scene->x;
    solver::SettleOptions options;
    options.tolerance = 1e-4;
    options.first_dt = 1e-3;
    options.max_iterations = 80;
    const auto outcome =
        solver::make_quasi_static(incline.scene->system)->settle(incline.scene->x, options);
    const double way = incline.moved(start);
    RecordProperty("moved_um_at_" + std::to_string(share), static_cast<int>(1e6 * way));
    RecordProperty("iterations_at_" + std::to_string(share), outcome.work.iterations);
    EXPECT_TRUE(geometry::self_intersections(incline.scene->x, incline.scene->triangles).empty());
    if (share < 1) {
      EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
          << share << " " << outcome.residual;
      EXPECT_LT(way, 2e-4) << share;
      EXPECT_GT(way, 0) << share;
    } else {
      EXPECT_NE(outcome.reason, solver::SettleOutcome::Reason::converged) << share;
      EXPECT_GT(way, 5e-3) << share;
    }
  }
}

}  // namespace
}  // namespace loosefit::drape
