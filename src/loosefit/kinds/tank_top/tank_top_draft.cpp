#include "loosefit/kinds/tank_top/tank_top_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/told_limit.h"
#include "loosefit/pattern/drafting.h"

namespace loosefit::kinds {
namespace {

constexpr double kLeastSide = 0.06;       ///< side seam [m]
constexpr double kLeastShoulder = 0.03;   ///< of the body, from neck to shoulder point [m]
constexpr double kInsideUnderarm = 0.92;  ///< the strap's outer end, of the underarm's breadth
constexpr double kLeastStrap = 0.15;      ///< of the body's shoulder

/// Half of a piece, x ≥ 0 from the centre line, y = 0 at the high point shoulder of the body.
struct Half {
  pattern::CurveChain neck;     ///< centre → strap
  pattern::CurveChain strap;    ///< inner → outer end
  pattern::CurveChain armhole;  ///< strap → underarm
  pattern::CurveChain side;     ///< underarm → hem
  pattern::CurveChain hem;      ///< side → centre
};

double measure(const NamedValues& m, const char* name) {
  const auto found = m.find(name);
  return found == m.end() ? 0 : found->second;
}

TorsoLevels levels_of(const BodyMeasures& m, const NamedValues& fit) {
  const double shoulder = m.at("shoulder_breadth") / 2 - m.at("neck") / 5;
  TorsoLevels levels;
  levels.chest = m.at("chest"), levels.waist = m.at("waist"), levels.hip = m.at("hip");
  levels.chest_fit = fit.at("chest"), levels.hip_fit = fit.at("hip");
  if (const auto waist = fit.find("waist"); waist != fit.end()) levels.waist_fit = waist->second;
  levels.trunk = m.along.trunk;
  levels.front_fullness = measure(m, "front_fullness");
  levels.underarm_y =
      -std::tan(m.at("shoulder_slope")) * shoulder - m.at("scye_depth") - fit.at("scye_ease");
  levels.waist_y = -m.at("hps_to_waist");
  levels.hem_y = -m.at("hps_to_hem");
  levels.side_drop = hem_side_drop(measure(m, "front_balance"));
  return levels;
}

/// Half the breadth at the underarm of the narrower piece [m].
double narrow_underarm(const BodyMeasures& m, const NamedValues& fit) {
  const TorsoLevels levels = levels_of(m, fit);
  return (1 + levels.chest_fit) * levels.chest / 4 - std::abs(side_shift(levels, true));
}

Half draft_half(const BodyMeasures& m, const NamedValues& fit, bool front) {
  // The body's shoulder runs from the side of the neck down to the shoulder point.
  const double x_neck = m.at("neck") / 5, x_shoulder = m.at("shoulder_breadth") / 2;
  const double slope = std::tan(m.at("shoulder_slope")), length = x_shoulder - x_neck;
  Half half;
  half.side = draft_side(levels_of(m, fit), front);
  const double x_underarm = half.side.start.x(), y_underarm = half.side.start.y();
  const double width = fit.at("strap_width");
  const double inner = x_neck + fit.at("strap_place") * (1 - width) * length;
  const double outer = inner + width * length;
  const Vec2 strap_inner(inner, -slope * (inner - x_neck)),
      strap_outer(outer, -slope * (outer - x_neck)), underarm(x_underarm, y_underarm);
  const double y_neck =
      strap_inner.y() + fit.at(front ? "neck_drop" : "back_drop") * (y_underarm - strap_inner.y());
  const double depth = strap_outer.y() - y_underarm, fall = strap_inner.y() - y_neck;

  // A scoop: level at the centre, along the strap at its end.
  half.neck.start = Vec2(0, y_neck);
  half.neck.cubic_to({0.62 * inner, y_neck}, {0.97 * inner, y_neck + 0.45 * fall}, strap_inner);
  half.strap.start = strap_inner;
  half.strap.line_to(strap_outer);
  // Down along the strap, then outwards and level into the underarm.
  half.armhole.start = strap_outer;
  half.armhole.cubic_to(strap_outer - Vec2(0, 0.62 * depth),
                        underarm - Vec2(0.70 * (x_underarm - outer), 0), underarm);
  // The way down over bust or belly is longer than over the back, and midway at the sides.
  const double longer = front ? measure(m, "front_balance") : 0.0;
  half.hem = draft_hem(half.side.end(), -m.at("hps_to_hem") - longer);
  return half;
}

pattern::Panel piece(const Half& half, bool front) {
  // Which of the wearer's sides lies at x > 0, seen from outside.
  const std::string right = front ? "L" : "R", left = front ? "R" : "L";
  pattern::CurveChain neck = half.neck.reversed(), other = half.neck.mirrored(),
                      hem = half.hem.mirrored(), rest = half.hem.reversed();
  neck.curves.insert(neck.curves.end(), other.curves.begin(), other.curves.end());
  neck.knots.insert(neck.knots.end(), other.knots.begin(), other.knots.end());
  hem.curves.insert(hem.curves.end(), rest.curves.begin(), rest.curves.end());
  hem.knots.insert(hem.knots.end(), rest.knots.begin(), rest.knots.end());
  return pattern::draft_panel(front ? "front" : "back", "body",
                              {{"hem", hem},
                               {"side_" + right, half.side.reversed()},
                               {"armhole_" + right, half.armhole.reversed()},
                               {"shoulder_" + right, half.strap.reversed()},
                               {"neck", neck},
                               {"shoulder_" + left, half.strap.mirrored()},
                               {"armhole_" + left, half.armhole.mirrored()},
                               {"side_" + left, half.side.mirrored()}});
}

}  // namespace

StrapRoom strap_room(const BodyMeasures& m, const NamedValues& fit) {
  const double x_neck = m.at("neck") / 5, length = m.at("shoulder_breadth") / 2 - x_neck;
  const double underarm = narrow_underarm(m, fit), width = fit.at("strap_width");
  StrapRoom room;
  room.width = std::min(1.0, (kInsideUnderarm * underarm - x_neck) / length);
  room.place = width < 1 ? std::clamp((room.width - width) / (1 - width), 0.0, 1.0) : 1.0;
  // The underarm is as broad as 1 + fit.chest.
  room.least_chest =
      (x_neck + kLeastStrap * length) / kInsideUnderarm / (underarm / (1 + fit.at("chest"))) - 1;
  return room;
}

double shortest_tank_top(const BodyMeasures& m, const NamedValues& fit) {
  const double length = m.at("shoulder_breadth") / 2 - m.at("neck") / 5;
  return std::tan(m.at("shoulder_slope")) * length + m.at("scye_depth") + fit.at("scye_ease") +
         kLeastSide;
}

double least_front_balance(const BodyMeasures& m, const NamedValues& fit) {
  return shortest_tank_top(m, fit) - kLeastSide / 2 - m.at("hps_to_hem");
}

pattern::Pattern draft_tank_top(const BodyMeasures& m, const NamedValues& fit) {
  const auto refuse_below = [&](const char* key, double least, const char* why) {
    if (!(m.at(key) >= least))
      throw InvalidInput({{}, 0, std::string("measures.") + key},
                         fmt::format("{:.4g} m", m.at(key)),
                         fmt::format("at least {:.3f} m, {}", told_least(least), why));
  };
  refuse_below("shoulder_breadth", 2 * (m.at("neck") / 5 + kLeastShoulder),
               "so that the shoulders leave room for straps beside the neck");
  refuse_below("hps_to_hem", shortest_tank_top(m, fit), "below the underarm");
  if (m.count("front_balance"))
    refuse_below("front_balance", least_front_balance(m, fit),
                 "so that the front too ends below the underarm");
  if (fit.count("waist")) {
    refuse_below("hps_to_waist", shortest_tank_top(m, fit) - kLeastSide / 2, "below the underarm");
    const double raised = std::max(0.0, -hem_side_drop(measure(m, "front_balance")));
    refuse_below("hps_to_hem", m.at("hps_to_waist") + kLeastSide / 2 + raised, "below the waist");
  }
  // Straps stand on the shoulder inside the underarm.
  constexpr double kRounding = 1e-9;
  const StrapRoom room = strap_room(m, fit);
  const auto refuse_fit = [&](const char* key, const std::string& expected) {
    throw InvalidInput({{}, 0, std::string("fit.") + key}, fmt::format("{:.4g}", fit.at(key)),
                       expected);
  };
  if (room.width < kLeastStrap)
    refuse_fit("chest", fmt::format("at least {:.3f}, so that straps have room between neck and "
                                    "underarm",
                                    told_least(room.least_chest)));
  if (fit.at("strap_width") > room.width + kRounding)
    refuse_fit("strap_width", fmt::format("at most {:.3f}, inside the underarm of this chest",
                                          told_most(room.width)));
  if (fit.at("strap_place") > room.place + kRounding)
    refuse_fit("strap_place", fmt::format("at most {:.3f}, inside the underarm of this chest",
                                          told_most(room.place)));
  pattern::Pattern tank;
  tank.name = tank.kind = "tank-top";
  tank.panels = {piece(draft_half(m, fit, true), true), piece(draft_half(m, fit, false), false)};
  for (const std::string side : {"L", "R"}) {
    pattern::sew_edges(tank, "side_" + side, "front", "side_" + side, "back", "side_" + side);
    pattern::sew_edges(tank, "shoulder_" + side, "front", "shoulder_" + side, "back",
                       "shoulder_" + side);
  }
  tank.panel_order = {0, 1};
  // Columns: panel x, panel y and outside normal in our frame; the wearer faces −y.
  const double hps_height = 3.3 * m.at("hps_to_waist");
  tank.panels[0].rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  tank.panels[0].translation = Vec3(0, -0.25, hps_height);
  tank.panels[1].rotation << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  tank.panels[1].translation = Vec3(0, 0.22, hps_height);
  return tank;
}

}  // namespace loosefit::kinds
