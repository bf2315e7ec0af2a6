#pragma once
#include "loosefit/body/body.h"
#include "support/simple_patterns.h"

/// Garments of other kinds than the shirt, cut to a body and placed flat before and behind it, as
/// pattern programs place them: front panels 0.22 m before the middle, back panels 0.18 m behind.
/// Lengths in metres; `ring` and `ease` are shares of the body's girth at that level.
namespace loosefit::testing_support {

struct Levels {
  double waist, hip, chest, thigh, calf;            ///< girths
  double waist_height, crotch_height, neck_height;  ///< above the soles
  double shoulder_breadth, neck_width;
};

inline Levels levels_of(const body::Body& body) {
  const auto at = [&](const char* name) { return body.measured.at(name); };
  return {at("waist"),
          at("hip"),
          at("chest"),
          at("thigh"),
          at("calf"),
          at("waist_level"),
          at("crotch_height"),
          body.landmarks.at("hps_L").z(),
          at("shoulder_breadth"),
          at("neck_width")};
}

/// Stands upright at x, facing the front or the back; panel origin at the given height.
inline pattern::Panel placed(pattern::Panel panel, bool back, double x, double height) {
  const double side = back ? -1 : 1;
  panel.rotation.col(0) = side * Vec3::UnitX();
  panel.rotation.col(1) = Vec3::UnitZ();
  panel.rotation.col(2) = -side * Vec3::UnitY();
  panel.translation = Vec3(x, back ? 0.18 : -0.22, height);
  return panel;
}

/// A skirt of `count` panels in a ring, straight from the waist to the hem, without a waistband.
inline pattern::Pattern skirt(const Levels& of, double ring, double hem, double length, int count) {
  pattern::Pattern pattern;
  pattern.name = "skirt";
  const double top = ring * of.waist / count, bottom = hem * of.hip / count;
  const double radius = 0.06 + of.waist / (2 * kPi) * 1.2;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * kPi * (i + 0.5) / count;
    pattern::Panel panel =
        polygon_panel("gore_" + std::to_string(i),
                      {{-bottom / 2, -length}, {bottom / 2, -length}, {top / 2, 0}, {-top / 2, 0}});
    panel.rotation.col(0) = Vec3(std::cos(turn), std::sin(turn), 0);
    panel.rotation.col(1) = Vec3::UnitZ();
    panel.rotation.col(2) = Vec3(std::sin(turn), -std::cos(turn), 0);
    panel.translation = radius * panel.rotation.col(2) + of.waist_height * Vec3::UnitZ();
    pattern.panels.push_back(panel);
  }
  for (int i = 0; i < count; ++i) pattern.stitches.push_back(stitch(i, 1, (i + 1) % count, 3));
  return pattern;
}

/// Trousers without a waistband: two legs, sewn outside, inside and from waist to crotch.
inline pattern::Pattern trousers(const Levels& of, double ring, double ease) {
  pattern::Pattern pattern;
  pattern.name = "trousers";
  const double rise = of.waist_height - of.crotch_height + 0.02,
               length = rise + of.crotch_height - 0.10;
  const double w = ring * of.waist / 4, h = ease * of.hip / 4, a = 0.7 * ease * of.calf;
  for (const bool back : {false, true})
    for (const double side : {1.0, -1.0}) {  // +1: the wearer's left
      const double fork = (back ? 0.10 : 0.05) * ease * of.hip, gap = fork + 0.03;
      // Hem, outside to the waist, along the waist to the middle, down to the fork, inside.
      std::vector<Vec2> corners = {{h / 2 - fork / 2 - a / 2, -length},
                                   {h / 2 - fork / 2 + a / 2, -length},
                                   {h, -0.7 * rise},
                                   {w, 0},
                                   {0, 0},
                                   {0, -0.7 * rise},
                                   {-fork, -rise}};
      const double in_panel = back ? -side : side;  // a back panel is seen from behind
      if (in_panel < 0) {
        std::vector<Vec2> mirrored = {corners[1], corners[0], corners[6], corners[5],
                                      corners[4], corners[3], corners[2]};
        for (Vec2& p : mirrored) p.x() = -p.x();
        corners = mirrored;
      }
      pattern.panels.push_back(placed(
          polygon_panel(std::string(back ? "back" : "front") + (side > 0 ? "_L" : "_R"), corners),
          back, side * gap, of.waist_height));
    }
  // Edges of a panel as drawn, and of one that is mirrored.
  struct Edges {
    int outside_low, outside_high, middle_high, middle_low, inside;
  };
  constexpr Edges kDrawn{1, 2, 4, 5, 6}, kMirrored{6, 5, 3, 2, 1};
  const auto edges = [&](int panel) { return panel == 0 || panel == 3 ? kDrawn : kMirrored; };
  const auto sew = [&](int p, int q, int Edges::*edge) {
    pattern.stitches.push_back(stitch(p, edges(p).*edge, q, edges(q).*edge));
  };
  for (const int leg : {0, 1})
    for (const auto edge : {&Edges::outside_low, &Edges::outside_high, &Edges::inside})
      sew(leg, leg + 2, edge);
  for (const int front : {0, 2})
    for (const auto edge : {&Edges::middle_high, &Edges::middle_low}) sew(front, front + 1, edge);
  return pattern;
}

/// A sleeveless dress, or a top where the length ends above the hip.
inline pattern::Pattern dress(const Levels& of, double ease, double length) {
  pattern::Pattern pattern;
  pattern.name = "dress";
  const double s = 0.45 * of.shoulder_breadth, n = 0.75 * of.neck_width;
  const double chest = ease * of.chest / 4, waist = 1.05 * ease * of.waist / 4;
  const double hip = ease * of.hip / 4, to_waist = of.neck_height - of.waist_height;
  for (const bool back : {false, true}) {
    const double drop = back ? 0.02 : 0.09;
    pattern.panels.push_back(placed(polygon_panel(back ? "back" : "front", {{-hip, -length},
                                                                            {hip, -length},
                                                                            {waist, -to_waist},
                                                                            {chest, -0.24},
                                                                            {s, -0.10},
                                                                            {s, -0.04},
                                                                            {n, 0},
                                                                            {0, -drop},
                                                                            {-n, 0},
                                                                            {-s, -0.04},
                                                                            {-s, -0.10},
                                                                            {-chest, -0.24},
                                                                            {-waist, -to_waist}}),
                                    back, 0, of.neck_height));
  }
  // Edge k of the front lies over edge 13 − k of the back, which is turned round.
  for (const int k : {1, 2, 5, 8, 11, 12})
    pattern.stitches.push_back(stitch(0, k, 1, (13 - k) % 13));
  return pattern;
}

}  // namespace loosefit::testing_support
