#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/pattern/curve_chain.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/known_garment.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/place_pieces.h"
#include "support/simple_patterns.h"

/// Pieces that nothing is sewn of yet and that lie at the origin, for tests of seams and placement.
namespace loosefit::testing_support {

inline pattern::CurveChain straight(const Vec2& a, const Vec2& b) {
  pattern::CurveChain chain;
  chain.start = a;
  chain.line_to(b);
  return chain;
}
inline pattern::CurveChain curved(const Vec2& a, const Vec2& c1, const Vec2& c2, const Vec2& b) {
  pattern::CurveChain chain;
  chain.start = a;
  chain.cubic_to(c1, c2, b);
  return chain;
}

/// A panel whose edges are called e1, e2, ….
inline pattern::Panel numbered_panel(const std::string& name,
                                     const std::vector<pattern::CurveChain>& loop) {
  std::vector<std::pair<std::string, pattern::CurveChain>> named;
  for (const pattern::CurveChain& chain : loop)
    named.emplace_back("e" + std::to_string(named.size() + 1), chain);
  pattern::Panel panel = pattern::draft_panel(name, "", named);
  panel.part.clear();
  for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
  return panel;
}

inline pattern::Panel mirrored_panel(const std::string& name,
                                     const std::vector<pattern::CurveChain>& loop) {
  std::vector<pattern::CurveChain> image;
  for (const pattern::CurveChain& chain : loop) image.push_back(chain.mirrored().reversed());
  std::reverse(image.begin(), image.end());
  return numbered_panel(name, image);
}

/// Turned by 180 degrees in its plane.
inline void turn_panel(pattern::Panel& panel) {
  for (Vec2& v : panel.vertices) v = -v;
  for (pattern::PanelEdge& edge : panel.edges) {
    for (Vec2& k : edge.knots) k = -k;
    for (pattern::EdgeCurve& curve : edge.curves)
      for (Vec2& c : curve.control) c = -c;
  }
}

inline void rotate_edges(pattern::Panel& panel, int by) {
  std::rotate(panel.edges.begin(), panel.edges.begin() + by, panel.edges.end());
}

/// Front, back, right sleeve, left sleeve; sleeves in one piece. Edges of trunks: hem, side at
/// x > 0, armhole, shoulder, neck, shoulder, armhole, side.
inline pattern::Pattern unsewn_tshirt(double chest = 0.50, double length = 0.60) {
  const double w = chest / 2, under = length - 0.205, n = 0.08, s = 0.19, tip = length - 0.045;
  const auto trunk = [&](double neck, double pitch) {
    const std::vector<pattern::CurveChain> right = {
        straight({w, 0}, {w - 0.01, under}),
        curved({w - 0.01, under}, {w - 0.05, under}, {pitch, under + 0.06}, {s, tip}),
        straight({s, tip}, {n, length - 0.008})};
    std::vector<pattern::CurveChain> loop = {straight({-w, 0}, {w, 0})};
    loop.insert(loop.end(), right.begin(), right.end());
    pattern::CurveChain neckline = curved({n, length - 0.008}, {0.9 * n, length - 0.5 * neck},
                                          {0.5 * n, length - neck}, {0, length - neck});
    const pattern::CurveChain half = neckline.mirrored().reversed();
    neckline.cubic_to(half.curves[0].control[0], half.curves[0].control[1], half.end());
    loop.push_back(neckline);
    for (int i = 2; i >= 0; --i) loop.push_back(right[i].mirrored().reversed());
    return loop;
  };
  const auto front = trunk(0.10, 0.155), back = trunk(0.03, 0.165);
  const double hole = front[2].length() + back[2].length();
  // The cap as high as the armholes are long.
  const double b = 0.155, down = 0.15;
  const auto cap = [&](double h) {
    pattern::CurveChain chain = curved({b, 0}, {0.7 * b, 0}, {0.55 * b, h}, {0, h});
    chain.cubic_to({-0.58 * b, h}, {-0.78 * b, 0}, {-b, 0});
    return chain;
  };
  double low = 0.01, high = 0.3;
  for (int i = 0; i < 60; ++i) {
    const double h = 0.5 * (low + high);
    (cap(h).length() < hole ? low : high) = h;
  }
  const std::vector<pattern::CurveChain> sleeve = {straight({-0.9 * b, -down}, {0.9 * b, -down}),
                                                   straight({0.9 * b, -down}, {b, 0}), cap(high),
                                                   straight({-b, 0}, {-0.9 * b, -down})};
  pattern::Pattern pattern;
  pattern.name = "tee";
  pattern.panels = {numbered_panel("front", front), numbered_panel("back", back),
                    numbered_panel("sleeve", sleeve), mirrored_panel("sleeve_mirrored", sleeve)};
  return pattern;
}

/// Two fronts and two backs, each as drawn and mirrored, without a waistband.
inline pattern::Pattern unsewn_trousers(double waist = 0.84, double hip = 1.00, double rise = 0.26,
                                        double length = 0.95) {
  const auto leg = [&](double fork, double w, double h) {
    const double hem = 0.11, crease = 0.5 * (h - fork);
    return std::vector<pattern::CurveChain>{
        straight({crease - hem, -length}, {crease + hem, -length}),
        curved({crease + hem, -length}, {crease + hem, -0.6 * length}, {h, -rise - 0.05}, {w, 0}),
        straight({w, 0}, {0, 0}),
        curved({0, 0}, {0, -0.8 * rise}, {-0.3 * fork, -rise}, {-fork, -rise}),
        curved({-fork, -rise}, {-0.7 * fork, -rise - 0.1}, {crease - hem, -0.6 * length},
               {crease - hem, -length})};
  };
  const double w = waist / 4, h = hip / 4;
  auto front = leg(0.05, w, h), back = leg(0.05, w, h);
  // A back that is the same but for its fork, whose sides are as long.
  back = leg(0.052, w, h);
  pattern::Pattern pattern;
  pattern.name = "trousers";
  pattern.panels = {numbered_panel("front", front), mirrored_panel("front_mirrored", front),
                    numbered_panel("back", back), mirrored_panel("back_mirrored", back)};
  return pattern;
}

/// A strip that is drawn upright, longer than wide.
inline pattern::Panel upright_strip(const std::string& name, double length, double width) {
  return numbered_panel(name,
                        {straight({0, 0}, {width, 0}), straight({width, 0}, {width, length}),
                         straight({width, length}, {0, length}), straight({0, length}, {0, 0})});
}

/// Half of a hood as the wearer's left one, seen from outside: neck, back (over the head), face.
/// \param neck length of its neck edge [m]
inline std::vector<pattern::CurveChain> hood_half(double neck, double height = 0.35,
                                                  double depth = 0.26) {
  const double rise = 0.2;  // [rad], of the neck to the shoulder and up again
  const Vec2 shoulder(0.5 * neck * std::cos(rise), -0.5 * neck * std::sin(rise)),
      nape(neck * std::cos(rise), 0), fullest(depth, 0.55 * height), top(0, height);
  pattern::CurveChain edge = straight({0, 0}, shoulder), over;
  edge.line_to(nape);
  over.start = nape;
  over.cubic_to(nape + Vec2(0, 0.15 * height), fullest - Vec2(0, 0.2 * height), fullest)
      .cubic_to(fullest + Vec2(0, 0.25 * height), Vec2(0.55 * depth, 1.01 * height), top);
  return {edge, over, straight(top, {0, 0})};
}

/// A T-shirt and the halves of a hood, right then left, as long as its neck, which a strip of that
/// width may join; the strip is drawn upright.
inline pattern::Pattern unsewn_hoodie(double strip = 0) {
  pattern::Pattern pattern = unsewn_tshirt();
  double neck = 0;
  for (const pattern::Panel& panel : {pattern.panels[0], pattern.panels[1]})
    neck += pattern::EdgePath(panel, 4).length();
  const auto half = hood_half(0.5 * (neck - strip));
  pattern.panels.push_back(mirrored_panel("hood", half));
  pattern.panels.push_back(numbered_panel("hood_2", half));
  if (strip > 0) pattern.panels.push_back(upright_strip("hood_center", half[1].length(), strip));
  return pattern;
}

/// Front, back, right sleeve, left sleeve; the raglan of the back is longer.
inline pattern::Pattern unsewn_raglan() {
  const double w = 0.26, under = 0.38, n = 0.07;
  const auto trunk = [&](double top, double neck) {
    pattern::CurveChain hollow =
        curved({n, top}, {0.9 * n, top - 0.7 * neck}, {0.5 * n, top - neck}, {0, top - neck});
    const pattern::CurveChain half = hollow.mirrored().reversed();
    hollow.cubic_to(half.curves[0].control[0], half.curves[0].control[1], half.end());
    return std::vector<pattern::CurveChain>{
        straight({-w, 0}, {w, 0}),        straight({w, 0}, {w, under}),
        straight({w, under}, {n, top}),   hollow,
        straight({-n, top}, {-w, under}), straight({-w, under}, {-w, 0})};
  };
  const auto front = trunk(0.58, 0.08), back = trunk(0.595, 0.02);
  const double f = front[2].length(), b = back[2].length();
  // The neck of the sleeve is where both raglans reach, 4 cm apart.
  const double x = 0.17, at = 0.02;
  const Vec2 front_top(at, std::sqrt(f * f - (x - at) * (x - at))),
      back_top(-at, std::sqrt(b * b - (x - at) * (x - at)));
  const std::vector<pattern::CurveChain> sleeve = {
      straight({-0.12, -0.3}, {0.12, -0.3}), straight({0.12, -0.3}, {x, 0}),
      straight({x, 0}, front_top),           straight(front_top, back_top),
      straight(back_top, {-x, 0}),           straight({-x, 0}, {-0.12, -0.3})};
  pattern::Pattern pattern;
  pattern.name = "raglan";
  pattern.panels = {numbered_panel("front", front), numbered_panel("back", back),
                    numbered_panel("sleeve", sleeve), mirrored_panel("sleeve_mirrored", sleeve)};
  return pattern;
}

inline pattern::Pattern unsewn_skirt(double waist = 0.74, double hem = 1.2, double length = 0.55) {
  const auto panel = [&](const std::string& name) {
    return numbered_panel(
        name, {straight({-hem / 4, 0}, {hem / 4, 0}), straight({hem / 4, 0}, {waist / 4, length}),
               straight({waist / 4, length}, {-waist / 4, length}),
               straight({-waist / 4, length}, {-hem / 4, 0})});
  };
  pattern::Pattern pattern;
  pattern.name = "skirt";
  pattern.panels = {panel("front"), panel("back")};
  return pattern;
}

/// Left and right leg in one piece each: hem, inseam and crotch of the back, waist, crotch and
/// inseam of the front on the left one.
inline pattern::Pattern unsewn_leggings(double waist = 0.74, double hip = 0.95, double rise = 0.26,
                                        double length = 0.70, double hem = 0.28) {
  const double w = waist / 4, h = hip / 4, fork = 0.07;
  const std::vector<pattern::CurveChain> left = {
      straight({-hem / 2, 0}, {hem / 2, 0}),
      straight({hem / 2, 0}, {h + fork, length}),
      curved({h + fork, length}, {h, length + 0.02}, {h, length + 0.1}, {w, length + rise + 0.03}),
      straight({w, length + rise + 0.03}, {-w, length + rise}),
      curved({-w, length + rise}, {-h, length + 0.1}, {-h, length + 0.02}, {-h - fork, length}),
      straight({-h - fork, length}, {-hem / 2, 0})};
  pattern::Pattern pattern;
  pattern.name = "leggings";
  pattern.panels = {numbered_panel("leg", left), mirrored_panel("leg_mirrored", left)};
  return pattern;
}

/// Sewn by what its pieces are and placed by nobody: its pieces lie at the origin.
inline pattern::Pattern from_nothing(pattern::Pattern pattern) {
  std::vector<pattern::Notch> notches;
  const pattern::KnownGarment known = pattern::know_garment(pattern);
  EXPECT_TRUE(known.certain()) << (known.doubts.empty() ? "" : known.doubts.front());
  pattern::sew_chains(pattern, known.seams, notches);
  pattern::place_pieces(pattern);
  return pattern;
}

}  // namespace loosefit::testing_support
