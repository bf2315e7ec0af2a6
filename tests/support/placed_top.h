#pragma once
#include <cmath>

#include "support/simple_patterns.h"

namespace loosefit::testing_support {

/// A top of six pieces as other programs place them: front and back flat before and behind, halves
/// of sleeves turned down by `arm_angle` [rad] from the horizontal, hem at z = 0 [m].
struct PlacedTop {
  double half_width = 0.27, length = 0.62, arm_angle = 0.7, sleeve = 0.5, cuff = 0.11;

  pattern::Pattern pattern(const Vec3& shift = Vec3::Zero()) const {
    const double w = half_width, under = length - 0.24, neck = 0.085, tip = 0.19, slope = 0.045;
    const std::vector<Vec2> trunk = {{-w, 0},         {w, 0},
                                     {w, under},      {tip, length - slope},
                                     {neck, length},  {0, length - 0.08},
                                     {-neck, length}, {-tip, length - slope},
                                     {-w, under}};
    const double armhole = (trunk[3] - trunk[2]).norm(), wide = 0.17;
    const double cap = std::sqrt(armhole * armhole - wide * wide);
    // Along x to the hand, top line at y = 0.
    const std::vector<Vec2> left = {{0, 0}, {cap, -wide}, {sleeve, -cuff}, {sleeve, 0}};
    std::vector<Vec2> right;  // mirrored: its edge i is the left one's edge 3 − i
    for (int i = 0; i < 4; ++i) right.emplace_back(-left[(4 - i) % 4].x(), left[(4 - i) % 4].y());

    pattern::Pattern p;
    const auto add = [&](const char* name, const std::vector<Vec2>& outline, double turn, bool back,
                         const Vec3& at) {
      pattern::Panel panel = polygon_panel(name, outline);
      panel.rotation.col(0) = Vec3(std::cos(turn), 0, -std::sin(turn));
      panel.rotation.col(1) = Vec3(std::sin(turn), 0, std::cos(turn));
      panel.rotation.col(2) = -Vec3::UnitY();
      if (back) panel.rotation.col(0) *= -1, panel.rotation.col(2) *= -1;
      panel.translation = at + shift;
      p.panels.push_back(panel);
    };
    const Vec3 root(tip + 0.02, 0, length - 0.06), other(-root.x(), 0, root.z());
    const Vec3 front = -0.22 * Vec3::UnitY(), behind = 0.22 * Vec3::UnitY();
    add("front", trunk, 0, false, front);
    add("back", trunk, 0, true, behind);
    add("left_sleeve_front", left, arm_angle, false, root + 0.6 * front);
    add("left_sleeve_back", right, arm_angle, true, root + 0.6 * behind);
    add("right_sleeve_front", right, -arm_angle, false, other + 0.6 * front);
    add("right_sleeve_back", left, -arm_angle, true, other + 0.6 * behind);
    // Edges of the trunk: 0 hem, 1 side at +x, 2 armhole, 3 shoulder, 4 and 5 neck, 6 shoulder,
    // 7 armhole, 8 side. Of a left outline: 0 cap, 1 under the arm, 2 cuff, 3 top; of a right one
    // 3, 2, 1, 0.
    p.stitches = {stitch(0, 1, 1, 8), stitch(0, 8, 1, 1), stitch(0, 3, 1, 6), stitch(0, 6, 1, 3),
                  stitch(0, 2, 2, 0), stitch(1, 7, 3, 3), stitch(0, 7, 4, 3), stitch(1, 2, 5, 0),
                  stitch(2, 1, 3, 2), stitch(2, 3, 3, 0), stitch(4, 2, 5, 1), stitch(4, 0, 5, 3)};
    return p;
  }
};

}  // namespace loosefit::testing_support
