#include "loosefit/kinds/shirt/shirt_blocks.h"

#include <algorithm>
#include <cmath>

namespace loosefit::kinds {

TorsoHalf draft_torso_half(const ShirtMeasures& m, const ShirtFit& fit, double underarm_depth,
                           bool front, double drop) {
  const double x_underarm = (1 + fit.chest) * m.chest / 4;
  const double x_hem = (1 + fit.hip) * m.hip / 4;
  // A tight shirt narrows the shoulders in full, a loose one widens them only in part.
  const double follow = fit.chest > 0 ? fit.shoulder_follow : 1.0;
  const double x_shoulder =
      std::min(m.shoulder_breadth / 2 * (1 + follow * fit.chest) + drop, 0.97 * x_underarm);
  const double x_neck = (1 + fit.neck_ease) * m.neck / 5;
  const double slope = std::tan(m.shoulder_slope);
  const double y_shoulder = -slope * (x_shoulder - x_neck);
  // Tied to the body's shoulder point, so that a wide shoulder does not lower the underarm.
  const double y_underarm = -slope * (m.shoulder_breadth / 2 - x_neck) - underarm_depth;
  const double depth = y_shoulder - y_underarm;
  const double neck_drop = front ? x_neck + 0.010 : 0.06 * m.neck;
  const double x_pitch =
      std::min(0.97 * x_shoulder, 0.95 * x_underarm) - (front ? 0.010 * m.chest : 0.0);

  const Vec2 shoulder_point(x_shoulder, y_shoulder), pitch(x_pitch, y_shoulder - 0.5 * depth),
      underarm(x_underarm, y_underarm);
  const Vec2 inward(-std::sin(m.shoulder_slope), -std::cos(m.shoulder_slope));

  TorsoHalf half;
  half.shoulder_x = x_shoulder;
  half.armhole_depth = depth;
  half.neck.start = Vec2(0, -neck_drop);
  half.neck.cubic_to({0.55 * x_neck, -neck_drop}, {x_neck, -0.45 * neck_drop}, {x_neck, 0});
  half.shoulder.start = Vec2(x_neck, 0);
  half.shoulder.line_to(shoulder_point);
  half.armhole.start = shoulder_point;
  half.armhole
      .cubic_to(shoulder_point + 0.20 * depth * inward, pitch + Vec2(0, 0.25 * depth), pitch)
      .cubic_to(pitch - Vec2(0, 0.30 * depth), underarm - Vec2(0.75 * (x_underarm - x_pitch), 0),
                underarm);
  half.side.start = underarm;
  const Vec2 hem(x_hem, -m.hps_to_hem);
  if (fit.waist) {
    const Vec2 waist((1 + *fit.waist) * m.waist / 4, -m.hps_to_waist);
    const Vec2 above(0, 0.4 * (y_underarm - waist.y())), below(0, 0.4 * (waist.y() - hem.y()));
    half.side.cubic_to(underarm - above, waist + above, waist)
        .cubic_to(waist - below, hem + below, hem);
  } else {
    half.side.line_to(hem);
  }
  return half;
}

pattern::CurveChain draft_cap(double width, double height) {
  const Vec2 middle(0.50 * width, 0.52 * height);
  const double chord = std::hypot(width, height);
  // The slope at the middle is steeper than the chord.
  const Vec2 arm = 0.22 * chord * Vec2(0.72 * width, -1.25 * height).normalized();
  pattern::CurveChain cap;
  cap.start = Vec2(0, height);
  cap.cubic_to({0.24 * width, height}, middle - arm, middle)
      .cubic_to(middle + arm, {0.80 * width, 0}, {width, 0});
  return cap;
}

std::optional<CapFit> fit_caps(double front_length, double back_length, double girth) {
  constexpr int kPieces = 8;  // length error below 1e-9 m for these gentle curves
  const auto cap_length = [](double w, double h) { return draft_cap(w, h).length(kPieces); };
  const auto split = [&](double h) {  // share q with front / back length in the wanted ratio
    double low = 0.30, high = 0.70;
    for (int i = 0; i < 46; ++i) {
      const double q = 0.5 * (low + high);
      const bool short_front =
          cap_length(q * girth, h) * back_length < cap_length((1 - q) * girth, h) * front_length;
      (short_front ? low : high) = q;
    }
    return 0.5 * (low + high);
  };
  double low = 1e-3, high = 2 * std::max(front_length, back_length);
  if (cap_length(split(low) * girth, low) > front_length) return std::nullopt;
  for (int i = 0; i < 46; ++i) {
    const double h = 0.5 * (low + high);
    (cap_length(split(h) * girth, h) < front_length ? low : high) = h;
  }
  const double h = 0.5 * (low + high);
  const double q = split(h);
  // Very unequal armholes would need a split beyond the limits of q.
  if (std::abs(cap_length(q * girth, h) - front_length) > 1e-7 ||
      std::abs(cap_length((1 - q) * girth, h) - back_length) > 1e-7)
    return std::nullopt;
  return CapFit{h, q};
}

}  // namespace loosefit::kinds
