#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/geometry/closest_point.h"
#include "loosefit/placement/address_landmarks.h"

namespace loosefit::placement {

/// Segments with an anatomical address (UNISEP, Shirazi et al. 2024; docs/theory/sensor_metrics.md
/// 9).
enum class BodySegment { chest, abdomen, upper_arm, forearm, thigh, lower_leg };

const std::vector<BodySegment>& all_body_segments();
/// "chest", "upper_arm", …
std::string name(BodySegment segment);
/// chest and abdomen have no side.
bool has_side(BodySegment segment);

/// Place on a person that means the same on every person: segment and three ratios.
struct BodyAddress {
  BodySegment segment = BodySegment::chest;
  int side = 0;                 ///< +1 wearer's left, −1 right, 0 for chest and abdomen
  Vec3 percent = Vec3::Zero();  ///< X, Y, Z [%] of SegmentAxes
  /// "chest [50, 100, 70]", "left forearm [0, 50, 30]": percents to a tenth.
  std::string str() const;
};

/// The three axes of a segment: unit and square to each other, each with the coordinates at which
/// its ratio is 0 and 100 %, those of two landmarks:
///
/// | segment   | X                           | Y                      | Z                        |
/// |-----------|-----------------------------|------------------------|--------------------------|
/// | chest     | left → right acromion       | C7 → xiphoid (depth)   | C7 → xiphoid (downwards) |
/// | abdomen   | left → right ASIS           | mid ASIS → mid PSIS    | navel → xiphoid          |
/// | upper_arm | medial → lateral epicondyle | olecranon → c. fossa   | elbow joint → acromion   |
/// | forearm   | medial → lateral wrist      | olecranon → c. fossa   | wrist → lat. epicondyle  |
/// | thigh     | medial → lateral knee       | popliteal → patella    | knee joint → trochanter  |
/// | lower_leg | medial → lateral malleolus  | popliteal → patella    | ankle joint → patella    |
///
/// X of a limb is told for the right side; on the left it runs from lateral to medial, so that it
/// always runs from the wearer's left to the right. The forearm is taken as pronated: its lateral
/// side (100 right, 0 left) is the back of the wrist of a hanging arm. Skin beyond the landmarks
/// has ratios below 0 or above 100.
struct SegmentAxes {
  Mat3 axes = Mat3::Identity();  ///< columns X, Y, Z
  Vec3 low = Vec3::Zero(), high = Vec3::Ones();
  Vec3 percent(const Vec3& point) const;
  Vec3 point(const Vec3& percent) const;
};

/// Anatomical addresses on one body in its posture. Keeps a reference to the body.
class BodyAddresses {
 public:
  explicit BodyAddresses(const body::Body& body);

  /// Axes of a segment; nothing when the body lacks landmarks or joints for them.
  std::optional<SegmentAxes> axes(BodySegment segment, int side) const;
  /// Address of a point of the skin: chest above the xiphoid, abdomen below it, head and neck with
  /// the chest, hands and feet with forearm and lower leg. Nothing without axes.
  std::optional<BodyAddress> address(const geometry::ClosestPoint& skin) const;
  /// The skin at an address. Skin within half a millimetre of the point is taken as it is;
  /// otherwise the point is moved square to Z, away from or towards the middle of the segment
  /// (X = Y = 50), to the nearest skin of the segment. \throws InvalidInput, key "segment",
  /// "side" or "ratios": side missing or too much, no axes on this body, a point in the middle of
  /// the segment, no skin there (with the nearest address on the segment).
  geometry::ClosestPoint skin(const BodyAddress& address) const;

  /// Landmarks of the body and those of address_landmarks().
  const std::map<std::string, Vec3>& landmarks() const { return landmarks_; }
  const body::Body& body() const { return body_; }

 private:
  bool belongs(int vertex, const BodyAddress& address) const;
  geometry::ClosestPoint nearest(const Vec3& point, const BodyAddress& address) const;
  const body::Body& body_;
  std::map<std::string, Vec3> landmarks_;
};

}  // namespace loosefit::placement
