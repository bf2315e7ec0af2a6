// What a sensor meets over postures and donnings: rigid shells, sliding patches, stretched cloth
// and bridged hollows whose metrics are known (docs/theory/sensor_metrics.md 3 to 7, 10).
#include "loosefit/placement/site_metrics.h"

#include <gtest/gtest.h>

#include <deque>

#include "loosefit/base/error.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/placement/metric_names.h"
#include "support/wall_and_patch.h"

namespace loosefit::placement {
namespace {

using testing::turn_about;
using Metrics = std::map<std::string, double>;

fabric::Material cloth() {
  fabric::Material m;
  m.thickness = 0.001;
  return m;
}

/// A wearer whose back is a wall, and a patch of cloth before it in as many states as are added.
class OnTheWall : public ::testing::Test {
 protected:
  struct Made {
    std::vector<Vec3> positions;
    body::Body body;
    maps::WornGarment worn;
    maps::PressureField pressure;
  };

  void add(int posture, int donning, const std::vector<Vec3>& positions, const body::Body& body,
           const std::function<double(int)>& pressure = nullptr) {
    made_.push_back({positions, body, maps::relate(patch_, positions, body), {}});
    Made& m = made_.back();
    if (pressure)
      for (int v = 0; v < patch_.vertex_count; ++v) m.pressure.contact.push_back(pressure(v));
    states_.push_back(
        {posture, donning, m.positions, m.body, m.worn, pressure ? &m.pressure : nullptr});
  }
  void add(int posture, int donning, const std::vector<Vec3>& positions) {
    add(posture, donning, positions, wall_);
  }
  /// The patch turned about its middle by a rotation given in the body frame.
  std::vector<Vec3> turned(const Mat3& in_body_frame, double gap = 0.03,
                           const Vec3& move = Vec3::Zero()) const {
    const Mat3 frame = testing::wall_frame();
    return testing::before_wall(patch_, gap, frame * in_body_frame * frame.transpose(), move);
  }
  std::vector<Vec3> plain(double gap = 0.03) const { return testing::before_wall(patch_, gap); }

  /// A disc about the patch's middle.
  SensorPatch disc(double radius = 0.012) const {
    SensorPatch sensor;
    const geometry::TriangleMesh flat{testing::before_wall(patch_, 0), patch_.triangles};
    const geometry::ClosestPoint at = geometry::ClosestPointTree(flat).query(Vec3(1e-5, 0, 1e-5));
    sensor.footprint = footprint(patch_, flat.vertices, at.triangle, at.barycentric, radius);
    return sensor;
  }
  std::vector<SiteState> measured(const SensorPatch& sensor) const {
    return SiteMeter(patch_, material_, states_).measure(sensor);
  }
  /// Of the first donning.
  Metrics metrics(const SensorPatch& sensor) const {
    return site_metrics_by_donning(measured(sensor)).front();
  }
  Metrics metrics() const { return metrics(disc()); }

  fabric::Material material_ = cloth();
  garment::Garment patch_ = testing::patch_garment(0.1, 0.005);
  body::Body wall_ = testing::wall_body();
  std::deque<Made> made_;
  std::vector<WornState> states_;
};

TEST_F(OnTheWall, ARigidShellTurnedByAKnownRotationGivesItsTiltsTwistAndTotal) {
  const Vec3 tangent(std::cos(radians(35)), std::sin(radians(35)), 0);
  add(0, 0, turned(turn_about(tangent, radians(14)) * turn_about(Vec3::UnitZ(), radians(-23))));
  const Metrics m = metrics();
  EXPECT_NEAR(m.at("angular_deviation_deg"), 14, 0.1);
  EXPECT_NEAR(m.at("tilt_sagittal_deg"), 14 * std::cos(radians(35)), 0.1);
  EXPECT_NEAR(m.at("tilt_lateral_deg"), 14 * std::sin(radians(35)), 0.1);
  EXPECT_NEAR(m.at("twist_deg"), -23, 0.1);
  EXPECT_NEAR(m.at("rotation_deg"),
              degrees(2 * std::acos(std::cos(radians(7)) * std::cos(radians(11.5)))), 0.1);
}

TEST_F(OnTheWall, TheTwistIsThatOfTheSensorsDirection) {
  add(0, 0, plain());
  SensorPatch sensor = disc();
  sensor.direction = Vec2(-std::sin(radians(40)), std::cos(radians(40)));  // ccw in the pattern
  EXPECT_NEAR(metrics(sensor).at("twist_deg"), 40, 1e-6);
  EXPECT_NEAR(metrics(sensor).at("angular_deviation_deg"), 0, 1e-6);
}

TEST_F(OnTheWall, OnePostureOfOneDonningLeavesOutWhatNeedsMore) {
  add(0, 0, plain());
  const Metrics m = metrics();
  for (const char* name :
       {"coe_rms_deg", "coe_p95_deg", "donning_coe_deg", "gap_swing_mm", "contact_duty",
        "pressure_kPa", "pressure_min_kPa", "pressure_swing_kPa", "strain_swing", "slip_mm"})
    EXPECT_FALSE(m.count(name)) << name;
  EXPECT_EQ(m.size(), 14u);
  EXPECT_TRUE(site_metrics_by_donning({}).empty());
}

TEST_F(OnTheWall, TwoPosturesOfTwoDonningsGiveAllOfTheVocabularyThatIsNotDerived) {
  for (int k = 0; k < 4; ++k)
    add(k % 2, k / 2, plain(0.01 * (k + 1)), wall_, [](int) { return 1; });
  const Metrics m = metrics();
  for (const auto& [name, value] : m) EXPECT_NE(find_metric(name), nullptr) << name;
  EXPECT_EQ(m.size(), 29u);
}

// The wearer moves; the sensor turns with the body but for a known angle.
TEST_F(OnTheWall, CalibratedErrorIsTheChangeAgainstTheBodyNotTheOffset) {
  const Mat3 offset = turn_about(Vec3(1, 2, 3), radians(20));
  add(0, 0, turned(offset));
  const double angles[] = {3, 4, 12};
  for (int k = 0; k < 3; ++k) {
    const Mat3 lean = turn_about(Vec3(1, 0.1 * k, 0), radians(20 * k + 15));
    const Mat3 error = turn_about(Vec3(k, -1, 2), radians(angles[k]));
    const Vec3 move(0.1, 0, 0.2 * k);
    add(k + 1, 0, testing::moved(turned(error * offset), lean, move),
        testing::moved(wall_, lean, move));
  }
  const Metrics m = metrics();
  EXPECT_NEAR(m.at("rotation_deg"), 20, 0.1);
  EXPECT_NEAR(m.at("coe_rms_deg"), std::sqrt((9 + 16 + 144) / 3.0), 0.01);
  EXPECT_NEAR(m.at("coe_p95_deg"), 12, 0.01);
  EXPECT_NEAR(m.at("slip_mm"), 0, 0.4);  // a disc of 12 mm that turns about its middle
}

TEST_F(OnTheWall, EachDonningIsCalibratedByItselfAndComparedWithTheOthers) {
  // Put on at 0°, 6° and −2° of twist; the second posture adds 5°, 1° and 3°.
  const auto twisted = [&](double angle) {
    return turned(turn_about(Vec3::UnitZ(), radians(angle)));
  };
  const double worn[] = {0, 6, -2}, change[] = {5, 1, 3};
  for (int d = 0; d < 3; ++d) {
    add(0, d, twisted(worn[d]));
    add(1, d, twisted(worn[d] + change[d]));
  }
  const auto states = measured(disc());
  const auto each = site_metrics_by_donning(states);
  ASSERT_EQ(each.size(), 3u);
  const double to_others[] = {std::sqrt((36 + 4) / 2.0), std::sqrt((36 + 64) / 2.0),
                              std::sqrt((4 + 64) / 2.0)};
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(each[d].at("coe_rms_deg"), change[d], 1e-3);
    EXPECT_NEAR(each[d].at("twist_deg"), worn[d], 1e-3);
    EXPECT_NEAR(each[d].at("donning_coe_deg"), to_others[d], 1e-3);
  }
}

TEST_F(OnTheWall, ADonningWithoutItsReferenceCountsWithWhatNeedsNone) {
  add(0, 0, plain(0.010));
  add(1, 0, plain(0.020));
  add(1, 1, turned(turn_about(Vec3::UnitX(), 0.3), 0.060));  // its reference did not settle
  const auto each = site_metrics_by_donning(measured(disc()));
  ASSERT_EQ(each.size(), 2u);
  EXPECT_NEAR(each[0].at("coe_rms_deg"), 0, 1e-6);
  EXPECT_NEAR(each[0].at("angular_deviation_deg"), 0, 1e-6);
  // From skin to the inner face: less half a thickness of 1 mm.
  EXPECT_NEAR(each[0].at("gap_mm"), (10 + 20) / 2.0 - 0.5, 0.1);
  EXPECT_NEAR(each[1].at("gap_mm"), 60 - 0.5, 0.2);
  for (const char* name : {"coe_rms_deg", "angular_deviation_deg", "slip_mm"})
    EXPECT_FALSE(each[1].count(name)) << name;
  for (const Metrics& m : each) EXPECT_FALSE(m.count("donning_coe_deg"));
}

TEST_F(OnTheWall, GapOfATiltedPlane) {
  // Turned by 10° about the upright: gap = 30 mm + u sin 10° from the middle; 5 % of a disc lie
  // beyond 0.8054 r in any direction (circular segment).
  add(0, 0, turned(turn_about(Vec3::UnitY(), radians(10)), 0.0305));
  add(1, 0, plain(0.0205));
  const Metrics m = metrics();
  const double edge = 0.8054 * 12 * std::sin(radians(10));
  EXPECT_NEAR(m.at("gap_mm"), 25, 0.02);
  EXPECT_NEAR(m.at("gap_worst_mm"), 30 + edge, 0.05);
  EXPECT_NEAR(m.at("gap_swing_mm"), 10, 0.02);
  EXPECT_EQ(m.at("contact_ratio"), 0);
  EXPECT_EQ(m.at("contact_duty"), 0);
}

TEST_F(OnTheWall, ContactRatioOfABridgedHollowIsTheShareThatLiesOnItsBanks) {
  // A groove 10 mm wide through the middle of a disc of 20 mm radius, cloth lying on both banks; in
  // a second posture it lies on a plane. The cloth touches up to √((g + ½t)² − ¼t²) off a bank.
  const body::Body groove = testing::wall_body(
      {{0.5, 0}, {0.005, 0}, {0.00499, -0.01}, {-0.00499, -0.01}, {-0.005, 0}, {-0.5, 0}});
  body::Body filled = groove;
  for (Vec3& p : filled.surface.vertices) p.y() = 0;
  add(0, 0, plain(0.0005), filled);
  add(1, 0, plain(0.0005), groove);
  const Metrics m = metrics(disc(0.02));
  const double half = 0.005 - std::sqrt(std::pow(0.00075 + 0.0005, 2) - std::pow(0.0005, 2));
  const double r = 0.02,
               strip = 2 * (half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r));
  EXPECT_NEAR(m.at("contact_ratio"), 1 - strip / (kPi * r * r), 0.01);
  EXPECT_EQ(m.at("contact_duty"), 0.5);
}

TEST_F(OnTheWall, PressureIsThatOfTheFootprint) {
  // 2 kPa with a slope of 50 Pa/mm upwards; then 0.5 kPa; then 3 kPa.
  const auto level = [](double pascal) { return [pascal](int) { return pascal; }; };
  add(0, 0, plain(), wall_, [&](int v) { return 2000 + 50000 * patch_.vertex_uv[v].y(); });
  add(1, 0, plain(), wall_, level(500));
  add(2, 0, plain(), wall_, level(3000));
  const auto states = measured(disc());
  EXPECT_NEAR(states[0].readings[footprint_reading("pressure_kPa")], 2000, 5);
  const Metrics m = site_metrics_by_donning(states).front();
  EXPECT_NEAR(m.at("pressure_kPa"), 5.5 / 3, 0.01);
  EXPECT_NEAR(m.at("pressure_min_kPa"), 0.5, 1e-9);
  EXPECT_NEAR(m.at("pressure_swing_kPa"), 2.5, 1e-9);
}

TEST_F(OnTheWall, StrainAndSlackOfAStretchedPatch) {
  const auto stretched = [&](double weft, double warp) {
    std::vector<Vec3> positions;
    for (const Vec2& uv : patch_.vertex_uv)
      positions.emplace_back(-weft * uv.x(), 0.03, warp * uv.y());
    return positions;
  };
  add(0, 0, stretched(1.04, 1.0));
  add(1, 0, stretched(1.10, 0.99));
  add(2, 0, stretched(1.02, 0.998));
  SensorPatch sensor = disc();
  sensor.direction = Vec2(1, 0);
  Metrics m = metrics(sensor);
  EXPECT_NEAR(m.at("strain"), 0.04, 1e-9);
  EXPECT_NEAR(m.at("strain_swing"), 0.08, 1e-9);
  EXPECT_EQ(m.at("slack"), 1);  // in the second posture; −0.2 % is not slack
  sensor.direction = Vec2(0.6, 0.8);
  m = metrics(sensor);
  EXPECT_NEAR(m.at("strain"), std::hypot(0.6 * 1.04, 0.8) - 1, 1e-9);
  std::vector<WornState> without_the_second = {states_[0], states_[2]};
  states_.swap(without_the_second);
  EXPECT_EQ(metrics(sensor).at("slack"), 0);
}

TEST_F(OnTheWall, ManyPosturesSwingBetweenTheirPercentiles) {
  for (int k = 0; k < 40; ++k) add(k, 0, plain(0.010 + 0.001 * (k == 39 ? 500 : k)));
  // Ranks 2 and 38 of 40: the one outlier does not count.
  EXPECT_NEAR(metrics().at("gap_swing_mm"), 36, 1e-6);
}

TEST_F(OnTheWall, TheSensorsAxisGoesStraightOnAcrossASeam) {
  // The right half is another panel, its pattern turned by a quarter.
  patch_.panel_names.push_back("right");
  for (std::size_t t = 0; t < patch_.triangles.size(); ++t) {
    double u = 0;
    for (const Vec2& uv : patch_.triangle_uv[t]) u += uv.x() / 3;
    if (u < 0.004) continue;
    patch_.triangle_panel[t] = 1;
    for (Vec2& uv : patch_.triangle_uv[t]) uv = Vec2(-uv.y(), uv.x());
  }
  garment::Garment whole = testing::patch_garment(0.1, 0.005);
  std::vector<Vec3> positions;
  for (const Vec2& uv : whole.vertex_uv) positions.emplace_back(-uv.x(), 0.03, 1.1 * uv.y());
  add(0, 0, positions);
  std::swap(whole, patch_);
  const SensorPatch sensor = disc(0.02);  // taken before the panels were told apart
  std::swap(whole, patch_);
  const Metrics m = metrics(sensor);
  EXPECT_NEAR(m.at("twist_deg"), 0, 1e-6);
  EXPECT_NEAR(m.at("rotation_deg"), 0, 1e-6);
  EXPECT_NEAR(m.at("strain"), 0.1, 1e-9);
}

TEST_F(OnTheWall, WithoutASegmentAxisOnlyTheDeviationIsKnownButAllChangesAre) {
  wall_.joints.clear();
  const Mat3 tilt = turn_about(Vec3::UnitX(), radians(10));
  add(0, 0, turned(tilt));
  add(1, 0, turned(turn_about(Vec3(1, 1, 1), radians(7)) * tilt, 0.03, Vec3(0, 0, 0.005)));
  const Metrics m = metrics();
  EXPECT_NEAR(m.at("angular_deviation_deg"), 10, 0.1);
  EXPECT_NEAR(m.at("coe_rms_deg"), 7, 1e-3);
  EXPECT_NEAR(m.at("slip_mm"), 5, 0.5);
  for (const char* name : {"tilt_sagittal_deg", "tilt_lateral_deg", "twist_deg", "rotation_deg"})
    EXPECT_FALSE(m.count(name)) << name;
}

TEST_F(OnTheWall, StatesThatDoNotBelongTogetherAreRefused) {
  EXPECT_THROW(SiteMeter(patch_, material_, {}), InvalidInput);
  add(0, 0, plain());
  add(0, 0, plain());
  EXPECT_THROW(SiteMeter(patch_, material_, states_), InvalidInput);
  states_.pop_back();
  const body::Body other = testing::wall_body({{0.5, 0}, {0, 0}, {-0.5, 0}});
  add(1, 0, plain(), other);
  EXPECT_THROW(SiteMeter(patch_, material_, states_), InvalidInput);
  states_.pop_back();
  SensorPatch sensor = disc();
  sensor.sample_directions.resize(2, Vec2(1, 0));
  EXPECT_THROW(measured(sensor), InvalidInput);
  const StateMeter meter(patch_, material_, states_[0]);
  const SkinUnderSensor small = meter.skin_under(disc(0.005));
  EXPECT_THROW(meter.measure(disc(), &small), InvalidInput);
  made_.front().positions.pop_back();
  EXPECT_THROW(SiteMeter(patch_, material_, states_), InvalidInput);
}

}  // namespace
}  // namespace loosefit::placement
