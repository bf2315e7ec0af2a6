#include "loosefit/kinds/shirt/shirt_draft.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/bust_dart.h"
#include "loosefit/kinds/shirt/elbow_dart.h"
#include "loosefit/kinds/shirt/shirt_bands.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_checks.h"
#include "loosefit/kinds/shirt/shirt_placement.h"
#include "loosefit/kinds/shirt/sleeve_ease.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kStep = 0.0025;                       // adjustment step [m]
constexpr double kRatioLow = 0.50, kRatioHigh = 0.85;  // of cap height / armhole depth
constexpr int kDeeper = 14;   // steps by which the underarm is lowered for a better cap …
constexpr int kDeepest = 32;  // … and for a cap that can be worn at all

struct Draft {
  TorsoHalf front, back;
  std::optional<CapFit> cap;
  double ratio() const { return cap->height / front.armhole_depth; }
};

pattern::Panel torso_panel(const TorsoHalf& half, bool front) {
  // Which of the wearer's sides lies at x > 0, seen from outside.
  const std::string at_right = front ? "L" : "R", at_left = front ? "R" : "L";
  const pattern::CurveChain side = half.side.reversed(), armhole = half.armhole.reversed(),
                            shoulder = half.shoulder.reversed(), to_centre = half.neck.reversed();
  pattern::CurveChain neck = to_centre, other = half.neck.mirrored();
  neck.curves.insert(neck.curves.end(), other.curves.begin(), other.curves.end());
  neck.knots.insert(neck.knots.end(), other.knots.begin(), other.knots.end());
  std::vector<std::pair<std::string, pattern::CurveChain>> loop;
  // A chain that is empty is left out: a side without a cut, a cut without a dart.
  const auto add = [&](const std::string& name, const pattern::CurveChain& chain) {
    if (!chain.curves.empty()) loop.emplace_back(name, chain);
  };
  // From the side at x < 0 to the other one.
  const auto whole = [](pattern::CurveChain first, const pattern::CurveChain& second) {
    first.curves.insert(first.curves.end(), second.curves.begin(), second.curves.end());
    first.knots.insert(first.knots.end(), second.knots.begin(), second.knots.end());
    return first;
  };
  if (half.hem_middle.curves.empty()) {
    add("hem", whole(half.hem.mirrored(), half.hem.reversed()));
  } else {
    add("hem_" + at_left, half.hem.mirrored());
    add("back_dart_" + at_left + "_outer", half.back_dart_outer.mirrored());
    add("back_dart_" + at_left + "_inner", half.back_dart_inner.mirrored());
    add("hem", whole(half.hem_middle.mirrored(), half.hem_middle.reversed()));
    add("back_dart_" + at_right + "_inner", half.back_dart_inner.reversed());
    add("back_dart_" + at_right + "_outer", half.back_dart_outer.reversed());
    add("hem_" + at_right, half.hem.reversed());
  }
  add("side_" + at_right + "_below", half.side_below.reversed());
  add("dart_" + at_right + "_below", half.dart_below.reversed());
  add("dart_" + at_right + "_above", half.dart_above.reversed());
  add("side_" + at_right, side);
  add("armhole_" + at_right, armhole);
  add("shoulder_" + at_right, shoulder);
  add("neck", neck);
  add("shoulder_" + at_left, half.shoulder.mirrored());
  add("armhole_" + at_left, half.armhole.mirrored());
  add("side_" + at_left, half.side.mirrored());
  add("dart_" + at_left + "_above", half.dart_above.mirrored());
  add("dart_" + at_left + "_below", half.dart_below.mirrored());
  add("side_" + at_left + "_below", half.side_below.mirrored());
  return pattern::draft_panel(front ? "front" : "back", "body", loop);
}

pattern::Panel sleeve_panel(const std::string& name, const SleeveHalf& half, bool at_positive_x) {
  using Loop = std::vector<std::pair<std::string, pattern::CurveChain>>;
  // Counter-clockwise for a half at x > 0; a chain that is empty is left out.
  const Loop all = {{"top", half.top},
                    {"cuff", half.cuff},
                    {"under_below", half.under_below.reversed()},
                    {"dart_below", half.dart_below.reversed()},
                    {"dart_above", half.dart_above.reversed()},
                    {"under", half.under.reversed()},
                    {"cap", half.cap.reversed()}};
  Loop loop;
  for (const auto& [edge, chain] : all)
    if (!chain.curves.empty()) loop.emplace_back(edge, chain);
  if (!at_positive_x) {
    std::reverse(loop.begin(), loop.end());
    for (auto& [edge, chain] : loop) chain = chain.reversed().mirrored();
  }
  return pattern::draft_panel(name, "arm", loop);
}

/// `arm`: girth of the arm that the sleeve counts against.
Draft draft_at(const ShirtMeasures& m, const ShirtFit& fit, double arm, double depth, double drop) {
  Draft d{draft_torso_half(m, fit, depth, true, drop),
          draft_torso_half(m, fit, depth, false, drop),
          {}};
  d.cap = fit_caps((1 + fit.cap_ease) * d.front.armhole.length(),
                   (1 + fit.cap_ease) * d.back.armhole.length(), (1 + fit.sleeve) * arm);
  return d;
}

/// From the body's shoulder point to the end of the cap; a dropped shoulder is taken off the sleeve.
double underarm_of(const Draft& d, const ShirtMeasures& m) {
  return d.cap->height + d.front.shoulder_x - shoulder_half_width(m);
}

/// Moves underarm and shoulder point until the cap is neither flat nor steep; girths stay.
Draft balance(const ShirtMeasures& m, const ShirtFit& fit, double arm, ShirtDraftReport& report) {
  const auto at = [&](double depth, double drop) { return draft_at(m, fit, arm, depth, drop); };
  const double first = m.scye_depth + fit.scye_ease;
  double depth = first, drop = 0;
  Draft d = at(depth, drop);
  // The deeper the underarm the higher the cap: the first step in `low` … `high` that will do.
  const auto high_enough = [&](int steps, double wanted) {
    depth = first + steps * kStep;
    d = at(depth, drop);
    return d.cap && d.ratio() >= std::min(wanted, kRatioHigh);
  };
  const auto lower_to = [&](int low, int high, double wanted) {
    while (low < high) {
      const int middle = (low + high) / 2;
      if (high_enough(middle, wanted))
        high = middle;
      else
        low = middle + 1;
    }
    return high_enough(low, wanted);
  };
  if (!lower_to(0, kDeeper, fit.cap_ratio) && !high_enough(kDeeper, kRatioLow))
    lower_to(kDeeper, kDeepest, kRatioLow);
  while (d.cap && d.ratio() > kRatioHigh && depth - kStep > m.scye_depth + 0.005) {
    depth -= kStep;
    d = at(depth, drop);
  }
  while (d.cap && d.ratio() > kRatioHigh &&
         d.front.shoulder_x <
             0.969 * std::min(d.front.armhole.end().x(), d.back.armhole.end().x())) {
    drop += kStep;
    d = at(depth, drop);
  }
  report.deepened = depth - first;
  report.dropped = drop;
  return d;
}

/// A draft whose sleeve has its ease where its cap ends: how far down that is depends on how wide
/// the sleeve is.
Draft balance_sleeve(const ShirtMeasures& m, const ShirtFit& fit, ShirtDraftReport& report,
                     double& arm) {
  constexpr int kRounds = 5;
  constexpr double kEqual = 0.0005;  // [m]
  arm = arm_under_sleeve(m, fit, m.scye_depth + fit.scye_ease);
  Draft d = balance(m, fit, arm, report);
  for (int round = 0; round < kRounds && d.cap; ++round) {
    const double there = arm_under_sleeve(m, fit, underarm_of(d, m));
    if (std::abs(there - arm) < kEqual) break;
    arm = there;
    d = balance(m, fit, arm, report);
  }
  return d;
}

}  // namespace

bool sleeve_fits_armhole(const ShirtMeasures& m, const ShirtFit& fit) {
  const double depth = m.scye_depth + fit.scye_ease + kDeepest * kStep;
  return draft_at(m, fit, arm_under_sleeve(m, fit, depth), depth, 0).cap.has_value();
}

pattern::Pattern draft_shirt(const ShirtMeasures& m, const ShirtFit& fit, ShirtDraftReport* report,
                             const ShirtPlacement& placement) {
  check_shirt_input(m, fit);
  ShirtDraftReport result;
  double arm = 0;
  Draft d = balance_sleeve(m, fit, result, arm);
  if (!d.cap)
    throw_sleeve_too_wide(m, fit, arm, d.front.armhole.length() + d.back.armhole.length());

  check_shirt_levels(m, fit, d.front.shoulder.end().y(), d.front.armhole.end().y());
  const bool dart = take_bust_dart(d.front, d.back, m, fit);

  const double upper = (1 + fit.sleeve) * arm;
  const double front_width = d.cap->front_share * upper;
  const double underarm = underarm_of(d, m);
  const GirthLine girths = sleeve_girths(m, fit, underarm);
  const double under_length = girths.back().along - underarm;
  // Both halves taper alike, which keeps the two underarm seams equal.
  const auto widths = [&](double width) {
    std::vector<Vec2> at = {{width, 0}};
    for (const GirthAt& g : girths)
      at.emplace_back(width - 0.5 * (upper - g.girth), underarm - g.along);
    return at;
  };
  SleeveHalf sleeve_before = draft_sleeve_half(widths(front_width), d.cap->height),
             sleeve_behind = draft_sleeve_half(widths(upper - front_width), d.cap->height);
  // A dart at the elbow needs a place of the sleeve there, with sleeve above and below it.
  const auto elbow = std::min_element(
      girths.begin(), girths.end(), [&](const GirthAt& a, const GirthAt& b) {
        return std::abs(a.along - m.elbow_length) < std::abs(b.along - m.elbow_length);
      });
  const bool elbow_dart =
      has_elbow(m, fit, underarm) &&
      take_elbow_dart(sleeve_before, sleeve_behind, underarm - elbow->along, elbow->girth,
                      fit.elbow_bend);

  pattern::Pattern shirt;
  shirt.name = fit.sleeve_length < 1 ? "short-sleeve-shirt" : "long-sleeve-shirt";
  shirt.kind = "long-sleeve-shirt";
  shirt.panels = {torso_panel(d.front, true), torso_panel(d.back, false)};
  for (const std::string s : {"L", "R"}) {
    const bool left = s == "L";
    shirt.panels.push_back(sleeve_panel("sleeve_" + s + "_front", sleeve_before, !left));
    shirt.panels.push_back(sleeve_panel("sleeve_" + s + "_back", sleeve_behind, left));
  }
  for (const std::string s : {"L", "R"}) {
    const std::string sleeve_front = "sleeve_" + s + "_front",
                      sleeve_back = "sleeve_" + s + "_back";
    pattern::sew_edges(shirt, "side_" + s, "front", "side_" + s, "back", "side_" + s);
    if (dart) {
      pattern::sew_edges(shirt, "side_below_" + s, "front", "side_" + s + "_below", "back",
                         "side_" + s + "_below");
      pattern::sew_edges(shirt, "bust_dart_" + s, "front", "dart_" + s + "_below", "front",
                         "dart_" + s + "_above");
    }
    if (!d.back.hem_middle.curves.empty())
      pattern::sew_edges(shirt, "back_dart_" + s, "back", "back_dart_" + s + "_inner", "back",
                         "back_dart_" + s + "_outer");
    pattern::sew_edges(shirt, "shoulder_" + s, "front", "shoulder_" + s, "back", "shoulder_" + s);
    pattern::sew_edges(shirt, "armhole_front_" + s, "front", "armhole_" + s, sleeve_front, "cap");
    pattern::sew_edges(shirt, "armhole_back_" + s, "back", "armhole_" + s, sleeve_back, "cap");
    pattern::sew_edges(shirt, "sleeve_top_" + s, sleeve_front, "top", sleeve_back, "top");
    pattern::sew_edges(shirt, "sleeve_under_" + s, sleeve_front, "under", sleeve_back, "under");
    if (elbow_dart) {
      pattern::sew_edges(shirt, "sleeve_under_below_" + s, sleeve_front, "under_below", sleeve_back,
                         "under_below");
      pattern::sew_edges(shirt, "elbow_dart_" + s, sleeve_back, "dart_below", sleeve_back,
                         "dart_above");
    }
  }
  add_bands(shirt, m, fit);
  finish_edges(shirt, fit);
  for (int p = 0; p < static_cast<int>(shirt.panels.size()); ++p) shirt.panel_order.push_back(p);
  check_shirt_outlines(shirt, m, fit, d.front.shoulder_x, under_length);
  place_shirt(shirt, m, placement, Vec2(d.front.shoulder_x, d.front.shoulder.end().y()),
              d.cap->height);

  result.armhole = d.front.armhole.length() + d.back.armhole.length();
  result.armhole_depth = d.front.armhole_depth;
  result.cap_height = d.cap->height;
  result.cap_ratio = d.ratio();
  result.front_share = d.cap->front_share;
  if (report) *report = result;
  return shirt;
}

}  // namespace loosefit::kinds
