#include "loosefit/body/hanging_arms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "loosefit/body/skeleton_pose.h"

namespace loosefit::body {
namespace {

constexpr double kCell = 0.01;  ///< of depth and height; the skin has a vertex in each [m]
constexpr double kMostAside = radians(60);
constexpr double kAngleError = radians(0.05);

using Weights = std::vector<std::pair<int, double>>;

/// How far trunk and thighs reach to the left, by depth and height.
class SideProfile {
 public:
  void add(const Vec3& p) {
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const auto entry = reach_.try_emplace(key(p, y, z), p.x()).first;
        entry->second = std::max(entry->second, p.x());
      }
  }
  /// From there to the point, to the left; infinite where there is neither trunk nor thigh.
  double room(const Vec3& p) const {
    const auto found = reach_.find(key(p, 0, 0));
    return found == reach_.end() ? std::numeric_limits<double>::infinity() : p.x() - found->second;
  }

 private:
  static long key(const Vec3& p, int y, int z) {
    return (std::lround(p.y() / kCell) + y) * 100000 + std::lround(p.z() / kCell) + z;
  }
  std::unordered_map<long, double> reach_;
};

class HangingArm {
 public:
  HangingArm(const BodyData& data, const RestBody& rest, const BodySkin& skin,
             const Posture& posture)
      : data_(data), rest_(rest), skin_(skin), posture_(posture) {
    const auto joint = [&](const char* bone) {
      return rest.joints[std::size_t(data.bones[std::size_t(data.bone(bone))].head)];
    };
    const Vec3 shoulder = joint("upperarm01.L"), upper = joint("lowerarm01.L") - shoulder;
    const auto bones = bones_at(posture.arm_abduction);
    for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v) {
      const Segment part = skin.segment[v];
      if (part == Segment::torso || part == Segment::thigh) {
        profile_.add(posed(bones, v));
      } else if (skin.side[v] > 0 && is_beside_trunk(part, v, shoulder, upper)) {
        arm_.push_back(v);
      }
    }
  }

  double room(double abduction) const {
    const auto bones = bones_at(abduction);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t v : arm_) least = std::min(least, profile_.room(posed(bones, v)));
    return least;
  }

 private:
  bool is_beside_trunk(Segment part, std::size_t v, const Vec3& shoulder, const Vec3& upper) const {
    if (part == Segment::forearm || part == Segment::hand) return true;
    return part == Segment::upper_arm &&
           (rest_.surface.vertices[v] - shoulder).dot(upper) > kArmpitShare * upper.squaredNorm();
  }
  std::vector<Eigen::Affine3d> bones_at(double abduction) const {
    Posture posture = posture_;
    posture.arm_abduction = abduction;
    return pose_bones(data_, rest_.joints, posture_rotations(data_, rest_.joints, posture));
  }
  Vec3 posed(const std::vector<Eigen::Affine3d>& bones, std::size_t v) const {
    Vec3 p = Vec3::Zero();
    for (const auto& [bone, weight] : skin_.weights[v])
      p += weight * (bones[std::size_t(bone)] * rest_.surface.vertices[v]);
    return p;
  }

  const BodyData& data_;
  const RestBody& rest_;
  const BodySkin& skin_;
  Posture posture_;
  SideProfile profile_;
  std::vector<std::size_t> arm_;
};

}  // namespace

Posture with_clear_arms(const BodyData& data, const RestBody& rest, const BodySkin& skin,
                        const Posture& posture) {
  if (posture.relaxed_arms == 0) return posture;
  const HangingArm arm(data, rest, skin, posture);
  const auto is_clear = [&](double abduction) { return arm.room(abduction) >= kRoomBesideTrunk; };
  double low = posture.arm_abduction, high = kMostAside;
  if (low >= high || is_clear(low) || !is_clear(high)) return posture;
  while (high - low > kAngleError) {
    const double middle = 0.5 * (low + high);
    (is_clear(middle) ? high : low) = middle;
  }
  Posture clear = posture;
  clear.arm_abduction += posture.relaxed_arms * (high - posture.arm_abduction);
  return clear;
}

}  // namespace loosefit::body
