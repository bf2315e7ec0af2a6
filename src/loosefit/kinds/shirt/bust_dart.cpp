#include "loosefit/kinds/shirt/bust_dart.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace loosefit::kinds {
namespace {

constexpr double kLeastIntake = 0.012;   // less is a sliver, which nobody sews [m]
constexpr double kShort = 0.025;         // from the tip to the bust point [m]
constexpr double kBelowUnderarm = 0.04;  // room for the upper side seam [m]
constexpr double kAboveHem = 0.08;       // … and for the lower one [m]
constexpr double kLeastLength = 0.05;    // of a leg [m]

/// The seam below a dart: moved to where the dart ends, and to the old line by the next knot, as
/// long as it was.
pattern::CurveChain move_below(const pattern::CurveChain& old, const Vec2& start) {
  const double top = old.start.y(), settled = old.knots.front().y();
  const double aside = start.x() - old.start.x();
  const auto moved = [&](double stretch) {
    const auto place = [&](const Vec2& p) {
      const double share = std::max(0.0, (p.y() - settled) / (top - settled));
      return Vec2(p.x() + aside * share, start.y() + stretch * (p.y() - top));
    };
    pattern::CurveChain seam = old;
    seam.start = start;
    for (Vec2& k : seam.knots) k = place(k);
    for (pattern::EdgeCurve& curve : seam.curves)
      for (Vec2& c : curve.control) c = place(c);
    return seam;
  };
  const double wanted = old.length();
  double low = 0.8, high = 1.2;
  for (int i = 0; i < 50; ++i) {
    const double stretch = 0.5 * (low + high);
    (moved(stretch).length() < wanted ? low : high) = stretch;
  }
  return moved(0.5 * (low + high));
}

}  // namespace

double bust_dart_intake(const ShirtMeasures& m, const ShirtFit& fit) {
  const double intake = fit.bust_dart * m.bust_balance;
  return intake < kLeastIntake ? 0.0 : intake;
}

bool take_bust_dart(TorsoHalf& front, TorsoHalf& back, const ShirtMeasures& m,
                    const ShirtFit& fit) {
  const double intake = bust_dart_intake(m, fit), side = front.side.length();
  if (intake == 0 || side < kBelowUnderarm + kAboveHem) return false;
  // The dart lies level with the bust point, or comes up to it from below the underarm.
  const Vec2 bust(0.5 * m.bust_span, -m.hps_to_bust);
  const double level = front.side.start.y() - (bust.y() + 0.5 * intake);
  const auto [above, below] = front.side.cut(std::clamp(level, kBelowUnderarm, side - kAboveHem));
  const Vec2 mouth = above.end();
  const Vec2 out = mouth - Vec2(0, 0.5 * intake) - bust;
  const Vec2 tip = bust + kShort * out.normalized();
  const double leg = (mouth - tip).norm();
  if (tip.x() > mouth.x() || leg < kLeastLength) return false;

  // Closed, the dart turns what lies below it up to what lies above.
  const double angle = 2 * std::asin(std::min(0.5, 0.5 * intake / leg));
  const Vec2 end = tip + Eigen::Rotation2Dd(-angle) * (mouth - tip);
  front.dart_above.start = mouth;
  front.dart_above.line_to(tip);
  front.dart_below.start = tip;
  front.dart_below.line_to(end);
  front.side = above;
  front.side_below = move_below(below, end);
  std::tie(back.side, back.side_below) = back.side.cut(above.length());
  // The hem has to reach lower in its middle by that much less.
  const double longer = back.hem.end().y() - front.hem.end().y();
  front.hem =
      draft_hem(front.side_below.end(), back.hem.end().y() - intake - (1 - fit.bust_dart) * longer);
  return true;
}

}  // namespace loosefit::kinds
