#include "loosefit/validate/other_bodies.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::validate {
namespace {

constexpr double kSeam = 0.08;  ///< breadth over which halves are blended [m]

void renew_surface(body::Body& body) {
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  for (auto& [name, place] : body.landmarks)
    if (const auto vertex = body.landmark_vertex.find(name); vertex != body.landmark_vertex.end())
      place = body.surface.vertices[vertex->second];
}

}  // namespace

body::Body halves(const body::Body& left, const body::Body& right) {
  if (left.surface.vertices.size() != right.surface.vertices.size())
    throw InvalidInput("halves of two bodies", "two postures of one person");
  body::Body body = left;
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v) {
    // Limbs by their side, however far they reach; the trunk by its place.
    const double x = left.surface.vertices[v].x();
    const double share =
        left.side[v] != 0 ? (left.side[v] < 0 ? 1.0 : 0.0) : std::clamp(0.5 - x / kSeam, 0.0, 1.0);
    body.surface.vertices[v] += share * (right.surface.vertices[v] - left.surface.vertices[v]);
    if (!body.pose_from_rest.empty())
      body.pose_from_rest[v] += share * (right.pose_from_rest[v] - left.pose_from_rest[v]);
  }
  for (auto& [name, place] : body.joints)
    if (name.ends_with("_R")) place = right.joints.at(name);
  renew_surface(body);
  return body;
}

body::Body with_shoulder_slope(body::Body body, double more) {
  if (more == 0) return body;
  const double neck = body.landmarks.at("hps_L").x(), tip = body.landmarks.at("acromion_L").x();
  const double armpit = body.measured.at("armpit_level"), waist = body.measured.at("waist_level");
  const double slope = body.measured.at("shoulder_slope");
  const double drop = std::tan(slope + more) - std::tan(slope);  // per length from the neck
  const auto lowered = [&](const Vec3& p, bool arm) {
    const double along = arm ? tip - neck : std::clamp(std::abs(p.x()) - neck, 0.0, tip - neck);
    const double upright = arm ? 1 : std::clamp((p.z() - waist) / (armpit - waist), 0.0, 1.0);
    return -drop * along * upright;
  };
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v) {
    using Segment = loosefit::body::Segment;
    const Segment segment = body.segment[v];
    if (segment == Segment::thigh || segment == Segment::shank || segment == Segment::foot)
      continue;
    const bool arm =
        segment == Segment::upper_arm || segment == Segment::forearm || segment == Segment::hand;
    const double dz = lowered(body.surface.vertices[v], arm);
    body.surface.vertices[v].z() += dz;
    if (!body.pose_from_rest.empty()) body.pose_from_rest[v](2, 3) += dz;
  }
  for (const char* joint : {"shoulder", "elbow", "wrist"})
    for (const char* side : {"_L", "_R"})
      if (const auto found = body.joints.find(std::string(joint) + side);
          found != body.joints.end())
        found->second.z() += lowered(found->second, true);
  body.measured["shoulder_slope"] = slope + more;
  renew_surface(body);
  return body;
}

body::BodyPath sloped_way(const body::BodyPath& way, double more) {
  if (!way || more == 0) return way;
  return
      [way, more](double share) { return body::PosedBody(with_shoulder_slope(way(share), more)); };
}

}  // namespace loosefit::validate
