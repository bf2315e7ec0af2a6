#include "loosefit/kinds/shirt/shirt_blocks.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/shirt/back_waist.h"

namespace loosefit::kinds {

namespace {

/// Root of a function that rises from `low` to `high`; the nearer end where it has none there.
template <class Function>
double root_between(double low, double high, const Function& f) {
  const double at_low = f(low), at_high = f(high);
  if (at_low >= 0) return low;
  if (at_high <= 0) return high;
  std::uintmax_t evaluations = 60;
  const auto [left, right] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(46), evaluations);
  return 0.5 * (left + right);
}

constexpr double kBackDartPlace = 0.5;  ///< of the half width between the armholes
constexpr double kMostFullness = 0.05;  ///< front_fullness that is followed, of the chest

/// Quarter of a neck seam, from the centre to the shoulder seam, which it meets at a right angle:
/// across the seam front and back go on into each other without a corner, which would stand up from
/// the neck as a spike. `end`: where the shoulder seam begins.
pattern::CurveChain neck_curve(const Vec2& end, double drop, double slope) {
  constexpr double kHandle = 0.45, kLongest = 0.35, kLevel = 0.62;  // of the fall, of the width
  const double width = end.x(), handle = std::min(kHandle * (drop + end.y()), kLongest * width);
  pattern::CurveChain neck;
  neck.start = Vec2(0, -drop);
  neck.cubic_to({kLevel * width, -drop}, end + handle * Vec2(-std::sin(slope), -std::cos(slope)),
                end);
  return neck;
}

/// Slopes dx/dy at the points of a monotone cubic (Fritsch and Carlson 1980; their harmonic mean).
std::vector<double> monotone_slopes(const std::vector<Vec2>& p) {
  const std::size_t n = p.size();
  std::vector<double> chord(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    chord[i] = (p[i + 1].x() - p[i].x()) / (p[i + 1].y() - p[i].y());
  slope.front() = chord.front();
  slope.back() = chord.back();
  for (std::size_t i = 1; i + 1 < n; ++i)
    slope[i] =
        chord[i - 1] * chord[i] > 0 ? 2 * chord[i - 1] * chord[i] / (chord[i - 1] + chord[i]) : 0.0;
  return slope;
}

/// How a side seam passes the waist.
struct SideAtWaist {
  double share = 0;      ///< of the way from underarm to hem
  double width = 0;      ///< x of a seam that is led through it
  bool through = false;  ///< led through it, else straight
};
SideAtWaist side_at_waist(const TorsoLevels& l, double forward) {
  // Without what is let out for the hem, to which a straight seam adds its share.
  const double underarm = (1 + l.chest_fit) * l.chest / 4 + forward,
               hem = (1 + l.hip_fit) * l.hip / 4 + forward;
  const double hem_y = std::max(l.hem_y, l.hem_y - l.side_drop), taken = l.back_intake / 4;
  const double share = (l.underarm_y - l.waist_y) / (l.underarm_y - hem_y);
  const double straight = underarm + share * (hem - underarm);
  const double needed =
      (1 + l.chest_fit + share * (l.hip_fit - l.chest_fit)) * l.waist / 4 + forward;
  const bool between = share > 0 && share < 1;
  const double width = l.waist_fit ? (1 + *l.waist_fit) * l.waist / 4 + forward : needed;
  return {share, width + taken, l.waist_fit || (between && needed > straight - taken)};
}

/// Places of a side seam from underarm to hem, each with the ease between those asked for.
std::vector<Vec2> widths_along(const TorsoLevels& l, const Vec2& underarm, const Vec2& hem,
                               double forward) {
  constexpr double kApart = 0.012;  // between two places [m]
  const std::vector<AskedMobility> asked = {
      {-l.underarm_y, l.chest_fit}, {-l.waist_y, *l.waist_fit}, {-l.hem_y, l.hip_fit}};
  std::vector<Vec2> places = {underarm};
  for (const GirthAt& g : l.trunk)
    if (-g.along < underarm.y() - kApart && -g.along > hem.y() + kApart)
      places.emplace_back((1 + *mobility_at(asked, g.along)) * g.girth / 4 + forward, -g.along);
  places.push_back(hem);
  return places;
}

/// Cuts a dart into half a back at x = `middle`. The hem is that of the sewn back, drawn apart by
/// the mouth.
void take_back_dart(TorsoHalf& back, const TorsoLevels& l, double middle) {
  const double mouth = 0.5 * back_hem_mouth(l.back_intake);
  const Vec2 side = back.side.end();
  const pattern::CurveChain closed = draft_hem(side - Vec2(mouth, 0), l.hem_y);
  const auto [beyond, within] = closed.cut(closed.length_until(0, middle - 0.5 * mouth));
  back.hem = beyond;
  back.hem.start.x() += mouth;
  for (Vec2& k : back.hem.knots) k.x() += mouth;
  for (pattern::EdgeCurve& curve : back.hem.curves)
    for (Vec2& c : curve.control) c.x() += mouth;
  back.hem_middle = within;
  const BackDart dart = {.middle = within.start.x() + 0.5 * mouth,
                         .tip_y = l.underarm_y - kBackTipDrop,
                         .waist_y = l.waist_y,
                         .hem_y = within.start.y(),
                         .at_waist = 0.25 * back_opening_at_waist(l),
                         .at_hem = 0.5 * mouth};
  back.back_dart_outer = draft_back_dart(dart, true);
  back.back_dart_outer.start = back.hem.end();
  back.back_dart_inner = draft_back_dart(dart, false).reversed();
  back.back_dart_inner.knots.back() = within.start;
}

}  // namespace

NeckOpening fit_neck(const ShirtMeasures& m, const ShirtFit& fit) {
  constexpr int kPieces = 8;
  NeckOpening neck;
  neck.half_width = 0.5 * (1 + fit.neck_ease) * m.neck_width;
  // A back neck is never straight, also where C7 lies right between the sides of the neck.
  neck.drop_back = (1 + fit.neck_ease) * std::max(m.neck_depth_back, 0.03 * m.neck);
  const double half_seam = 0.5 * (1 + fit.neck_ease) * m.neck;
  const auto length = [&](double drop) {
    return neck_curve({neck.half_width, 0}, drop, seam_slope(m)).length(kPieces);
  };
  const double front = half_seam - length(neck.drop_back);
  neck.drop_front = root_between(0.5 * neck.half_width, 3 * neck.half_width,
                                 [&](double drop) { return length(drop) - front; });
  // Down the shoulder seam, the back and the front.
  neck.half_width += fit.neckband * std::cos(seam_slope(m));
  neck.shoulder = fit.neckband * std::sin(seam_slope(m));
  neck.drop_back += fit.neckband;
  neck.drop_front += fit.neckband;
  return neck;
}

pattern::CurveChain draft_neck_half(const ShirtMeasures& m, const ShirtFit& fit, bool front) {
  const NeckOpening neck = fit_neck(m, fit);
  return neck_curve({neck.half_width, -neck.shoulder}, front ? neck.drop_front : neck.drop_back,
                    seam_slope(m));
}

double seam_slope(const ShirtMeasures& m) {
  constexpr double kSeam = 2.0 / 3.0;
  return kSeam * m.shoulder_slope;
}

double shoulder_half_width(const ShirtMeasures& m, const ShirtFit& fit) {
  // A tight shirt narrows the shoulders in full, a loose one widens them only in part.
  const double follow = fit.chest > 0 ? fit.shoulder_follow : 1.0;
  return shoulder_half_width(m) * (1 + follow * fit.chest);
}

double shoulder_half_width(const ShirtMeasures& m) {
  return 0.5 * m.neck_width + std::cos(m.shoulder_slope) * m.shoulder_length;
}

double side_shift(const TorsoLevels& l, bool front) {
  const double fullness =
      std::clamp(l.front_fullness, -kMostFullness * l.chest, kMostFullness * l.chest);
  return (front ? 0.5 : -0.5) * (1 + l.chest_fit) * fullness;
}

pattern::CurveChain draft_side(const TorsoLevels& l, bool front) {
  const double forward = side_shift(l, front);
  const Vec2 underarm((1 + l.chest_fit) * l.chest / 4 + forward, l.underarm_y);
  const double end_y = l.hem_y - l.side_drop;
  // It keeps the girth of the hem below the hem's level.
  const Vec2 hem((1 + l.hip_fit) * l.hip / 4 + forward + back_hem_mouth(l.back_intake) / 4,
                 std::max(l.hem_y, end_y));
  pattern::CurveChain side;
  side.start = underarm;
  if (l.waist_fit && l.back_intake == 0 && !l.trunk.empty()) {
    side = draft_under_seam(widths_along(l, underarm, hem, forward));
  } else if (const SideAtWaist at = side_at_waist(l, forward); at.through) {
    const Vec2 waist(at.width, l.waist_y);
    const Vec2 above(0, 0.4 * (l.underarm_y - waist.y())), below(0, 0.4 * (waist.y() - hem.y()));
    side.cubic_to(underarm - above, waist + above, waist).cubic_to(waist - below, hem + below, hem);
  } else {
    side.line_to(hem);
  }
  if (end_y < hem.y()) side.line_to({hem.x(), end_y});
  return side;
}

double back_opening_at_waist(const TorsoLevels& l) {
  const SideAtWaist at = side_at_waist(l, 0);
  return l.back_intake + (at.through ? 0.0 : at.share * back_hem_mouth(l.back_intake));
}

double hem_side_drop(double front_balance) { return 0.5 * front_balance; }

TorsoHalf draft_torso_half(const ShirtMeasures& m, const ShirtFit& fit, double underarm_depth,
                           bool front, double drop) {
  const NeckOpening neck = fit_neck(m, fit);
  // Tied to the body's shoulder point, so that a wide shoulder does not lower the underarm.
  const double y_underarm = -std::sin(m.shoulder_slope) * m.shoulder_length - underarm_depth;
  const TorsoLevels levels = {.chest = m.chest,
                              .waist = m.waist,
                              .hip = m.hip,
                              .chest_fit = fit.chest,
                              .hip_fit = fit.hip,
                              .waist_fit = fit.waist,
                              .front_fullness = m.front_fullness,
                              .underarm_y = y_underarm,
                              .waist_y = -m.hps_to_waist,
                              .hem_y = -m.hps_to_hem,
                              .trunk = m.along.trunk,
                              .side_drop = hem_side_drop(m.front_balance),
                              .back_intake = back_waist_intake(fit)};
  // All levels move alike, which keeps both side seams equal.
  const double forward = side_shift(levels, front);
  const double x_underarm = (1 + fit.chest) * m.chest / 4 + forward;
  const double narrow = (1 + fit.chest) * m.chest / 4 - std::abs(forward);
  const double x_shoulder = std::min(shoulder_half_width(m, fit) + drop, 0.97 * narrow);
  const double slope = seam_slope(m);
  const double y_shoulder = -std::tan(slope) * (x_shoulder - neck.half_width) - neck.shoulder;
  const double depth = y_shoulder - y_underarm;
  const double x_pitch =
      std::min(0.97 * x_shoulder, 0.95 * x_underarm) - (front ? 0.010 * m.chest : 0.0);

  const Vec2 shoulder_point(x_shoulder, y_shoulder), pitch(x_pitch, y_shoulder - 0.5 * depth),
      underarm(x_underarm, y_underarm);
  const Vec2 inward(-std::sin(slope), -std::cos(slope));

  TorsoHalf half;
  half.shoulder_x = x_shoulder;
  half.armhole_depth = depth;
  const Vec2 neck_point(neck.half_width, -neck.shoulder);
  half.neck = draft_neck_half(m, fit, front);
  half.shoulder.start = neck_point;
  half.shoulder.line_to(shoulder_point);
  half.armhole.start = shoulder_point;
  half.armhole
      .cubic_to(shoulder_point + 0.20 * depth * inward, pitch + Vec2(0, 0.25 * depth), pitch)
      .cubic_to(pitch - Vec2(0, 0.30 * depth), underarm - Vec2(0.75 * (x_underarm - x_pitch), 0),
                underarm);
  half.side = draft_side(levels, front);
  // The way down over bust or belly is longer than over the back, and midway at the sides.
  half.hem = draft_hem(half.side.end(), levels.hem_y - (front ? m.front_balance : 0.0));
  if (!front && levels.back_intake > 0) take_back_dart(half, levels, kBackDartPlace * pitch.x());
  return half;
}

pattern::CurveChain draft_hem(const Vec2& side, double centre_level) {
  pattern::CurveChain hem;
  hem.start = side;
  if (centre_level == side.y())
    hem.line_to({0, centre_level});
  else
    hem.cubic_to({0.65 * side.x(), side.y()}, {0.55 * side.x(), centre_level}, {0, centre_level});
  return hem;
}

pattern::CurveChain draft_under_seam(const std::vector<Vec2>& width_at) {
  const std::vector<double> slope = monotone_slopes(width_at);
  pattern::CurveChain seam;
  seam.start = width_at.front();
  for (std::size_t i = 0; i + 1 < width_at.size(); ++i) {
    const Vec2 &a = width_at[i], &b = width_at[i + 1];
    const double third = (b.y() - a.y()) / 3;
    seam.cubic_to(a + third * Vec2(slope[i], 1), b - third * Vec2(slope[i + 1], 1), b);
  }
  return seam;
}

SleeveHalf draft_sleeve_half(const std::vector<Vec2>& width_at, double cap_height) {
  const Vec2& end = width_at.back();
  SleeveHalf half;
  half.cap = draft_cap(width_at.front().x(), cap_height);
  half.under = draft_under_seam(width_at);
  half.top.start = Vec2(0, cap_height);
  half.top.line_to({0, end.y()});
  half.cuff.start = half.top.end();
  half.cuff.line_to(end);
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
  // Share of the front in the girth that brings front and back length to the wanted ratio.
  const auto split = [&](double h) {
    return root_between(0.30, 0.70, [&](double q) {
      return cap_length(q * girth, h) * back_length - cap_length((1 - q) * girth, h) * front_length;
    });
  };
  const auto excess = [&](double h) { return cap_length(split(h) * girth, h) - front_length; };
  constexpr double kFlat = 1e-3;  // [m]
  if (excess(kFlat) > 0) return std::nullopt;
  const double h = root_between(kFlat, 2 * std::max(front_length, back_length), excess);
  const double q = split(h);
  // Very unequal armholes would need a split beyond the limits of q.
  if (std::abs(cap_length(q * girth, h) - front_length) > 1e-7 ||
      std::abs(cap_length((1 - q) * girth, h) - back_length) > 1e-7)
    return std::nullopt;
  return CapFit{h, q};
}

}  // namespace loosefit::kinds
