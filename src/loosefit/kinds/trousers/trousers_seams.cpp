#include "loosefit/kinds/trousers/trousers_seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/kinds/trousers/trousers_measures.h"

namespace loosefit::kinds {
namespace {

using pattern::CurveChain;

/// The end of the back's crotch curve lies no farther than this from the level of the front's [m]:
/// tailors lower it by up to two centimetres so that the inseams can be sewn (judgement).
constexpr double kMostDrop = 0.020;
/// The same of legs whose inseams are not held at the thigh [m].
constexpr double kMostDropOfFreeThigh = 0.050;
constexpr double kMostSideRise = 0.050;   ///< of the back's waist at the outseam [m]
constexpr double kLeastThighShare = 0.3;  ///< of the thigh's girth, of either piece
constexpr double kEqual = 1e-6;           ///< seams that count as equally long [m]
constexpr double kSewnIn = 0.002;         ///< more than this is not sewn in unseen (judgement) [m]

/// How much longer a seam of the back is than that of the front [m].
double excess(const BodyMeasures& m, const NamedValues& fit, const Easing& easing,
              CurveChain Leg::*seam) {
  return (draft_leg(m, fit, false, easing).*seam).length() -
         (draft_leg(m, fit, true, easing).*seam).length();
}

/// How much farther in than straight from the crotch to the next level below the thigh an inseam
/// lies at the thigh [m].
double inside_straight(const Leg& leg) {
  const Vec2 &tip = leg.inseam.start, &thigh = leg.inseam.knots[0], &below = leg.inseam.knots[1];
  const double share = (tip.y() - thigh.y()) / (tip.y() - below.y());
  return thigh.x() - (tip.x() + share * (below.x() - tip.x()));
}

/// Whether the seams of front and back can be made as long as each other.
bool seams_close(const BodyMeasures& m, const NamedValues& fit) {
  const Easing easing = ease_legs(m, fit);
  return std::abs(excess(m, fit, easing, &Leg::inseam)) < kSewnIn &&
         std::abs(excess(m, fit, easing, &Leg::outseam)) < kSewnIn;
}

/// The next lower value of a key with which the seams close, in thousandths, so that what is told
/// is what was tried; none where its range has none. `waist_follows`: the waist is what it is where
/// nobody asks for one.
std::optional<double> most_that_closes(const BodyMeasures& m, const NamedValues& fit,
                                       const std::string& key, double least, bool waist_follows) {
  constexpr int kSteps = 16;
  NamedValues tried = fit;
  const auto closes = [&](int thousandths) {
    tried[key] = thousandths / 1000.0;
    if (waist_follows) tried["waist"] = usual_waist(m, tried);
    return seams_close(m, tried);
  };
  const int top = static_cast<int>(std::ceil(1000 * fit.at(key))),
            bottom = static_cast<int>(std::lround(1000 * least));
  if (top <= bottom) return std::nullopt;
  int low = top, high = top;
  for (int i = 1; low == top || !closes(low); ++i) {
    if (i > kSteps) return std::nullopt;
    high = low;
    low = top - (top - bottom) * i / kSteps;
  }
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (closes(middle) ? low : high) = middle;
  }
  return low / 1000.0;
}

}  // namespace

Easing ease_legs(const BodyMeasures& m, const NamedValues& fit) {
  Easing easing;
  // The value between two ends at which the seams are equal, or the end nearest to that.
  const auto seek = [&](double& what, double low, double high, CurveChain Leg::*seam) {
    const auto at = [&](double v) {
      what = v;
      return excess(m, fit, easing, seam);
    };
    const bool grows = at(high) > at(low);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((at(middle) < 0) == grows ? low : high) = middle;
    }
    what = 0.5 * (low + high);
  };
  if (has_thigh_level(m, fit)) {
    const double y = kThighLevel * m.at("crotch_height");
    // The end of the crotch curve stays above the thigh level.
    const double room = m.at("crotch_height") - fit.at("crotch_ease") - y - 2 * kBelowTip;
    seek(easing.crotch_drop, -kMostDrop, std::clamp(room, 0.0, kMostDrop), &Leg::inseam);
    if (const double left = excess(m, fit, easing, &Leg::inseam); std::abs(left) > kEqual) {
      // An inseam is shortest where it is straight. From one of these widths to the other the
      // back's gets longer and the front's shorter.
      const double girth = (1 + fit.at("thigh")) * leg_girth_at(m, y);
      const auto within = [&](double given) {
        return std::clamp(given, (kLeastThighShare - (1 - kFrontShare)) * girth,
                          (kFrontShare - kLeastThighShare) * girth);
      };
      const double front = within(-inside_straight(draft_leg(m, fit, true, easing))),
                   back = within(inside_straight(draft_leg(m, fit, false, easing)));
      const auto at = [&](double given) {
        easing.thigh_to_back = given;
        return excess(m, fit, easing, &Leg::inseam);
      };
      const bool towards_back = (at(back) < at(front)) == (left > 0);
      seek(easing.thigh_to_back, 0, towards_back ? back : front, &Leg::inseam);
    }
  } else {
    seek(easing.crotch_drop, -kMostDropOfFreeThigh, kMostDropOfFreeThigh, &Leg::inseam);
  }
  seek(easing.side_rise, -kMostSideRise, kMostSideRise, &Leg::outseam);
  return easing;
}

void check_seams(const BodyMeasures& m, const NamedValues& fit, const Easing& easing,
                 const std::set<std::string>& asked) {
  const double inside = excess(m, fit, easing, &Leg::inseam),
               outside = excess(m, fit, easing, &Leg::outseam);
  if (std::abs(inside) < kSewnIn && std::abs(outside) < kSewnIn) return;
  const bool is_inside = std::abs(inside) >= kSewnIn;
  const std::string told =
      fmt::format("the {} of the back is {:.0f} mm {} than the front's",
                  is_inside ? "inseam" : "outseam", 1000 * std::abs(is_inside ? inside : outside),
                  (is_inside ? inside : outside) > 0 ? "longer" : "shorter");
  const char* const kHint = "longer legs, or girths along them that differ less, help too";
  // How far the back reaches under the body is what its inseam differs by.
  std::vector<std::pair<std::string, double>> keys = {{"crotch_width", 0.06}, {"hip", -0.35}};
  std::ranges::stable_sort(keys, [&](const auto& a, const auto& b) {
    return asked.count(a.first) > asked.count(b.first);
  });
  for (const auto& [key, least] : keys)
    if (const auto most = most_that_closes(m, fit, key, least, !asked.count("waist")))
      throw InvalidInput({{}, 0, "fit." + key}, fmt::format("{:.4g}", fit.at(key)),
                         fmt::format("at most {:.3f} with these legs: {}", *most, told), kHint);
  throw InvalidInput({{}, 0, "fit.leg_length"}, fmt::format("{:.4g}", fit.at("leg_length")),
                     "legs whose front and back can be sewn together: " + told, kHint);
}

}  // namespace loosefit::kinds
