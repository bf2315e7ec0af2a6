// Sensors round a limb: sliding, and a girth line that has no orientation.
#include "loosefit/placement/site_state.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/maps/orientation_error.h"
#include "loosefit/placement/site_metrics.h"
#include "support/body_fixture.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

using Metrics = std::map<std::string, double>;

fabric::Material cloth() {
  fabric::Material m;
  m.thickness = 0.001;
  return m;
}

/// A sleeve round an upper arm of 40 mm radius.
struct Sleeve {
  static constexpr double kArm = 0.04, kCloth = 0.0405;
  body::Body arm = testing::cylinder_body(kArm, 0.5, 360, 25);
  garment::Garment tube = testing::tube_garment(2 * kPi * kCloth, 0.2, 90, 70);
  Sleeve() {
    arm.segment.assign(arm.segment.size(), body::Segment::upper_arm);
    arm.side.assign(arm.side.size(), 1);
    arm.joints["elbow_L"] = Vec3(0, 0, 0);
    arm.joints["shoulder_L"] = Vec3(0, 0, 0.5);
  }
  std::vector<Vec3> moved(double along, double around, double stretch = 1) const {
    std::vector<Vec3> positions;
    for (const Vec2& uv : tube.vertex_uv) {
      const double a = (uv.x() + around) / kCloth;
      positions.emplace_back(stretch * kCloth * std::cos(a), stretch * kCloth * std::sin(a),
                             0.15 + uv.y() + along);
    }
    return positions;
  }
};

TEST(SiteMetrics, OfAPatchThatSlidesAlongAndRoundALimb) {
  const Sleeve s;
  const auto worn = s.moved(0, 0), slid = s.moved(0.009, 0.005);
  const maps::WornGarment worn_relation = maps::relate(s.tube, worn, s.arm),
                          slid_relation = maps::relate(s.tube, slid, s.arm);
  const SiteMeter meter(s.tube, cloth(),
                        {{0, 0, worn, s.arm, worn_relation}, {1, 0, slid, s.arm, slid_relation}});
  SensorPatch sensor;
  const geometry::TriangleMesh mesh{worn, s.tube.triangles};
  const geometry::ClosestPoint at =
      geometry::ClosestPointTree(mesh).query(Vec3(0, Sleeve::kCloth, 0.25));
  sensor.footprint = footprint(s.tube, worn, at.triangle, at.barycentric, 0.012);
  const auto states = meter.measure(sensor);
  EXPECT_NEAR(1000 * states[1].slip.along, 9, 0.01);
  EXPECT_NEAR(1000 * states[1].slip.around, 5, 0.15);
  EXPECT_NEAR(1000 * states[0].slip.distance, 0, 1e-9);
  const Metrics m = site_metrics_by_donning(states).front();
  EXPECT_NEAR(m.at("slip_mm"), std::hypot(9, 5), 0.1);
  // It has turned round the limb by the angle it slid, and lies as flat on the skin as before.
  EXPECT_NEAR(m.at("coe_rms_deg"), degrees(0.005 / Sleeve::kCloth), 0.1);
  EXPECT_NEAR(m.at("angular_deviation_deg"), 0, 0.1);
  EXPECT_NEAR(m.at("twist_deg"), 0, 0.1);
  EXPECT_EQ(m.at("contact_ratio"), 1);
}

TEST(SiteMetrics, OfAGirthAreItsStrainAndContactButNoOrientation) {
  const Sleeve s;
  const auto worn = s.moved(0, 0), wide = s.moved(0, 0, 1.03);
  const maps::WornGarment worn_relation = maps::relate(s.tube, worn, s.arm),
                          wide_relation = maps::relate(s.tube, wide, s.arm);
  const SiteMeter meter(s.tube, cloth(),
                        {{0, 0, worn, s.arm, worn_relation}, {1, 0, wide, s.arm, wide_relation}});
  SensorPatch girth;
  constexpr int kAround = 90, kRow = 35;  // one triangle of each square half way up
  for (int i = 0; i < kAround; ++i)
    girth.footprint.samples.push_back(
        {2 * (kRow * kAround + i), Vec3(0.3, 0.3, 0.4), 2 * kPi * Sleeve::kCloth / kAround});
  girth.sample_directions.assign(girth.footprint.samples.size(), Vec2(1, 0));
  const Metrics m = site_metrics_by_donning(meter.measure(girth)).front();
  EXPECT_NEAR(m.at("strain"), 0, 3e-4);  // chords of the mesh
  EXPECT_NEAR(m.at("strain_swing"), 0.03, 3e-4);
  EXPECT_EQ(m.at("contact_duty"), 0.5);
  for (const char* name : {"angular_deviation_deg", "rotation_deg", "coe_rms_deg", "slip_mm"})
    EXPECT_FALSE(m.count(name)) << name;
}

/// The back and breast of a wearer as a garment: cloth that sticks to the skin, `off` metres away.
struct SecondSkin {
  garment::Garment garment;
  std::vector<int> vertex;  ///< of the body

  explicit SecondSkin(const body::Body& body) {
    std::vector<int> own(body.segment.size(), -1);
    garment.panel_names = {"skin"};
    for (const Triangle& t : body.surface.triangles) {
      if (std::any_of(t.begin(), t.end(),
                      [&](int v) { return body.segment[v] != body::Segment::torso; }))
        continue;
      Triangle corner{};
      std::array<Vec2, 3> uv;
      for (int k = 0; k < 3; ++k) {
        const Vec3& p = body.surface.vertices[t[k]];
        uv[k] = Vec2(-p.x(), p.z());
        if (own[t[k]] < 0) {
          own[t[k]] = garment.vertex_count++;
          vertex.push_back(t[k]);
          garment.vertex_uv.push_back(uv[k]);
        }
        corner[k] = own[t[k]];
      }
      garment.triangles.push_back(corner);
      garment.triangle_uv.push_back(uv);
    }
    garment.triangle_panel.assign(garment.triangles.size(), 0);
    garment.vertex_panel.assign(garment.vertex_count, 0);
  }
  std::vector<Vec3> on(const body::Body& body, double off) const {
    std::vector<Vec3> positions;
    for (int v : vertex) positions.push_back(body.surface.vertices[v] + off * body.normals[v]);
    return positions;
  }
};

TEST(SiteState, ASensorThatSticksToTheSkinOfABendingWearerIsNeverWrong) {
  const body::BodyParameters parameters;
  const body::Body upright = body_model().build(parameters, {});
  body::Posture posture;
  posture.forward_bend = radians(45);
  const body::Body bent = body_model().build(parameters, posture);
  const SecondSkin skin(upright);
  const auto before = skin.on(upright, 0.01), after = skin.on(bent, 0.01);
  const maps::WornGarment worn_before = maps::relate(skin.garment, before, upright),
                          worn_after = maps::relate(skin.garment, after, bent);
  const SiteMeter meter(skin.garment, cloth(),
                        {{0, 0, before, upright, worn_before}, {1, 0, after, bent, worn_after}});
  const geometry::TriangleMesh mesh{before, skin.garment.triangles};
  const geometry::ClosestPointTree tree(mesh);
  for (const char* name : {"upper_back", "mid_back", "lower_back", "scapula_L", "sternum"}) {
    const geometry::ClosestPoint at = tree.query(upright.landmarks.at(name));
    SensorPatch sensor;
    sensor.footprint = footprint(skin.garment, before, at.triangle, at.barycentric, 0.012);
    const auto states = meter.measure(sensor);
    const double error = maps::calibrated_error(states[1].on_skin, states[0].on_skin);
    EXPECT_LT(degrees(error), 0.2) << name;
    EXPECT_LT(1000 * states[1].slip.distance, 0.05) << name;
    // It has followed the trunk all the same; the back bends most at the waist.
    const double lean =
        maps::rotation_angle(states[1].garment_frame * states[0].garment_frame.transpose());
    EXPECT_GT(degrees(lean), 10) << name;
    EXPECT_NEAR(degrees(states[1].orientation.twist), degrees(states[0].orientation.twist), 1)
        << name;
  }
}

}  // namespace
}  // namespace loosefit::placement
