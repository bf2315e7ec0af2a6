#include "loosefit/kinds/shirt/shirt_bands.h"

#include <algorithm>
#include <array>
#include <set>

#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/named_cloth.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

pattern::Panel strip(const std::string& name, const std::string& label,
                     const std::array<pattern::CurveChain, 4>& sides, const StripEdges& edges,
                     double stiffness) {
  pattern::Panel panel = pattern::draft_panel(name, label,
                                              {{edges.below, sides[0]},
                                               {edges.right, sides[1]},
                                               {edges.above, sides[2]},
                                               {edges.left, sides[3]}});
  panel.cloth = pattern::cloth_of_layers(2, stiffness);
  return panel;
}

pattern::CurveChain straight(const Vec2& from, const Vec2& to) {
  pattern::CurveChain side;
  side.start = from;
  side.line_to(to);
  return side;
}

/// Rectangle from (x, low) to (x + length, high).
std::array<pattern::CurveChain, 4> rectangle(double x, double length, double low, double high) {
  const Vec2 corners[] = {{x, low}, {x + length, low}, {x + length, high}, {x, high}};
  std::array<pattern::CurveChain, 4> sides;
  for (int i = 0; i < 4; ++i) sides[i] = straight(corners[i], corners[(i + 1) % 4]);
  return sides;
}

/// A whole neck edge from its half, from negative to positive x.
pattern::CurveChain both_halves(const pattern::CurveChain& half) {
  pattern::CurveChain whole = half.mirrored().reversed();
  whole.curves.insert(whole.curves.end(), half.curves.begin(), half.curves.end());
  whole.knots.insert(whole.knots.end(), half.knots.begin(), half.knots.end());
  return whole;
}

/// What lies between the neck of this fit and that without a neckband: flat where the shirt is.
std::array<pattern::CurveChain, 4> curved_neckband(const ShirtMeasures& m, const ShirtFit& fit,
                                                   bool front) {
  ShirtFit without = fit;
  without.neckband = 0;
  const pattern::CurveChain seam = both_halves(draft_neck_half(m, fit, front)),
                            rim = both_halves(draft_neck_half(m, without, front));
  return {seam, straight(seam.end(), rim.end()), rim.reversed(), straight(rim.start, seam.start)};
}

double length_of(const pattern::Pattern& shirt, const std::string& panel, const char* edge) {
  const pattern::Panel& piece = shirt.panels[shirt.find_part(panel)];
  return pattern::EdgePath(piece, pattern::find_edge_part(piece, edge)).length();
}

void add_neckband(pattern::Pattern& shirt, const ShirtMeasures& m, const ShirtFit& fit) {
  for (const std::string half : {"front", "back"}) {
    const bool front = half == "front";  // x > 0 is the wearer's left in front
    const double length = (1 - fit.neckband_stretch) * length_of(shirt, half, "neck");
    shirt.panels.push_back(strip(
        "neckband_" + half, "body",
        fit.neckband_stretch > 0 ? rectangle(-length / 2, length, 0, fit.neckband)
                                 : curved_neckband(m, fit, front),
        {"seam", front ? "end_L" : "end_R", "rim", front ? "end_R" : "end_L"}, fit.band_stiffness));
    pattern::sew_edges(shirt, "neckband_" + half, half, "neck", "neckband_" + half, "seam");
  }
  for (const std::string end : {"end_L", "end_R"})
    pattern::sew_edges(shirt, "neckband_" + end, "neckband_front", end, "neckband_back", end);
}

void add_cuffs(pattern::Pattern& shirt, const ShirtFit& fit) {
  for (const std::string s : {"L", "R"}) {
    const std::string cuff = "cuff_" + s;
    for (const std::string half : {"front", "back"}) {
      const std::string sleeve = "sleeve_" + s + "_" + half, name = cuff + "_" + half;
      const double length = (1 - fit.cuff_stretch) * length_of(shirt, sleeve, "cuff");
      // As its half of the sleeve, whose top line is x = 0.
      const bool at_positive_x = (s == "L") == (half == "back");
      shirt.panels.push_back(strip(name, "arm",
                                   rectangle(at_positive_x ? 0 : -length, length, -fit.cuff, 0),
                                   at_positive_x ? StripEdges{"rim", "under", "seam", "top"}
                                                 : StripEdges{"rim", "top", "seam", "under"},
                                   fit.band_stiffness));
      pattern::sew_edges(shirt, name, sleeve, "cuff", name, "seam");
    }
    for (const std::string end : {"top", "under"})
      pattern::sew_edges(shirt, cuff + "_" + end, cuff + "_front", end, cuff + "_back", end);
  }
}

}  // namespace

pattern::Panel folded_strip(const std::string& name, const std::string& label,
                            const StripPlace& place, const StripEdges& edges, double stiffness) {
  return strip(name, label, rectangle(place.x, place.length, place.low, place.high), edges,
               stiffness);
}

void add_bands(pattern::Pattern& shirt, const ShirtMeasures& m, const ShirtFit& fit) {
  if (fit.neckband > 0) add_neckband(shirt, m, fit);
  if (fit.cuff > 0) add_cuffs(shirt, fit);
}

void finish_edges(pattern::Pattern& shirt, const ShirtFit& fit) {
  std::set<std::pair<int, int>> sewn;
  for (const pattern::Stitch& stitch : shirt.stitches) {
    sewn.insert({stitch.first.panel, stitch.first.edge});
    sewn.insert({stitch.second.panel, stitch.second.edge});
  }
  for (int p = 0; p < static_cast<int>(shirt.panels.size()); ++p)
    for (int e = 0; e < static_cast<int>(shirt.panels[p].edges.size()); ++e)
      if (!find_shirt_part(shirt.panels[p].part)->band && !sewn.count({p, e}))
        shirt.panels[p].edges[e].finish = fit.edge_finish;
}

}  // namespace loosefit::kinds
