#include "loosefit/kinds/trousers/trousers_draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/kinds/told_limit.h"
#include "loosefit/kinds/trousers/trousers_leg.h"
#include "loosefit/kinds/trousers/trousers_seams.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/named_cloth.h"

namespace loosefit::kinds {
namespace {

using pattern::CurveChain;

constexpr double kLeastRise = 0.10;    ///< from crotch to waist edge [m]
constexpr double kLeastInseam = 0.05;  ///< [m]

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
pattern::Panel band(const BodyMeasures& m, const NamedValues& fit, bool front) {
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

void check_lengths(const BodyMeasures& m, const NamedValues& fit) {
  const auto refuse = [](const std::string& key, double found, double least, const char* why) {
    throw InvalidInput({{}, 0, key}, fmt::format("{:.4g}", found),
                       fmt::format("at least {:.3f}, {}", told_least(least), why));
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
                                   told_least(least)),
                       "the waistband gathers what is left; without fit.waist it is that");
}

}  // namespace

pattern::Pattern draft_trousers(const char* kind, const BodyMeasures& m, const NamedValues& fit,
                                const std::set<std::string>& asked) {
  check_lengths(m, fit);
  const Easing easing = ease_legs(m, fit);
  check_seams(m, fit, easing, asked);
  const Leg front = draft_leg(m, fit, true, easing), back = draft_leg(m, fit, false, easing);
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
