#include "loosefit/drape/cloth_layer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "loosefit/base/error.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

using support::knit;

/// An adult with a shirt over a tighter one with short sleeves, coarse meshes of one level.
struct Wearer {
  body::BodyParameters parameters = support::adult_parameters();
  body::Body body = support::standing(parameters, 25);
  garment::GarmentHierarchy inner, outer;
  std::vector<ClothLayer> layers;

  explicit Wearer(double edge = 0.05)
      : inner(garment::build_hierarchy(support::shirt_for(body, 0.05, 0.4), edge, knit())),
        outer(garment::build_hierarchy(support::shirt_for(body, 0.20), edge, fabric::Material{})) {
    layers = {{&inner, knit(), 0.3}, {&outer, fabric::Material{}}};
  }
  Wearer(const Wearer&) = delete;

  body::BodyPath arms(double from, double to) const {
    return support::arms_path(parameters, from, to);
  }
};

TEST(ClothLayer, FrictionBetweenLayersIsWhatTheLowerOneSaysOrTheMean) {
  fabric::Material a, b, c;
  a.friction_self = 0.2, b.friction_self = 0.4, c.friction_self = 0.8;
  const Eigen::MatrixXd mu = layer_friction({{nullptr, a}, {nullptr, b, 0, 0.1}, {nullptr, c}});
  Eigen::Matrix3d expected;
  expected << 0.2, 0.3, 0.5, 0.3, 0.4, 0.1, 0.5, 0.1, 0.8;
  EXPECT_LT((mu - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(ClothLayer, JoinedMeshesKeepTheirOrder) {
  garment::Garment a, b;
  a.vertex_count = 4, b.vertex_count = 3;
  const std::array<Vec2, 3> uv{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  a.triangles = {{0, 1, 2}, {1, 3, 2}}, b.triangles = {{2, 1, 0}};
  a.triangle_uv = {uv, uv}, b.triangle_uv = {uv};
  const ClothMesh all = joined({&a, &b});
  EXPECT_EQ(all.vertices, 7);
  EXPECT_EQ(all.layers(), 2);
  EXPECT_EQ(all.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {6, 5, 4}}));
  EXPECT_EQ(all.triangles_of(1), (std::vector<Triangle>{{6, 5, 4}}));
  EXPECT_EQ(all.triangle_layer, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(all.area, (std::vector<double>{0.5, 0.5, 0.5}));
}

// One shirt over another: rest with the exact test's word that nothing cuts, the outer one outside
// of the inner by the thickness of the cloth, the weight of both on the body; then the arms rise a
// little.
TEST(LayeredShirts, SettleOverEachOtherAndFollowTheBody) {
  const Wearer wearer;
  Progress silent;
  const DrapeOptions options;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  DrapeSession session(wearer.layers, options, silent);
  const Drape all = session.put_on(wearer.arms(25, 25));
  ASSERT_TRUE(all.certificate.settled())
      << all.certificate.stop_reason << " " << all.certificate.residual;
  EXPECT_EQ(all.certificate.intersections_layers, 0);
  const Drape inner = drape_of_layer(all, wearer.layers, 0);
  const Drape outer = drape_of_layer(all, wearer.layers, 1);
  const garment::Garment &g0 = wearer.inner.finest(), &g1 = wearer.outer.finest();
  ASSERT_EQ(inner.positions.size(), static_cast<std::size_t>(g0.vertex_count));
  ASSERT_EQ(outer.positions.size(), static_cast<std::size_t>(g1.vertex_count));
  EXPECT_EQ(outer.positions.back(), all.positions.back());
  EXPECT_TRUE(
      geometry::mesh_intersections(inner.positions, g0.triangles, outer.positions, g1.triangles)
          .empty());

  // Distance between the layers: at most a fraction of the mean thickness is compressed.
  const double mean =
      0.5 * (wearer.layers[0].material.thickness + wearer.layers[1].material.thickness);
  const geometry::TriangleMesh inner_surface{inner.positions, g0.triangles};
  const geometry::ClosestPointTree tree(inner_surface);
  double nearest = 1;
  int touching = 0;
  for (const Vec3& p : outer.positions) {
    const double d = (tree.query(p).point - p).norm();
    nearest = std::min(nearest, d);
    touching += d < mean;
  }
  // Of coarse triangles vertices of either shirt meet faces of the other.
  const geometry::TriangleMesh outer_surface{outer.positions, g1.triangles};
  const geometry::ClosestPointTree outside(outer_surface);
  for (const Vec3& p : inner.positions) touching += (outside.query(p).point - p).norm() < mean;
  EXPECT_GT(nearest, 0.2 * mean);
  EXPECT_GE(touching, 3) << "the outer shirt hangs on the inner one";

  // Where the inner shirt lies between, on the trunk above the waist, the outer is the farther one.
  const geometry::ClosestPointTree skin(wearer.body.surface);
  const auto is_front = [](const garment::Garment& g, int v) {
    return g.panel_names[g.vertex_panel[v]] == "front";
  };
  int beyond = 0, compared = 0;
  for (int v = 0; v < g1.vertex_count; ++v) {
    if (!is_front(g1, v) || g1.vertex_uv[v][1] > -0.25 || g1.vertex_uv[v][1] < -0.5) continue;
    const geometry::ClosestPoint hit = tree.query(outer.positions[v]);
    ++compared;
    beyond += skin.signed_distance(outer.positions[v]) > skin.signed_distance(hit.point);
  }
  EXPECT_GT(compared, 20);
  EXPECT_EQ(beyond, compared);

  Vec3 carried = Vec3::Zero();
  for (const Vec3& f : all.body_contact_force) carried += f;
  const double weight = (g0.mass + g1.mass) * kGravity;
  EXPECT_NEAR(carried[2], weight, 0.01 * weight);
  double through_inner = 0;
  for (const Vec3& f : inner.body_contact_force) through_inner += f[2];
  EXPECT_GT(through_inner, 1.05 * g0.mass * kGravity) << "it bears part of the outer one too";

  const Drape raised = session.follow(wearer.arms(25, 29), silent);
  EXPECT_TRUE(raised.certificate.settled())
      << raised.certificate.stop_reason << " " << raised.certificate.residual;
  EXPECT_EQ(raised.certificate.intersections_layers, 0);
}

TEST(LayeredShirts, NeedMeshesOfTheSameLevelsAndTheirOwnDrape) {
  const Wearer wearer;
  const garment::GarmentHierarchy fine =
      garment::build_hierarchy(support::shirt_for(wearer.body, 0.1), 0.017, knit());
  Progress silent;
  EXPECT_THROW(DrapeSession({{&wearer.inner, knit()}, {&fine, knit()}}, {}, silent), InvalidInput);
  EXPECT_THROW(DrapeSession(std::vector<ClothLayer>{}, {}, silent), InvalidInput);
  EXPECT_THROW(drape_of_layer(Drape{}, wearer.layers, 0), Error);
}

}  // namespace
}  // namespace loosefit::drape
