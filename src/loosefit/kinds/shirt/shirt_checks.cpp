#include "loosefit/kinds/shirt/shirt_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/kinds/shirt/back_waist.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_refusal.h"
#include "loosefit/kinds/told_limit.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"

namespace loosefit::kinds {
namespace {

constexpr double kShoulderSeam = 0.02;  // at least [m]

void in_range(const std::string& key, double value, double low, double high, const char* unit) {
  if (value >= low && value <= high) return;  // false for NaN too
  throw ShirtRefusal({InputPlace{{}, 0, key}, fmt::format("{:.6g}{}", value, unit),
                      fmt::format("{:g} to {:g}{}", low, high, unit)},
                     ShirtRule::range);
}

/// Strips and hems; a strip narrower than this cannot be folded.
void check_bands(const ShirtFit& fit) {
  for (const auto& [key, width] :
       {std::pair("fit.neckband_width", fit.neckband), {"fit.cuff_width", fit.cuff}})
    if (width != 0) in_range(key, width, 0.005, 0.12, " m");
  in_range("fit.neckband_stretch", fit.neckband_stretch, 0, 0.4, "");
  in_range("fit.cuff_stretch", fit.cuff_stretch, 0, 0.6, "");
  in_range("fit.band_stiffness", fit.band_stiffness, 0.1, 100, "");
  in_range("fit.edge_finish", fit.edge_finish, 0, 0.05, " m");
}

/// Refuses a shirt whose shoulder seam, from the neck to `shoulder_x`, is shorter than 20 mm. Where
/// the chest holds the shoulder point it stays when the neck is narrowed, else it comes in as well;
/// where no neck is narrow enough the chest is too tight.
[[noreturn]] void throw_neck_too_wide(const ShirtMeasures& m, const ShirtFit& fit, double neck_x,
                                      double shoulder_x) {
  constexpr double kNarrowest = 0.04;  // neck that is taken [m]
  const double most = shoulder_x - kShoulderSeam, free = shoulder_half_width(m, fit);
  double width = m.neck_width + 2 * (most - neck_x) / (1 + fit.neck_ease);
  const double missing = neck_x + kShoulderSeam - free;
  const double gained = 1 + fit.neck_ease - free / shoulder_half_width(m);
  if (missing > 0) width = gained > 0 ? std::min(width, m.neck_width - 2 * missing / gained) : 0;
  const bool has_neck = told_most(width) >= kNarrowest;
  const std::string expected =
      has_neck
          ? fmt::format("at most {:.3f} m for a shoulder length of {:.3f} m at chest fit {:.3g}",
                        told_most(width), m.shoulder_length, fit.chest)
          : fmt::format("at least {:.3f} for a neck width of {:.3f} m",
                        told_least((1 + fit.chest) * (neck_x + kShoulderSeam) / shoulder_x - 1),
                        m.neck_width);
  throw ShirtRefusal(
      {InputPlace{{}, 0, has_neck ? "measures.neck_width" : "fit.chest"},
       has_neck ? fmt::format("{:.4g} m", m.neck_width) : fmt::format("{:.4g}", fit.chest),
       expected, "the shoulder seam must be at least 20 mm long"},
      ShirtRule::neck, neck_x - most);
}

}  // namespace

void check_shirt_input(const ShirtMeasures& m, const ShirtFit& fit) {
  for (const ShirtMeasure& measure : shirt_measure_list())
    in_range(std::string("measures.") + measure.name, m.*measure.field, measure.low, measure.high,
             measure.unit);
  in_range("fit.chest", fit.chest, -0.5, 2.0, "");
  if (fit.waist) in_range("fit.waist", *fit.waist, -0.5, 3.0, "");
  in_range("fit.hip", fit.hip, -0.5, 2.0, "");
  in_range("fit.sleeve", fit.sleeve, -0.5, 3.0, "");
  if (fit.elbow) in_range("fit.elbow", *fit.elbow, -0.5, 3.0, "");
  if (fit.forearm) in_range("fit.forearm", *fit.forearm, -0.5, 3.0, "");
  in_range("fit.wrist", fit.wrist, -0.5, 3.0, "");
  in_range("fit.neck_ease", fit.neck_ease, -0.2, 1.0, "");
  in_range("fit.scye_ease", fit.scye_ease, -0.02, 0.15, " m");
  in_range("fit.shoulder_follow", fit.shoulder_follow, 0.0, 1.0, "");
  in_range("fit.cap_ease", fit.cap_ease, -0.05, 0.15, "");
  in_range("fit.cap_ratio", fit.cap_ratio, 0.4, 0.85, "");
  in_range("fit.sleeve_length", fit.sleeve_length, 0.25, 1.0, "");
  in_range("fit.sleeve_follow", fit.sleeve_follow, 0.0, 1.0, "");
  in_range("fit.elbow_bend", fit.elbow_bend, 0.0, 40.0, " degrees");
  in_range("fit.bust_dart", fit.bust_dart, 0.0, 1.0, "");
  in_range("fit.back_waist", fit.back_waist, 0.0, 0.06, " m");
  check_bands(fit);
}

void throw_sleeve_too_wide(const ShirtMeasures& m, const ShirtFit& fit, double arm,
                           double armhole) {
  // A flat cap is slightly longer than the girth, so the girth may at most reach the armhole.
  throw ShirtRefusal({InputPlace{{}, 0, "fit.sleeve"}, fmt::format("{:.4g}", fit.sleeve),
                      fmt::format("below about {:.2f} for the deepest armhole of {:.3f} m that "
                                  "chest {:.3f} m at fit {:.3g} allows",
                                  armhole * (1 + fit.cap_ease) * 0.97 / arm - 1, armhole,
                                  m.chest, fit.chest),
                      "narrow the sleeve, loosen the chest or raise fit.scye_ease"},
                     ShirtRule::sleeve_width);
}

void check_shirt_levels(const ShirtMeasures& m, const ShirtFit& fit, double shoulder_y,
                        double underarm_y) {
  constexpr double kLeast = 0.03;  // between two levels of the torso [m]
  if (underarm_y > shoulder_y - kLeast)
    throw ShirtRefusal(
        {InputPlace{{}, 0, "measures.shoulder_slope"}, fmt::format("{:.4g} rad", m.shoulder_slope),
         "a slope that leaves the garment's shoulder 0.03 m above the underarm",
         "a chest this loose drops the shoulder too far; lower fit.chest or fit.shoulder_follow"},
        ShirtRule::shoulder_level, underarm_y - (shoulder_y - kLeast));
  const auto level = [&](ShirtRule rule, const char* key, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw ShirtRefusal(
        {InputPlace{{}, 0, key}, fmt::format("{:.4g} m", value),
         high < 10 ? fmt::format("{:.3f} to {:.3f} m, between underarm and hem", told_least(low),
                                 told_most(high))
                   : fmt::format("at least {:.3f} m, below the underarm", told_least(low))},
        rule, value < low ? low - value : high - value);
  };
  const double raised =
      std::max(0.0, -hem_side_drop(m.front_balance));  // the ends of the side seams
  level(ShirtRule::hem_level, "measures.hps_to_hem", m.hps_to_hem,
        -underarm_y + 2 * kLeast + raised, 1e3);
  const bool shaped = back_waist_intake(fit) > 0;
  if (fit.waist || shaped)
    level(ShirtRule::waist_level, "measures.hps_to_waist", m.hps_to_waist,
          -underarm_y + (shaped ? kBackTipDrop + kBackTipToWaist : kLeast),
          m.hps_to_hem - (shaped ? kBackWaistToHem : kLeast) - raised);
}

void check_shirt_outlines(const pattern::Pattern& shirt, const ShirtMeasures& m,
                          const ShirtFit& fit, double shoulder_x, double under_length) {
  const double neck_x = fit_neck(m, fit).half_width;
  if (shoulder_x < neck_x + kShoulderSeam) throw_neck_too_wide(m, fit, neck_x, shoulder_x);
  const double least = fit.sleeve_length < 1 ? 0.03 : 0.05;  // of the underarm seam [m]
  if (under_length < least && fit.sleeve_length < 1)
    throw ShirtRefusal(
        {InputPlace{{}, 0, "fit.sleeve_length"}, fmt::format("{:.4g}", fit.sleeve_length),
         fmt::format("at least {:.2f} for this armhole and sleeve",
                     fit.sleeve_length + (least - under_length) / m.arm_length + 0.005)},
        ShirtRule::sleeve_length, least - under_length);
  if (under_length < least)
    throw ShirtRefusal(
        {InputPlace{{}, 0, "measures.arm_length"}, fmt::format("{:.4g} m", m.arm_length),
         fmt::format("at least {:.3f} m for this armhole and sleeve",
                     told_least(m.arm_length + least - under_length))},
        ShirtRule::sleeve_length, least - under_length);
  for (const pattern::Panel& panel : shirt.panels) {
    const std::vector<Vec2> outline = pattern::outline_polygon(panel);
    if (pattern::first_self_crossing(outline).first < 0 && pattern::signed_area(outline) > 0)
      continue;
    const bool torso = panel.label == "body";
    throw ShirtRefusal({InputPlace{{}, 0, torso ? "fit.chest" : "fit.wrist"},
                        fmt::format("{:.4g}", torso ? fit.chest : fit.wrist),
                        fmt::format("a fit whose {} piece has a simple outline", panel.name),
                        torso ? "check that hem and waist lie below the underarm and the girths of "
                                "chest, waist and hip belong to one body"
                              : "the wrist is too narrow for this upper arm, or too wide"},
                       torso ? ShirtRule::torso_outline : ShirtRule::sleeve_outline);
  }
}

}  // namespace loosefit::kinds
