#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/lines/course.h"
#include "loosefit/lines/line_metrics.h"
#include "loosefit/lines/sensitivity.h"
#include "support/tube_garment.h"

namespace loosefit::lines {
namespace {

constexpr double kWidth = 0.4, kHeight = 0.3;

/// A tube along its one seam; places in the pattern.
struct Tube {
  garment::Garment garment = testing::tube_garment(kWidth, kHeight, 60, 45);
  geometry::PathSurface surface = flat_surface(garment);

  LineCourse line(
      const Vec2& from, const Vec2& to, double part = 0.02,
      placement::LineSpec::Course course = placement::LineSpec::Course::shortest) const {
    return lay_course(garment, surface,
                      {placement::pattern_point(garment, "tube", from),
                       placement::pattern_point(garment, "tube", to)},
                      course, part);
  }

  LineState measure(const LineCourse& course, const std::function<Vec3(const Vec2&)>& place,
                    const LineSensor& sensor = {}) const {
    std::vector<Vec3> positions;
    for (const Vec2& uv : garment.vertex_uv) positions.push_back(place(uv));
    const body::PosedBody body(testing::cylinder_body(0.02, 0.3, 24, 10));
    const maps::WornGarment worn;
    const placement::WornState state{0, 0, positions, body, worn};
    fabric::Material material;
    material.thickness = 5e-4;
    return LineMeter(garment, material, state).measure(course, sensor);
  }
};

TEST(Lines, FollowAStretchAndAShear) {
  const Tube tube;
  const LineCourse course = tube.line({0.1, 0.05}, {0.2, 0.2});
  const Vec2 way(0.1, 0.15);
  EXPECT_NEAR(course.length, way.norm(), 1e-7);
  EXPECT_EQ(course.parts, 9);
  const LineState stretched =
      tube.measure(course, [](const Vec2& p) { return Vec3(1.1 * p.x(), 1, 0.95 * p.y()); });
  const double stretch = Vec2(1.1 * way.x(), 0.95 * way.y()).norm() / way.norm() - 1;
  EXPECT_NEAR(stretched.elongation, stretch, 1e-6);
  for (const double part : stretched.parts) EXPECT_NEAR(part, stretch, 1e-6);
  EXPECT_EQ(stretched.slack, 0);
  EXPECT_EQ(stretched.contact, 0);
  const LineState sheared =
      tube.measure(course, [](const Vec2& p) { return Vec3(p.x() + 0.2 * p.y(), 1, p.y()); });
  EXPECT_NEAR(sheared.elongation, Vec2(0.1 + 0.03, 0.15).norm() / way.norm() - 1, 1e-6);
  // Shorter by 2 %, of a sensor that was sewn on stretched by 5 %: not slack.
  const auto shrunk = [](const Vec2& p) { return Vec3(0.98 * p.x(), 1, 0.98 * p.y()); };
  EXPECT_EQ(tube.measure(course, shrunk).slack, 1);
  const LineState pre = tube.measure(course, shrunk, {0, 0.05});
  EXPECT_EQ(pre.slack, 0);
  EXPECT_NEAR(pre.elongation, 1.05 * 0.98 - 1, 1e-6);
}

TEST(Lines, AreLongerOutsideOfTheNeutralAxisOfABend) {
  // Round a cylinder of radius R: 1 + h/R; along it: nothing.
  const Tube tube;
  const double radius = kWidth / (2 * kPi), height = 0.003;
  const auto round = [&](const Vec2& p) {
    return Vec3(radius * std::cos(p.x() / radius), radius * std::sin(p.x() / radius), p.y());
  };
  const LineCourse around = tube.line({0.1, 0.15}, {0.25, 0.15}),
                   along = tube.line({0.2, 0.05}, {0.2, 0.25});
  const double bent = tube.measure(around, round, {height, 0}).elongation -
                      tube.measure(around, round, {0, 0}).elongation;
  EXPECT_NEAR(bent, height / radius, 0.01 * height / radius);
  EXPECT_NEAR(tube.measure(around, round).bend_radius, radius, 0.01 * radius);
  EXPECT_NEAR(tube.measure(along, round, {height, 0}).elongation, 0, 1e-4);
  EXPECT_GT(tube.measure(along, round).bend_radius, 50 * radius);
}

TEST(Lines, OfATubeThatBendsStretchByTheirOffsetOverTheRadius) {
  // The tube's axis bends to an arc of radius Q: the fibre at distance y outside of the axis is
  // stretched by y / Q.
  const Tube tube;
  const double radius = kWidth / (2 * kPi), arc = 0.4;
  const auto bent = [&](const Vec2& p) {
    const double a = p.x() / radius, out = radius * std::cos(a), turn = p.y() / arc;
    return Vec3((arc + out) * std::cos(turn), radius * std::sin(a), (arc + out) * std::sin(turn));
  };
  for (const double u : {0.05, 0.1, 0.2}) {
    const LineCourse course = tube.line({u, 0.05}, {u, 0.25});
    EXPECT_NEAR(tube.measure(course, bent).elongation, radius * std::cos(u / radius) / arc, 3e-4)
        << u;
  }
}

TEST(Lines, CrossSeamsStraightAndTellEachPieceOfThePattern) {
  const Tube tube;
  const LineCourse course = tube.line({0.38, 0.1}, {0.03, 0.14});
  EXPECT_NEAR(course.length, Vec2(0.05, 0.04).norm(), 1e-7);
  const std::vector<PanelStretch> pieces = stretches(tube.garment, course);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_LT((pieces[0].points.back() - Vec2(0.4, 0.116)).norm(), 1e-6);
  EXPECT_LT((pieces[1].points.front() - Vec2(0, 0.116)).norm(), 1e-6);
  EXPECT_EQ(pieces[0].points.size(), 2u) << "only where it bends";
  // The straight line of the pattern stays in the piece, the long way round.
  const LineCourse straight =
      tube.line({0.38, 0.1}, {0.03, 0.14}, 0.02, placement::LineSpec::Course::straight);
  EXPECT_NEAR(straight.length, Vec2(0.35, 0.04).norm(), 1e-6);
}

TEST(Lines, WithoutLengthAreRefused) {
  const Tube tube;
  EXPECT_THROW(tube.line({0.1, 0.1}, {0.1, 0.1}), InvalidInput);
}

LineState state(int posture, int donning, double length) {
  LineState s;
  s.posture = posture, s.donning = donning, s.length = length;
  s.elongation = length / 0.1 - 1;
  s.parts = {s.elongation};
  s.bend_radius = 0.02;
  return s;
}

TEST(Lines, SignalsAreAgainstTheReferenceOfTheirDonning) {
  const std::vector<LineState> states = {state(0, 0, 0.10), state(1, 0, 0.12), state(0, 1, 0.11),
                                         state(1, 1, 0.121)};
  const std::vector<double> found = signals(states);
  EXPECT_NEAR(found[1], 0.2, 1e-12);
  EXPECT_NEAR(found[3], 0.1, 1e-12);
  const auto metrics = line_metrics_by_donning(states, 0.1);
  ASSERT_EQ(metrics.size(), 2u);
  EXPECT_NEAR(metrics[0].at("line_swing"), 0.2, 1e-12);
  EXPECT_NEAR(metrics[1].at("line_swing_mm"), 11, 1e-9);
  EXPECT_NEAR(metrics[1].at("line_donning_shift"), 0.1, 1e-12);
  EXPECT_FALSE(metrics[0].contains("line_donning_shift"));
  // A donning that failed in its reference posture has no signal.
  EXPECT_TRUE(std::isnan(signals({state(1, 0, 0.1)})[0]));
}

TEST(Lines, SensitivityOfAKnownCurve) {
  // 0.2 % per degree, flat from 90 degrees on; the second donning reads 1 % more beyond 0; the
  // shoulder adds 3 %.
  const std::vector<std::string> postures = {
      "elbow-flexion-0",  "elbow-flexion-90",  "elbow-flexion-30",
      "elbow-flexion-60", "elbow-flexion-120", "elbow-flexion-60+shoulder-flexion-45"};
  const double angle[] = {0, 90, 30, 60, 120, 60};
  std::vector<LineState> states;
  std::vector<double> read;
  for (int donning = 0; donning < 2; ++donning)
    for (int p = 0; p < 6; ++p) {
      states.push_back(state(p, donning, 0.1));
      read.push_back(0.002 * std::min(angle[p], 90.0) + (p == 0 ? 0 : 0.01 * donning) +
                     (p == 5 ? 0.03 : 0));
    }
  const auto found = sensitivities(postures, states, read);
  ASSERT_EQ(found.size(), 1u);
  const Sensitivity& s = found[0];
  EXPECT_EQ(s.joint, "elbow-flexion");
  ASSERT_EQ(s.curve.size(), 5u);
  EXPECT_EQ(s.curve[3].degrees, 90);
  EXPECT_NEAR(s.curve[3].mean, 0.185, 1e-12);
  EXPECT_NEAR(s.curve[3].deviation, 0.01 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(s.monotone_from, 0);
  EXPECT_EQ(s.monotone_to, 90);
  EXPECT_TRUE(s.rises);
  ASSERT_EQ(s.cross.size(), 1u);
  EXPECT_NEAR(s.cross[0].change, 0.03, 1e-12);
  EXPECT_NEAR(s.cross[0].degrees, 0.03 / s.gain, 1e-9);
  // Deviations 0, d, d, d over the slope of the means 0, 0.065, 0.125, 0.185.
  const double slope = (1.5 * 0.185 + 0.5 * 0.125 - 0.5 * 0.065) / 5 / 30;
  EXPECT_NEAR(s.angle_error, std::sqrt(0.75) * 0.01 / std::sqrt(2.0) / slope, 1e-9);
  EXPECT_TRUE(sensitivities({"standing", "elbow-flexion-30"}, {state(0, 0, 1)}, {0}).empty());
}

TEST(LinePlaces, AreReadBack) {
  for (const char* text :
       {"wrist_L", "sleeve_L:0.12,-0.3", "left forearm [0, 50, 30]", "chest [50, 100, 70.5]"})
    EXPECT_EQ(placement::parse_place(text).str(), text);
  EXPECT_EQ(placement::parse_place("left upper arm [0, 50, 70]").str(),
            "left upper_arm [0, 50, 70]");
  for (const char* wrong :
       {"", "front:", "front:1", "front:1,2,3", ":1,2", "front:9,0", "forearm [0, 50, 30]",
        "left chest [0, 0, 0]", "chest [0, 0]", "chest [0, 0, 0"})
    EXPECT_THROW(placement::parse_place(wrong), InvalidInput) << wrong;
}

}  // namespace
}  // namespace loosefit::lines
