#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/rest_body.h"

namespace loosefit::body {

/// Takes measures [m] of a body in the rest posture. Girths are tape girths: perimeters of convex
/// hulls of plane sections, at levels that follow the anatomy (docs/theory/body_model.md 3.2, 3.3).
class BodyTape {
 public:
  /// Keeps references.
  BodyTape(const BodyData& data, const RestBody& rest) : data_(data), rest_(rest) {}

  /// One of measure_names(). \throws InvalidInput for an unknown name, GeometryError when a section
  /// has no loop there.
  double measure(const std::string& name) const;

  /// Everything a pattern or a report wants, measure_names() included, and levels above the floor
  /// ("chest_level", "waist_level", "hip_level", "armpit_level"), "armscye", "shoulder_slope"
  /// [rad], "volume" [m³] and "mass" [kg].
  std::map<std::string, double> all() const;

  /// Girth of the limb round `bone_a`.head → `bone_b`.head at share t.
  double limb_girth(const std::string& bone_a, const std::string& bone_b, double t) const;
  /// Where the arm is usually fullest or, where trunk and arm are one there, below.
  double upper_arm_girth() const;

 private:
  double ring_girth(const std::string& ruler_name) const;
  double armpit_height() const;
  const Vec3& vertex(int index) const { return rest_.surface.vertices[std::size_t(index)]; }
  const Vec3& joint(const std::string& bone) const;
  double floor() const;

  const BodyData& data_;
  const RestBody& rest_;
};

/// What can be measured and asked for in a fit: "height", "chest", "underbust", "waist", "hip",
/// "neck" (round the neck base, what a draft needs), "mid_neck" (collar), "upper_arm", "forearm",
/// "wrist", "thigh", "knee", "calf", "ankle", "shoulder_breadth", "arm_length", "back_length",
/// "crotch_height".
const std::vector<std::string>& measure_names();

}  // namespace loosefit::body
