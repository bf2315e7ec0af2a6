#include "loosefit/body/breath.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit::body {
namespace {

constexpr double kChestLevel = 0.6;   ///< of the way from pelvis to neck
constexpr double kReach = 0.38;       ///< from there to where nothing moves, up and down
constexpr double kStillBeside = 1.3;  ///< of half the breadth of the shoulder joints: nothing moves
constexpr double kWholeWithin = 0.8;  ///< all of it within

double smooth_step(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// The trunk as breathing sees it.
class Trunk {
 public:
  explicit Trunk(const Body& body) {
    for (const char* joint : {"pelvis", "neck", "shoulder_L", "shoulder_R"})
      if (body.joints.count(joint) == 0)
        throw InvalidInput(std::string("a body without the joint ") + joint + " cannot breathe");
    pelvis_ = body.joints.at("pelvis");
    const Vec3 spine = body.joints.at("neck") - pelvis_;
    length_ = spine.norm();
    up_ = spine / length_;
    forward_ = Vec3::UnitX().cross(up_).normalized();  // x to the left: −y of an upright wearer
    // Both shoulders: of a trunk that turns or bends aside one is nearer to the middle.
    half_breadth_ =
        0.5 * std::abs(body.joints.at("shoulder_L").x() - body.joints.at("shoulder_R").x());
  }

  /// How much of the whole deepening a place takes part in.
  double share(const Vec3& p) const {
    const double height = (p - pelvis_).dot(up_) / length_;
    const double beside = std::abs(p.x() - pelvis_.x()) / half_breadth_;
    const double off = std::min(1.0, std::abs(height - kChestLevel) / kReach);
    return std::pow(std::cos(0.5 * kPi * off), 2) *
           smooth_step((kStillBeside - beside) / (kStillBeside - kWholeWithin));
  }
  double depth(const Vec3& p) const { return (p - pelvis_).dot(forward_); }
  const Vec3& up() const { return up_; }
  const Vec3& forward() const { return forward_; }

  /// Points of the section at the chest, of the trunk alone.
  std::vector<Vec3> chest(const Body& body) const {
    const Vec3 middle = pelvis_ + kChestLevel * length_ * up_;
    const auto loops = plane_section(body.surface, middle, up_);
    std::vector<Vec3> points;
    for (const SectionLoop& loop : loops)
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        if (body.segment[std::size_t(loop.edges[i][0])] == Segment::torso)
          points.push_back(loop.points[i]);
    if (points.size() < 8) throw InvalidInput("a body without a chest cannot breathe");
    return points;
  }

 private:
  Vec3 pelvis_, up_, forward_;
  double length_ = 1, half_breadth_ = 1;
};

double girth(const Trunk& trunk, const std::vector<Vec3>& points) {
  return hull_perimeter(points, trunk.up());
}

/// Deepening at which the girth of the chest has grown by so much; both are small, so two steps of
/// the secant rule do.
double deepening(const Trunk& trunk, const std::vector<Vec3>& chest, double growth) {
  const double before = girth(trunk, chest);
  const auto grown = [&](double depth) {
    std::vector<Vec3> points = chest;
    for (Vec3& p : points) p += depth * trunk.share(p) * trunk.depth(p) * trunk.forward();
    return girth(trunk, points) / before - 1;
  };
  double depth = 2 * growth;
  for (int k = 0; k < 3; ++k) {
    const double found = grown(depth);
    if (!(found / growth > 0.01)) throw InvalidInput("a chest that breathing does not widen");
    depth *= growth / found;
  }
  return depth;
}

}  // namespace

Body inhaled(Body body, double growth) {
  if (growth == 0) return body;
  const Trunk trunk(body);
  const double depth = deepening(trunk, trunk.chest(body), growth);
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v) {
    Vec3& p = body.surface.vertices[v];
    const double own = depth * trunk.share(p);
    if (own == 0) continue;
    const Vec3 before = p;
    p += own * trunk.depth(p) * trunk.forward();
    if (body.pose_from_rest.empty()) continue;
    const Mat3 stretch = Mat3::Identity() + own * trunk.forward() * trunk.forward().transpose();
    auto& map = body.pose_from_rest[v];
    map = stretch * map;
    map.col(3) += p - stretch * before;
  }
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  for (const auto& [name, v] : body.landmark_vertex)
    body.landmarks[name] = body.surface.vertices[static_cast<std::size_t>(v)];
  return body;
}

double breathing_girth(const Body& body) {
  const Trunk trunk(body);
  return girth(trunk, trunk.chest(body));
}

}  // namespace loosefit::body
