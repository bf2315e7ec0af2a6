#include "loosefit/kinds/shirt/elbow_dart.h"

#include <Eigen/Geometry>
#include <cmath>
#include <tuple>

namespace loosefit::kinds {
namespace {

constexpr double kLeastIntake = 0.005;  // [m]

}  // namespace

bool take_elbow_dart(SleeveHalf& front, SleeveHalf& back, double level, double girth, double bend) {
  // A tube of radius r is longer by r times the bend along its outside than at its seams; the
  // middle of the half opens by half of what its edge does.
  const double radius = girth / (2 * kPi), intake = 2 * radius * radians(bend);
  if (intake < kLeastIntake) return false;
  const double down = back.under.length_until(1, level);
  const auto [above, below] = back.under.cut(down);
  const Vec2 hinge(0, level), mouth = above.end();
  const double angle = 2 * std::asin(0.5 * intake / mouth.x());

  back.under = above;
  back.under_below = below.turned(hinge, -angle);
  const Vec2 tip = hinge + 0.5 * (Eigen::Rotation2Dd(-0.5 * angle) * Vec2(mouth - hinge));
  back.dart_above.start = mouth;
  back.dart_above.line_to(tip);
  back.dart_below.start = tip;
  back.dart_below.line_to(back.under_below.start);
  back.cuff = back.cuff.turned(hinge, -angle);
  back.top = {back.top.start, {}, {}};
  back.top.line_to(hinge).line_to(back.cuff.start);
  std::tie(front.under, front.under_below) = front.under.cut(down);
  return true;
}

}  // namespace loosefit::kinds
