#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::body {

struct MissingLimb;
struct LaidSkin;

/// How a person without some limbs differs from the model: which skin is there, and what closes it
/// where limbs end. The same in every posture. Joints of what is missing stay, as places in the air
/// that sleeves and legs of garments are laid along; joints "arm_end_L", "leg_end_R" and so on tell
/// where a limb ends.
class Stumps {
 public:
  using Maps = std::vector<Eigen::Matrix<double, 3, 4>>;  ///< rest → posed, per vertex

  /// `laid`: the whole person, standing where it was scanned.
  Stumps(const LaidSkin& laid, const RigidMotion& place, const std::vector<MissingLimb>& missing);

  /// The names of MissingLimb: "left forearm and hand".
  const std::vector<std::string>& names() const { return names_; }
  /// What a whole body in some posture is without the limbs. `floor`: height of the lowest skin in
  /// the rest posture, from which the body's maps count [m].
  Body without(const Body& whole, double floor) const;
  /// The same of vertices and maps of a whole surface alone.
  std::vector<Vec3> without(const std::vector<Vec3>& vertices, const Maps& maps) const;
  /// Measures of the whole person without what nobody can measure: girths and lengths that both
  /// sides lack; volume and mass of what is there. One side that is there tells for both.
  /// `whole`: the surface in the rest posture.
  std::map<std::string, double> without(std::map<std::string, double> measured,
                                        const std::vector<Vec3>& whole) const;

 private:
  /// Closes the skin round the end of a limb: a fan from the rim to one vertex.
  struct Cap {
    std::vector<int> rim;  ///< vertices of the whole surface
    Vec3 rest;             ///< the vertex in the rest posture, by the mean map of the rim
    std::string joint;     ///< "arm_end_L"
  };
  static Eigen::Matrix<double, 3, 4> mean_map(const std::vector<int>& rim, const Maps& maps);
  std::vector<Vec3> without(const std::vector<Vec3>& vertices, const Maps& maps,
                            const Vec3& floor) const;

  std::vector<std::string> names_;
  std::vector<std::string> unmeasured_;  ///< names of measures
  std::vector<int> kept_;  ///< vertices of the whole surface; those of the caps follow them
  std::vector<Triangle> triangles_;
  std::vector<Cap> caps_;
};

/// Whether a joint of a limb ("elbow_L", "ankle_R") lies beyond the end of that limb, by the joints
/// "arm_end_L", … of Stumps.
bool is_beyond_end(const std::map<std::string, Vec3>& joints, const std::string& joint);

/// ", which lacks the end of the left arm": to be added to what is expected of a body; empty where
/// nothing is missing.
std::string ends_in_words(const std::map<std::string, Vec3>& joints);

}  // namespace loosefit::body
