#include "loosefit/kinds/shirt/shirt_draft.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_checks.h"
#include "loosefit/kinds/shirt/shirt_placement.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kStep = 0.0025;                       // adjustment step [m]
constexpr double kRatioLow = 0.50, kRatioHigh = 0.85;  // wanted cap height / armhole depth
constexpr double kDeepest = 0.08;                      // underarm lowered at most by [m]

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
  pattern::CurveChain hem;
  hem.start = Vec2(-half.side.end().x(), half.side.end().y());
  hem.line_to(half.side.end());
  return pattern::draft_panel(front ? "front" : "back", "body",
                              {{"hem", hem},
                               {"side_" + at_right, side},
                               {"armhole_" + at_right, armhole},
                               {"shoulder_" + at_right, shoulder},
                               {"neck", neck},
                               {"shoulder_" + at_left, half.shoulder.mirrored()},
                               {"armhole_" + at_left, half.armhole.mirrored()},
                               {"side_" + at_left, half.side.mirrored()}});
}

pattern::Panel sleeve_panel(const std::string& name, double width, double cuff, double cap_height,
                            double underarm_length, bool at_positive_x) {
  const pattern::CurveChain cap = draft_cap(width, cap_height);
  pattern::CurveChain top, hem, under;
  top.start = Vec2(0, cap_height);
  top.line_to({0, -underarm_length});
  hem.start = top.end();
  hem.line_to({cuff, -underarm_length});
  under.start = hem.end();
  under.line_to({width, 0});
  if (at_positive_x)
    return pattern::draft_panel(
        name, "arm", {{"top", top}, {"cuff", hem}, {"under", under}, {"cap", cap.reversed()}});
  return pattern::draft_panel(name, "arm",
                              {{"cap", cap.mirrored()},
                               {"under", under.reversed().mirrored()},
                               {"cuff", hem.reversed().mirrored()},
                               {"top", top.reversed().mirrored()}});
}

Draft draft_at(const ShirtMeasures& m, const ShirtFit& fit, double depth, double drop) {
  Draft d{draft_torso_half(m, fit, depth, true, drop),
          draft_torso_half(m, fit, depth, false, drop),
          {}};
  d.cap = fit_caps((1 + fit.cap_ease) * d.front.armhole.length(),
                   (1 + fit.cap_ease) * d.back.armhole.length(), (1 + fit.sleeve) * m.upper_arm);
  return d;
}

/// Moves underarm and shoulder point until the cap is neither flat nor steep; girths stay.
Draft balance(const ShirtMeasures& m, const ShirtFit& fit, ShirtDraftReport& report) {
  const auto at = [&](double depth, double drop) { return draft_at(m, fit, depth, drop); };
  const double first = m.scye_depth + fit.scye_ease;
  double depth = first, drop = 0;
  Draft d = at(depth, drop);
  while ((!d.cap || d.ratio() < kRatioLow) && depth - first < kDeepest) {
    depth += kStep;
    d = at(depth, drop);
  }
  while (d.cap && d.ratio() > kRatioHigh && depth - kStep > m.scye_depth + 0.005) {
    depth -= kStep;
    d = at(depth, drop);
  }
  while (d.cap && d.ratio() > kRatioHigh &&
         d.front.shoulder_x < 0.969 * d.front.armhole.end().x()) {
    drop += kStep;
    d = at(depth, drop);
  }
  report.deepened = depth - first;
  report.dropped = drop;
  return d;
}

}  // namespace

bool sleeve_fits_armhole(const ShirtMeasures& m, const ShirtFit& fit) {
  return draft_at(m, fit, m.scye_depth + fit.scye_ease + kDeepest, 0).cap.has_value();
}

pattern::Pattern draft_shirt(const ShirtMeasures& m, const ShirtFit& fit, ShirtDraftReport* report,
                             const ShirtPlacement& placement) {
  check_shirt_input(m, fit);
  ShirtDraftReport result;
  const Draft d = balance(m, fit, result);
  if (!d.cap) throw_sleeve_too_wide(m, fit, d.front.armhole.length() + d.back.armhole.length());

  check_shirt_levels(m, fit, d.front.shoulder.end().y(), d.front.armhole.end().y());

  const double upper = (1 + fit.sleeve) * m.upper_arm,
               wrist = (1 + fit.wrist) * arm_girth_at(m, fit.sleeve_length);
  const double front_width = d.cap->front_share * upper, back_width = upper - front_width;
  // A dropped shoulder is taken off the sleeve.
  const double top_length =
      fit.sleeve_length * m.arm_length - (d.front.shoulder_x - m.shoulder_breadth / 2);
  const double under_length = top_length - d.cap->height;
  // Equal taper of both halves keeps the two underarm seams equal.
  const double front_cuff = wrist / 2 + front_width - upper / 2;
  const double back_cuff = wrist / 2 + back_width - upper / 2;

  pattern::Pattern shirt;
  shirt.name = fit.sleeve_length < 1 ? "short-sleeve-shirt" : "long-sleeve-shirt";
  shirt.kind = "long-sleeve-shirt";
  shirt.panels = {torso_panel(d.front, true), torso_panel(d.back, false)};
  for (const std::string s : {"L", "R"}) {
    const bool left = s == "L";
    shirt.panels.push_back(sleeve_panel("sleeve_" + s + "_front", front_width, front_cuff,
                                        d.cap->height, under_length, !left));
    shirt.panels.push_back(sleeve_panel("sleeve_" + s + "_back", back_width, back_cuff,
                                        d.cap->height, under_length, left));
  }
  for (const std::string s : {"L", "R"}) {
    const std::string sleeve_front = "sleeve_" + s + "_front",
                      sleeve_back = "sleeve_" + s + "_back";
    pattern::sew_edges(shirt, "side_" + s, "front", "side_" + s, "back", "side_" + s);
    pattern::sew_edges(shirt, "shoulder_" + s, "front", "shoulder_" + s, "back", "shoulder_" + s);
    pattern::sew_edges(shirt, "armhole_front_" + s, "front", "armhole_" + s, sleeve_front, "cap");
    pattern::sew_edges(shirt, "armhole_back_" + s, "back", "armhole_" + s, sleeve_back, "cap");
    pattern::sew_edges(shirt, "sleeve_top_" + s, sleeve_front, "top", sleeve_back, "top");
    pattern::sew_edges(shirt, "sleeve_under_" + s, sleeve_front, "under", sleeve_back, "under");
  }
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
