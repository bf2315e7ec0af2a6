#include "loosefit/kinds/trousers/trousers_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "loosefit/base/error.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/named_cloth.h"

namespace loosefit::kinds {
namespace {

using pattern::CurveChain;

constexpr double kFrontShare = 0.48;   ///< of girths, the rest is the back's
constexpr double kFrontCrotch = 0.3;   ///< of the crotch width
constexpr double kBackRise = 0.015;    ///< the waist of the back, higher at the centre [m]
constexpr double kLeastRise = 0.10;    ///< from crotch to waist edge [m]
constexpr double kBelowTip = 0.005;    ///< thigh level below the end of the crotch curve [m]
constexpr double kLeastInseam = 0.05;  ///< [m]
/// What seams take in of each piece between hip and waist, at most [m].
constexpr double kFrontIntake = 0.034, kBackIntake = 0.060;
/// Share of that at the centre seam, at most so much [m]: the back slants over the seat.
constexpr double kFrontCentre = 0.25, kBackCentre = 0.5, kMostCentre = 0.032;

double value(const NamedValues& values, const char* name, double otherwise) {
  const auto found = values.find(name);
  return found == values.end() ? otherwise : found->second;
}

double hip_girth(const NamedValues& m, const NamedValues& fit) {
  return (1 + fit.at("hip")) * m.at("hip");
}

/// Mobility asked for at a height, between the levels that have one.
double leg_mobility_at(const NamedValues& m, const NamedValues& fit, double height) {
  const double crotch = m.at("crotch_height"), hem = hem_height(m, fit);
  std::vector<std::pair<double, double>> asked;  // height, mobility; upwards
  asked.push_back({hem, fit.at("hem")});
  for (const auto& [key, level] : {std::pair{"calf", kCalfLevel}, {"knee", kKneeLevel}})
    if (fit.count(key) && level * crotch > hem) asked.push_back({level * crotch, fit.at(key)});
  for (std::size_t i = 1; i < asked.size(); ++i)
    if (height < asked[i].first) {
      const double share = (height - asked[i - 1].first) / (asked[i].first - asked[i - 1].first);
      return asked[i - 1].second + share * (asked[i].second - asked[i - 1].second);
    }
  return asked.back().second;
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

/// One piece of a leg, its outseam at positive x.
struct Leg {
  CurveChain hem;      ///< inner → outer end
  CurveChain outseam;  ///< waist → hem
  CurveChain waist;    ///< outer end → centre
  CurveChain centre;   ///< waist → crotch
  CurveChain inseam;   ///< crotch → hem
};

/// What the seams of front and back are made as long as each other with [m].
struct Easing {
  double side_rise = 0;    ///< of the outer end of the waist
  double crotch_drop = 0;  ///< of the end of the crotch curve
};

Leg draft_leg(const NamedValues& m, const NamedValues& fit, bool front, const Easing& easing) {
  const double share = front ? kFrontShare : 1 - kFrontShare;
  const double crotch = m.at("crotch_height"), hip = hip_girth(m, fit);
  const double y_edge = waist_edge_height(m, fit), y_hem = hem_height(m, fit);
  const double y_crotch = crotch - fit.at("crotch_ease") - easing.crotch_drop;
  const double y_hip = std::max(m.at("hip_level"), y_crotch + 0.02);

  // Across: from the end of the crotch curve to the outseam, the crease in the middle.
  const double half = share * hip / 2;
  const double reach = (front ? kFrontCrotch : 1 - kFrontCrotch) * fit.at("crotch_width") * hip;
  const double x_out = (half + reach) / 2, x_tip = -x_out, x_centre = x_tip + reach;
  const double waist = share * (1 + fit.at("waist")) * m.at("waist") / 2;
  const double intake = half - waist;
  const double centre = std::clamp((front ? kFrontCentre : kBackCentre) * intake, 0.0, kMostCentre);
  const Vec2 waist_in(x_centre + centre, y_edge + (front ? 0 : kBackRise));
  const double rise = y_edge + easing.side_rise - waist_in.y();
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
  const double y_below = std::max(y_knee, y_hem);  // the next level below the thigh
  if (const double y = kThighLevel * crotch;
      fit.count("thigh") && y < y_crotch - kBelowTip && y > y_below + 0.05) {
    const double wide = (1 + fit.at("thigh")) * leg_girth_at(m, y);
    // Its outer end on the straight line from hip to knee, eased like the seam.
    const double down = (y_hip - y) / (y_hip - y_below);
    const double x = x_out + down * down * (3 - 2 * down) * (share * girth(y_below) / 2 - x_out);
    out.push_back({x, y});
    in.push_back({x - share * wide, y});
  }
  if (y_knee > y_hem + 0.03) add_level(y_knee, girth(y_knee), 0);
  // Straight from knee to hem where nothing is asked for: the hem hangs from the calf.
  if (const double y = kCalfLevel * crotch; fit.count("calf") && y > y_hem + 0.03)
    add_level(y, girth(y), 0);
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

/// The easing of the back with which its seams are as long as those of the front.
Easing ease_back(const NamedValues& m, const NamedValues& fit) {
  const Leg front = draft_leg(m, fit, true, {});
  Easing easing;
  const auto seek = [&](double& what, double low, double high, double wanted,
                        const std::function<double(const Leg&)>& length) {
    const auto at = [&](double v) {
      what = v;
      return length(draft_leg(m, fit, false, easing));
    };
    const bool grows = at(high) > at(low);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((at(middle) < wanted) == grows ? low : high) = middle;
    }
    what = 0.5 * (low + high);
  };
  double most = 0.05;  // the end of the crotch curve stays above the thigh level
  if (fit.count("thigh"))
    most = std::clamp(m.at("crotch_height") * (1 - kThighLevel) - fit.at("crotch_ease") - 0.01, 0.0,
                      most);
  seek(easing.crotch_drop, -0.05, most, front.inseam.length(),
       [](const Leg& leg) { return leg.inseam.length(); });
  seek(easing.side_rise, -0.05, 0.05, front.outseam.length(),
       [](const Leg& leg) { return leg.outseam.length(); });
  return easing;
}

pattern::Panel piece(const Leg& leg, const std::string& name, bool outseam_right) {
  if (outseam_right)
    return pattern::draft_panel(name, "leg",
                                {{"hem", leg.hem},
                                 {"outseam", leg.outseam.reversed()},
                                 {"waist", leg.waist},
                                 {"centre", leg.centre},
                                 {"inseam", leg.inseam}});
  return pattern::draft_panel(name, "leg",
                              {{"hem", leg.hem.mirrored().reversed()},
                               {"inseam", leg.inseam.mirrored().reversed()},
                               {"centre", leg.centre.mirrored().reversed()},
                               {"waist", leg.waist.mirrored().reversed()},
                               {"outseam", leg.outseam.mirrored()}});
}

/// A strip of two layers, its lower edge in two halves, each sewn to one leg.
pattern::Panel band(const NamedValues& m, const NamedValues& fit, bool front) {
  const double length = (front ? kFrontShare : 1 - kFrontShare) * (1 + fit.at("waistband")) *
                        m.at("waist"),
               width = fit.at("waistband_width");
  const auto side = [](const Vec2& from, const Vec2& to) {
    CurveChain line;
    line.start = from;
    line.line_to(to);
    return line;
  };
  const Vec2 a(-length / 2, 0), b(0, 0), c(length / 2, 0), d(length / 2, width),
      e(-length / 2, width);
  const std::string right = front ? "L" : "R", left = front ? "R" : "L";  // seen from outside
  pattern::Panel panel = pattern::draft_panel(front ? "waistband_front" : "waistband_back", "body",
                                              {{"seam_" + left, side(a, b)},
                                               {"seam_" + right, side(b, c)},
                                               {"end_" + right, side(c, d)},
                                               {"rim", side(d, e)},
                                               {"end_" + left, side(e, a)}});
  const double stiffness = fit.at("waistband_stiffness");
  panel.cloth = pattern::cloth_of_layers(2, stiffness);
  return panel;
}

/// `waist_edge`: height at which the waistband begins [m].
void place(pattern::Pattern& trousers, double waist_edge) {
  for (pattern::Panel& panel : trousers.panels) {
    const bool back = panel.part.find("back") != std::string::npos;
    // Columns: panel x, panel y and outside normal in our frame; the wearer faces −y.
    if (back)
      panel.rotation << -1, 0, 0, 0, 0, 1, 0, 1, 0;
    else
      panel.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    // The centre seam over the middle of the body.
    double x = 0, z = 0;
    for (const pattern::PanelEdge& edge : panel.edges)
      if (edge.part == "centre") {
        const Vec2 &a = panel.vertices[edge.start], &b = panel.vertices[edge.end];
        x = a.y() > b.y() ? a.x() : b.x();
      }
    if (panel.part.starts_with("waistband")) z = waist_edge;
    panel.translation = Vec3(back ? x : -x, back ? 0.22 : -0.25, z);
  }
}

void check_lengths(const NamedValues& m, const NamedValues& fit) {
  const auto refuse = [](const std::string& key, double found, double least, const char* why) {
    throw InvalidInput({{}, 0, key}, fmt::format("{:.4g}", found),
                       fmt::format("at least {:.3f}, {}", least, why));
  };
  const double crotch = m.at("crotch_height"),
               band = m.at("waist_level") - waist_edge_height(m, fit);
  if (m.at("hip_level") < crotch)
    refuse("measures.hip_level", m.at("hip_level"), crotch, "above the crotch");
  if (const double least = std::max(m.at("hip_level") + 0.02, crotch + kLeastRise) + band;
      m.at("waist_level") < least)
    refuse("measures.waist_level", m.at("waist_level"), least, "with its waistband above the hip");
  if (const double inseam = crotch - fit.at("crotch_ease") - hem_height(m, fit);
      inseam < kLeastInseam)
    refuse("fit.leg_length", fit.at("leg_length"), (kLeastInseam + fit.at("crotch_ease")) / crotch,
           "so that an inseam is left");
  constexpr double kRounding = 1e-9;
  if (const double least = least_waist(m, fit); fit.at("waist") < least - kRounding)
    throw InvalidInput({{}, 0, "fit.waist"}, fmt::format("{:.4g}", fit.at("waist")),
                       fmt::format("at least {:.3f}, which is all that the seams can take in above "
                                   "this hip",
                                   least),
                       "the waistband gathers what is left; without fit.waist it is that");
}

}  // namespace

double leg_girth_at(const NamedValues& m, double height) {
  const double hip = m.at("hip"), share = height / m.at("crotch_height");
  const std::array<std::pair<double, double>, 4> levels = {
      {{kAnkleLevel, value(m, "ankle", kAnkleOfHip * hip)},
       {kCalfLevel, value(m, "calf", kCalfOfHip * hip)},
       {kKneeLevel, value(m, "knee", kKneeOfHip * hip)},
       {kThighLevel, value(m, "thigh", kThighOfHip * hip)}}};
  if (share <= levels.front().first) return levels.front().second;
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (share <= levels[i].first) {
      const auto& [low, thin] = levels[i - 1];
      const auto& [high, thick] = levels[i];
      return thin + (share - low) / (high - low) * (thick - thin);
    }
  return levels.back().second;
}

double waist_edge_height(const NamedValues& m, const NamedValues& fit) {
  return m.at("waist_level") - 0.5 * fit.at("waistband_width");
}

double hem_height(const NamedValues& m, const NamedValues& fit) {
  return (1 - fit.at("leg_length")) * m.at("crotch_height");
}

double least_waist(const NamedValues& m, const NamedValues& fit) {
  const double front = kFrontShare * hip_girth(m, fit) / 2 - kFrontIntake,
               back = (1 - kFrontShare) * hip_girth(m, fit) / 2 - kBackIntake;
  // Both pieces are cut in proportion.
  return 2 * std::max(front / kFrontShare, back / (1 - kFrontShare)) / m.at("waist") - 1;
}

pattern::Pattern draft_trousers(const char* kind, const NamedValues& m, const NamedValues& fit) {
  check_lengths(m, fit);
  const Leg front = draft_leg(m, fit, true, {}), back = draft_leg(m, fit, false, ease_back(m, fit));
  pattern::Pattern trousers;
  trousers.name = trousers.kind = kind;
  // Seen from outside the wearer's left lies at x > 0 in front and at x < 0 behind.
  trousers.panels = {piece(front, "front_L", true), piece(front, "front_R", false),
                     piece(back, "back_L", false), piece(back, "back_R", true)};
  for (const std::string side : {"L", "R"})
    for (const std::string seam : {"outseam", "inseam"})
      pattern::sew_edges(trousers, seam + "_" + side, "front_" + side, seam, "back_" + side, seam);
  for (const std::string half : {"front", "back"})
    pattern::sew_edges(trousers, "centre_" + half, half + "_L", "centre", half + "_R", "centre");
  if (fit.at("waistband_width") > 0) {
    for (const std::string half : {"front", "back"}) {
      const std::string strip = "waistband_" + half;
      trousers.panels.push_back(band(m, fit, half == "front"));
      for (const std::string side : {"L", "R"})
        pattern::sew_edges(trousers, strip + "_" + side, half + "_" + side, "waist", strip,
                           "seam_" + side);
    }
    for (const std::string end : {"end_L", "end_R"})
      pattern::sew_edges(trousers, "waistband_" + end, "waistband_front", end, "waistband_back",
                         end);
  }
  for (int p = 0; p < static_cast<int>(trousers.panels.size()); ++p)
    trousers.panel_order.push_back(p);
  place(trousers, waist_edge_height(m, fit));
  return trousers;
}

}  // namespace loosefit::kinds
