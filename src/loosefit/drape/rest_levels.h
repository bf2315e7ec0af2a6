#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"

namespace loosefit::drape {

/// Heights on a person as if standing upright: a point goes back with the skin next to it, so that
/// a waistband is at the waist whether its wearer stands, sits or bends. All heights in metres
/// above the soles.
class RestLevels {
 public:
  explicit RestLevels(body::PosedBody body);
  /// A point of cloth as it would be if its wearer stood upright, soles at z = 0 [m]: it goes back
  /// with the nearest skin, arms and hands left out.
  Vec3 at_rest(const Vec3& p) const;
  /// Height of a point of cloth; arms and hands are passed over, for they hang beside everything.
  double of(const Vec3& p) const;
  /// Mean over vertices.
  double of(const std::vector<int>& vertices, const std::vector<Vec3>& x) const;
  /// Distance from the skin, arms and hands included [m].
  double distance(const Vec3& p) const;

  /// Joints as if standing upright, on soles at z = 0 [m].
  std::map<std::string, Vec3> joints() const;

  double height = 0;                                 ///< stature
  double chest = 0, waist = 0, hip = 0, crotch = 0;  ///< hip: where it is widest

 private:
  Vec3 in_rest(int vertex, const Vec3& p) const;
  body::PosedBody body_;
  double soles_ = 0;
};

/// Where on a person a height is: "the chest", "the waist", "the hips", "the thighs", "the knees",
/// "the calves", "the feet", "below the soles".
std::string level_name(double level, const RestLevels& levels);

}  // namespace loosefit::drape
