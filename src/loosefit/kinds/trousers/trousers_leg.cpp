#include "loosefit/kinds/trousers/trousers_leg.h"

#include <algorithm>
#include <cmath>

#include "loosefit/kinds/trousers/trousers_measures.h"

namespace loosefit::kinds {
namespace {

using pattern::CurveChain;

constexpr double kFrontCrotch = 0.3;  ///< of the crotch width
constexpr double kBackRise = 0.015;   ///< the waist of the back, higher at the centre [m]
/// Share of what is taken in above the hip at the centre seam, at most so much [m]: the back slants
/// over the seat.
constexpr double kFrontCentre = 0.25, kBackCentre = 0.5, kMostCentre = 0.032;

/// Mobility asked for at a height, between the levels that have one.
double leg_mobility_at(const BodyMeasures& m, const NamedValues& fit, double height) {
  return *mobility_at(leg_eases(m, fit), m.at("crotch_height") - height);
}

/// Heights of the body's stations between two heights at which the leg has the ease between two
/// asked ones, downwards, none nearer than a centimetre to an end.
std::vector<double> stations_between(const BodyMeasures& m, const NamedValues& fit, double upper,
                                     double lower) {
  constexpr double kApart = 0.01;  // [m]
  std::vector<double> heights;
  for (const GirthAt& g : m.along.leg) {
    const double y = m.at("crotch_height") - g.along;
    if (y < upper - kApart && y > lower + kApart && is_ease_asked(m, fit, g.along))
      heights.push_back(y);
  }
  return heights;
}

/// A smooth line x(y) through points from above downwards: slopes of the monotone cubic
/// interpolant (Fritsch and Carlson 1980), so that no width lies outside those of its neighbours.
CurveChain smooth_down(const std::vector<Vec2>& points, double first_slope) {
  const std::size_t n = points.size();
  std::vector<double> chord(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    chord[i] = (points[i + 1].x() - points[i].x()) / (points[i + 1].y() - points[i].y());
  slope[0] = first_slope;
  slope[n - 1] = chord[n - 2];
  for (std::size_t i = 1; i + 1 < n; ++i)
    slope[i] =
        chord[i - 1] * chord[i] > 0 ? 2 * chord[i - 1] * chord[i] / (chord[i - 1] + chord[i]) : 0;
  CurveChain chain;
  chain.start = points[0];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double third = (points[i + 1].y() - points[i].y()) / 3;
    chain.cubic_to(points[i] + third * Vec2(slope[i], 1),
                   points[i + 1] - third * Vec2(slope[i + 1], 1), points[i + 1]);
  }
  return chain;
}

}  // namespace

bool has_thigh_level(const BodyMeasures& m, const NamedValues& fit) {
  const double crotch = m.at("crotch_height"), y = kThighLevel * crotch;
  return fit.count("thigh") && y < crotch - fit.at("crotch_ease") - kBelowTip &&
         y > std::max(kKneeLevel * crotch, hem_height(m, fit)) + 0.05;
}

Leg draft_leg(const BodyMeasures& m, const NamedValues& fit, bool front, const Easing& easing) {
  const double share = front ? kFrontShare : 1 - kFrontShare;
  const double crotch = m.at("crotch_height"), hip = hip_girth(m, fit);
  const double y_edge = waist_edge_height(m, fit), y_hem = hem_height(m, fit);
  const double y_crotch = crotch - fit.at("crotch_ease") - (front ? 0 : easing.crotch_drop);
  const double y_hip = std::max(m.at("hip_level"), y_crotch + 0.02);

  // Across: from the end of the crotch curve to the outseam, the crease in the middle.
  const double half = share * hip / 2;
  const double reach = (front ? kFrontCrotch : 1 - kFrontCrotch) * fit.at("crotch_width") * hip;
  const double x_out = (half + reach) / 2, x_tip = -x_out, x_centre = x_tip + reach;
  const double waist = share * (1 + fit.at("waist")) * m.at("waist") / 2;
  const double intake = half - waist;
  const double centre = std::clamp((front ? kFrontCentre : kBackCentre) * intake, 0.0, kMostCentre);
  const Vec2 waist_in(x_centre + centre, y_edge + (front ? 0 : kBackRise));
  const double rise = y_edge + (front ? 0 : easing.side_rise) - waist_in.y();
  const Vec2 waist_out = waist_in + Vec2(std::sqrt(waist * waist - rise * rise), rise),
             tip(x_tip, y_crotch);

  // Down the leg.
  std::vector<Vec2> out = {waist_out, {x_out, y_hip}}, in = {tip};
  const auto add_level = [&](double y, double girth, double middle) {
    out.push_back({middle + share * girth / 2, y});
    in.push_back({middle - share * girth / 2, y});
  };
  const double y_knee = kKneeLevel * crotch;
  const auto girth = [&](double y) {
    return (1 + leg_mobility_at(m, fit, y)) * leg_girth_at(m, y);
  };
  double above = y_crotch;  // of the next station
  if (has_thigh_level(m, fit)) {
    const double y_thigh = kThighLevel * crotch, y_below = std::max(y_knee, y_hem);
    const auto add_thigh = [&](double y) {
      // What a piece gives to the other one fades down to the knee.
      const double given =
          (front ? -1 : 1) * easing.thigh_to_back * (y - y_below) / (y_thigh - y_below);
      const double wide = share * girth(y) + given;
      // Its outer end on the straight line from hip to knee, eased like the seam.
      const double down = (y_hip - y) / (y_hip - y_below);
      const double x = x_out + down * down * (3 - 2 * down) * (share * girth(y_below) / 2 - x_out);
      out.push_back({x, y});
      in.push_back({x - wide, y});
    };
    add_thigh(y_thigh);
    for (const double y : stations_between(m, fit, y_thigh, y_below)) add_thigh(y);
    above = y_below;
  }
  const auto add_down_to = [&](double y) {
    for (const double between : stations_between(m, fit, above, y))
      add_level(between, girth(between), 0);
    above = y;
  };
  if (y_knee > y_hem + 0.03) {
    above = y_knee;
    add_level(y_knee, girth(y_knee), 0);
  }
  // Straight from knee to hem where nothing is asked for: the hem hangs from the calf.
  if (const double y = kCalfLevel * crotch; fit.count("calf") && y > y_hem + 0.03) {
    add_down_to(y);
    add_level(y, girth(y), 0);
  }
  add_down_to(y_hem);
  add_level(y_hem, girth(y_hem), 0);

  Leg leg;
  leg.outseam = smooth_down(out, 0.5 * (out[1].x() - out[0].x()) / (out[1].y() - out[0].y()));
  const double steep = 1.8 * (in[1].x() - in[0].x()) / (in[1].y() - in[0].y());
  leg.inseam = smooth_down(in, steep);
  leg.hem.start = in.back();
  leg.hem.line_to(out.back());
  leg.waist.start = waist_out;
  leg.waist.line_to(waist_in);
  // Straight down from the waist through the width at the hip, then round to the end of the crotch
  // curve, level there.
  const double y_join = y_crotch + std::min({0.5 * (y_edge - y_crotch), front ? 0.06 : 0.09,
                                             y_hip - y_crotch - kBelowTip});
  const double slant = (waist_in.x() - x_centre) / (waist_in.y() - y_hip);
  const Vec2 join(x_centre - slant * (y_hip - y_join), y_join);
  const Vec2 down = (join - waist_in).normalized();
  leg.centre.start = waist_in;
  leg.centre.line_to(join).cubic_to(join + 0.62 * (join.y() - tip.y()) * down,
                                    tip + Vec2(0.62 * (join.x() - tip.x()), 0), tip);
  return leg;
}

}  // namespace loosefit::kinds
