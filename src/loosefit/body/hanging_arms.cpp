#include "loosefit/body/hanging_arms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

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

/// One arm beside its half of the body; the right one is seen in the mirror, as a left one.
class HangingArm {
 public:
  /// side: +1 the wearer's left, -1 the right
  HangingArm(const BodyData& data, const RestBody& rest, const BodySkin& skin,
             const Posture& posture, int side)
      : data_(data), rest_(rest), skin_(skin), posture_(posture), side_(side) {
    const auto joint = [&](const std::string& bone) {
      const int index = data.bone(bone + (side > 0 ? ".L" : ".R"));
      return rest.joints[std::size_t(data.bones[std::size_t(index)].head)];
    };
    const Vec3 shoulder = joint("upperarm01"), upper = joint("lowerarm01") - shoulder;
    const auto bones = bones_at(posture.arm_abduction);
    for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v) {
      const Segment part = skin.segment[v];
      if (part == Segment::torso || part == Segment::thigh) {
        profile_.add(posed(bones, v));
      } else if (skin.side[v] == side && is_beside_trunk(part, v, shoulder, upper)) {
        arm_.push_back(v);
      }
    }
  }

  /// How far aside it hangs.
  double clear() const {
    const double asked = posture_.arm_abduction;
    double low = asked, high = kMostAside;
    if (low >= high || is_clear(low) || !is_clear(high)) return asked;
    while (high - low > kAngleError) {
      const double middle = 0.5 * (low + high);
      (is_clear(middle) ? high : low) = middle;
    }
    return asked + posture_.relaxed_arms * (high - asked);
  }

 private:
  bool is_clear(double abduction) const { return room(abduction) >= kRoomBesideTrunk; }
  double room(double abduction) const {
    const auto bones = bones_at(abduction);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t v : arm_) least = std::min(least, profile_.room(posed(bones, v)));
    return least;
  }
  bool is_beside_trunk(Segment part, std::size_t v, const Vec3& shoulder, const Vec3& upper) const {
    if (part == Segment::forearm || part == Segment::hand) return true;
    return part == Segment::upper_arm &&
           (rest_.surface.vertices[v] - shoulder).dot(upper) > kArmpitShare * upper.squaredNorm();
  }
  std::vector<Eigen::Affine3d> bones_at(double abduction) const {
    return pose_bones(
        data_, rest_.joints,
        posture_rotations(data_, rest_.joints, posture_, ArmsAside{abduction, abduction}));
  }
  Vec3 posed(const std::vector<Eigen::Affine3d>& bones, std::size_t v) const {
    Vec3 p = Vec3::Zero();
    for (const auto& [bone, weight] : skin_.weights[v])
      p += weight * (bones[std::size_t(bone)] * rest_.surface.vertices[v]);
    p.x() *= side_;
    return p;
  }

  const BodyData& data_;
  const RestBody& rest_;
  const BodySkin& skin_;
  Posture posture_;
  int side_;
  SideProfile profile_;
  std::vector<std::size_t> arm_;
};

}  // namespace

ArmsAside clear_arms(const BodyData& data, const RestBody& rest, const BodySkin& skin,
                     const Posture& posture) {
  if (posture.relaxed_arms == 0) return {posture.arm_abduction, posture.arm_abduction};
  const auto clear = [&](int side) { return HangingArm(data, rest, skin, posture, side).clear(); };
  return {clear(1), clear(-1)};
}

}  // namespace loosefit::body
