#include "loosefit/body/stumps.h"

#include <algorithm>
#include <limits>

#include "loosefit/body/laid_skin.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/missing_limb.h"
#include "loosefit/body/surface_topology.h"

namespace loosefit::body {
namespace {

constexpr double kMostRound = 0.03;  // that a stump reaches beyond the last whole ring of skin [m]

/// Measures of arms that need this part of one of them.
const std::map<Segment, std::vector<std::string>>& measures_of_parts() {
  static const std::map<Segment, std::vector<std::string>> kMeasures = {
      {Segment::upper_arm, {"upper_arm"}},
      {Segment::forearm, {"elbow", "forearm", "elbow_length"}},
      {Segment::hand, {}}};
  return kMeasures;
}

/// The surface without these vertices: its largest piece.
geometry::TriangleMesh largest_part(const LaidSkin& laid, const std::vector<char>& lacks) {
  geometry::TriangleMesh rest{laid.surface, {}};
  for (const Triangle& t : laid.triangles)
    if (!lacks[std::size_t(t[0])] && !lacks[std::size_t(t[1])] && !lacks[std::size_t(t[2])])
      rest.triangles.push_back(t);
  std::vector<int> largest = connected_pieces(rest).front().triangles;
  std::ranges::sort(largest);
  std::vector<Triangle> kept;
  for (const int t : largest) kept.push_back(rest.triangles[std::size_t(t)]);
  rest.triangles = std::move(kept);
  return rest;
}

const MissingLimb& nearest_end(const std::vector<MissingLimb>& missing, const Vec3& p) {
  return *std::ranges::min_element(missing, {},
                                   [&](const MissingLimb& m) { return (m.end - p).norm(); });
}

}  // namespace

Eigen::Matrix<double, 3, 4> Stumps::mean_map(const std::vector<int>& rim, const Maps& maps) {
  Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
  for (const int v : rim) sum += maps[std::size_t(v)];
  return sum / double(rim.size());
}

Stumps::Stumps(const LaidSkin& laid, const RigidMotion& place,
               const std::vector<MissingLimb>& missing) {
  std::vector<char> lacks(laid.surface.size(), 0);
  for (const MissingLimb& limb : missing) {
    names_.push_back(limb.name());
    for (const int v : limb.vertices) lacks[std::size_t(v)] = 1;
  }
  // Measures of arms that both sides lack. The wrist closes forearm and arm.
  const auto both = [&](const auto& lacks_it) {
    return std::ranges::count_if(missing, [&](const MissingLimb& m) {
             return m.side != 0 && !m.of_leg() && lacks_it(m);
           }) > 1;
  };
  for (const auto& [part, measures] : measures_of_parts())
    if (both([&](const MissingLimb& m) { return m.first <= part; }))
      unmeasured_.insert(unmeasured_.end(), measures.begin(), measures.end());
  if (both([](const MissingLimb& m) { return m.above_wrist; }))
    unmeasured_.insert(unmeasured_.end(), {"wrist", "arm_length"});
  const geometry::TriangleMesh rest = largest_part(laid, lacks);
  std::vector<int> number(laid.surface.size(), -1);
  for (const Triangle& t : rest.triangles)
    for (const int v : t) number[std::size_t(v)] = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == 0) number[v] = int(kept_.size()), kept_.push_back(int(v));
  for (const Triangle& t : rest.triangles)
    triangles_.push_back(
        {number[std::size_t(t[0])], number[std::size_t(t[1])], number[std::size_t(t[2])]});
  for (const Hole& hole : find_holes(rest)) {
    Cap cap;
    cap.rim = hole.rim;
    // As far out of the plane of the rim as the scan reaches.
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < hole.rim.size(); ++i) {
      const auto a = std::size_t(hole.rim[i]), b = std::size_t(hole.rim[(i + 1) % hole.rim.size()]);
      normal += (laid.surface[a] - hole.centre).cross(laid.surface[b] - hole.centre);
    }
    normal.normalize();
    const MissingLimb& limb = nearest_end(missing, hole.centre);
    const Vec3 tip =
        hole.centre + std::clamp(normal.dot(limb.end - hole.centre), 0.0, kMostRound) * normal;
    Eigen::Affine3d map;
    map.matrix().topRows<3>() = mean_map(cap.rim, laid.maps);
    map.makeAffine();
    cap.rest = map.inverse() * (place.inverse() * tip);
    cap.joint = std::string(limb.of_leg() ? "leg_end" : "arm_end") + (limb.side > 0 ? "_L" : "_R");
    const int middle = int(kept_.size() + caps_.size());
    for (std::size_t i = 0; i < hole.rim.size(); ++i)
      triangles_.push_back({number[std::size_t(hole.rim[i])],
                            number[std::size_t(hole.rim[(i + 1) % hole.rim.size()])], middle});
    caps_.push_back(std::move(cap));
  }
}

std::vector<Vec3> Stumps::without(const std::vector<Vec3>& vertices, const Maps& maps) const {
  return without(vertices, maps, Vec3::Zero());
}

std::vector<Vec3> Stumps::without(const std::vector<Vec3>& vertices, const Maps& maps,
                                  const Vec3& floor) const {
  std::vector<Vec3> there;
  for (const int v : kept_) there.push_back(vertices[std::size_t(v)]);
  for (const Cap& cap : caps_)
    there.push_back(mean_map(cap.rim, maps) * (cap.rest - floor).homogeneous());
  return there;
}

std::map<std::string, double> Stumps::without(std::map<std::string, double> measured,
                                              const std::vector<Vec3>& whole) const {
  for (const std::string& name : unmeasured_) measured.erase(name);
  geometry::TriangleMesh rest{{}, triangles_};
  for (const int v : kept_) rest.vertices.push_back(whole[std::size_t(v)]);
  for (const Cap& cap : caps_) rest.vertices.push_back(cap.rest);
  const double volume = geometry::enclosed_volume(rest);
  measured["mass"] *= volume / measured["volume"];
  measured["volume"] = volume;
  return measured;
}

Body Stumps::without(const Body& whole, double floor) const {
  Body body = whole;
  body.surface.vertices = without(whole.surface.vertices, whole.pose_from_rest, Vec3(0, 0, floor));
  body.surface.triangles = triangles_;
  body.segment.clear(), body.side.clear(), body.pose_from_rest.clear();
  const auto take = [&](std::size_t v) {
    body.segment.push_back(whole.segment[v]);
    body.side.push_back(whole.side[v]);
  };
  std::map<int, int> number;
  for (const int v : kept_) {
    number[v] = int(body.segment.size());
    take(std::size_t(v));
    body.pose_from_rest.push_back(whole.pose_from_rest[std::size_t(v)]);
  }
  for (std::size_t c = 0; c < caps_.size(); ++c) {
    take(std::size_t(caps_[c].rim[0]));
    body.pose_from_rest.push_back(mean_map(caps_[c].rim, whole.pose_from_rest));
    body.joints[caps_[c].joint] = body.surface.vertices[kept_.size() + c];
  }
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  body.landmarks.clear(), body.landmark_vertex.clear();
  for (const auto& [name, v] : whole.landmark_vertex)
    if (const auto found = number.find(v); found != number.end()) {
      body.landmark_vertex[name] = found->second;
      body.landmarks[name] = body.surface.vertices[std::size_t(found->second)];
    }
  return body;
}

std::string ends_in_words(const std::map<std::string, Vec3>& joints) {
  std::string words;
  for (const auto& [end, limb] :
       {std::pair("arm_end_L", "left arm"), std::pair("arm_end_R", "right arm"),
        std::pair("leg_end_L", "left leg"), std::pair("leg_end_R", "right leg")})
    if (joints.count(end))
      words += std::string(words.empty() ? ", which lacks the end of the " : " and the ") + limb;
  return words;
}

bool is_beyond_end(const std::map<std::string, Vec3>& joints, const std::string& joint) {
  const std::string side = joint.substr(joint.size() - 2);
  const std::string name = joint.substr(0, joint.size() - 2);
  for (const auto& [end_name, line] :
       {std::pair(std::string("arm_end"),
                  std::vector<std::string>{"shoulder", "elbow", "wrist", "hand"}),
        std::pair(std::string("leg_end"), std::vector<std::string>{"hip", "knee", "ankle"})}) {
    const auto end = joints.find(end_name + side);
    const auto own = std::ranges::find(line, name);
    if (end == joints.end() || own == line.end()) continue;
    // The end lies on the part of the line that is nearest to it.
    constexpr double kAtJoint = 0.03;  // of the part before it
    double nearest = std::numeric_limits<double>::infinity(), station = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const auto a = joints.find(line[i] + side), b = joints.find(line[i + 1] + side);
      if (a == joints.end() || b == joints.end()) continue;
      const Vec3 way = b->second - a->second;
      const double share = std::clamp(
          way.dot(end->second - a->second) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
      const double away = (a->second + share * way - end->second).norm();
      if (away < nearest - 1e-9) nearest = away, station = double(i) + share;
    }
    return double(own - line.begin()) > station + kAtJoint;
  }
  return false;
}

}  // namespace loosefit::body
