#include "loosefit/validate/bent_arm.h"

#include <Eigen/Geometry>
#include <cmath>

namespace loosefit::validate {
namespace {

constexpr int kAround = 96, kAlong = 180;  ///< facets of the skin: chords rise by 0.02 mm
constexpr double kStandOff = 0.02;         ///< of the placed pieces from the skin [m]

/// Of the middle line: where it is, and the turn of the section there, both in the arm's plane.
struct Station {
  Vec3 place;
  double angle;  ///< bent so far [rad]
};

/// The middle line lies in the plane of x and z, along +x up to the elbow, then bends downwards.
Station station(const BentArm& arm, double s, double bend) {
  const double arc = arm.turn_radius * bend, start = arm.upper_length - 0.5 * arc;
  if (s <= start || bend <= 0) return {Vec3(s, 0, 0), 0};
  const double turned = std::min(bend, (s - start) / arm.turn_radius);
  Vec3 place(start + arm.turn_radius * std::sin(turned), 0,
             -arm.turn_radius * (1 - std::cos(turned)));
  const double rest = std::max(0.0, s - start - arc);
  place += rest * Vec3(std::cos(bend), 0, -std::sin(bend));
  return {place, turned};
}

}  // namespace

double BentArm::radius(double s) const {
  return s < upper_length
             ? shoulder_radius + (elbow_radius - shoulder_radius) * s / upper_length
             : elbow_radius + (wrist_radius - elbow_radius) * (s - upper_length) / fore_length;
}

Vec3 BentArm::straight() const { return {std::cos(raise), 0, std::sin(raise)}; }

body::Body BentArm::at(double share) const {
  const double length = upper_length + fore_length;
  const Mat3 raised = Eigen::AngleAxisd(-raise, Vec3::UnitY()).toRotationMatrix();
  body::Body body;
  auto& x = body.surface.vertices;
  const auto add = [&](double s, const Vec3& off) {  // `off` in the section of the straight arm
    const Station to = station(*this, s, share * bend);
    const Mat3 turn = raised * Eigen::AngleAxisd(to.angle, Vec3::UnitY()).toRotationMatrix();
    const Vec3 rest = raised * (Vec3(s, 0, 0) + off);
    x.push_back(raised * to.place + turn * off);
    Eigen::Matrix<double, 3, 4> map;
    map.leftCols<3>() = turn * raised.transpose();
    map.col(3) = x.back() - map.leftCols<3>() * rest;
    body.pose_from_rest.push_back(map);
    body.segment.push_back(s < upper_length ? body::Segment::upper_arm : body::Segment::forearm);
    body.side.push_back(1);
  };
  for (int j = 0; j <= kAlong; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double s = length * j / kAlong, a = 2 * kPi * i / kAround;
      add(s, radius(s) * Vec3(0, std::cos(a), std::sin(a)));
    }
  const int shoulder = static_cast<int>(x.size());
  add(0, Vec3::Zero());
  add(length, Vec3::Zero());
  // Outwards: round the arm, then along it.
  const auto id = [](int i, int j) { return j * kAround + i % kAround; };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAlong; ++j) {
      body.surface.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      body.surface.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
    body.surface.triangles.push_back({shoulder, id(i + 1, 0), id(i, 0)});
    body.surface.triangles.push_back({shoulder + 1, id(i, kAlong), id(i + 1, kAlong)});
  }
  body.normals = geometry::vertex_normals(x, body.surface.triangles);
  body.joints["shoulder_L"] = x[shoulder];
  body.joints["elbow_L"] = raised * station(*this, upper_length, share * bend).place;
  body.joints["wrist_L"] = x[shoulder + 1];
  return body;
}

body::BodyPath BentArm::path() const {
  return [arm = *this](double share) { return body::PosedBody(arm.at(share)); };
}

pattern::Pattern BentArm::sleeve(double ease, double from, double to) const {
  const double middle = 0.5 * (from + to);
  const auto half_width = [&](double s) { return 0.5 * (1 + ease) * kPi * radius(s); };
  // y towards the shoulder; counter-clockwise from the lower left, with a corner at the elbow.
  const double y0 = middle - to, y1 = middle - upper_length, y2 = middle - from;
  const double w0 = half_width(to), w1 = half_width(upper_length), w2 = half_width(from);
  pattern::Pattern pattern;
  pattern.name = "sleeve";
  for (const bool front : {true, false}) {
    pattern::Panel panel;
    panel.name = front ? "front" : "back";
    panel.vertices = {{-w0, y0}, {w0, y0}, {w1, y1}, {w2, y2}, {-w2, y2}, {-w1, y1}};
    for (int i = 0; i < 6; ++i) {
      pattern::PanelEdge edge;
      edge.start = i, edge.end = (i + 1) % 6;
      edge.name = "edge_" + std::to_string(i);
      panel.edges.push_back(edge);
    }
    const Vec3 out = front ? Vec3(0, -1, 0) : Vec3(0, 1, 0), up = -straight();
    panel.rotation.col(0) = up.cross(out);
    panel.rotation.col(1) = up;
    panel.rotation.col(2) = out;
    panel.translation = middle * straight() + (shoulder_radius + kStandOff) * out;
    pattern.panels.push_back(panel);
  }
  // Sides below and above the elbow: the right one of the front to the left one of the back.
  for (const auto& [a, b] : {std::pair(1, 5), {2, 4}, {4, 2}, {5, 1}})
    pattern.stitches.push_back({{0, a}, {1, b}, false, "side_" + std::to_string(a)});
  pattern.panel_order = {0, 1};
  return pattern;
}

}  // namespace loosefit::validate
