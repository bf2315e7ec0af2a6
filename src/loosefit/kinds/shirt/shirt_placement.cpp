#include "loosefit/kinds/shirt/shirt_placement.h"

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {

void place_shirt(pattern::Pattern& shirt, const ShirtMeasures& m, const ShirtPlacement& placement,
                 const Vec2& shoulder_point, double cap_height) {
  const double hps = placement.hps_height > 0 ? placement.hps_height : 3.3 * m.hps_to_waist;
  const pattern::Panel& sleeve = shirt.panels[shirt.find_part("sleeve_L_front")];
  const double sleeve_length =
      pattern::EdgePath(sleeve, pattern::find_edge_part(sleeve, "top")).length();
  for (pattern::Panel& panel : shirt.panels) {
    const ShirtPart& part = *find_shirt_part(panel.part);
    const bool front = !part.back;
    // Columns: panel x, panel y and outside normal in our frame; the wearer faces -y.
    Mat3 upright;
    upright.col(0) = front ? Vec3(1, 0, 0) : Vec3(-1, 0, 0);
    upright.col(1) = Vec3(0, 0, 1);
    upright.col(2) = front ? Vec3(0, -1, 0) : Vec3(0, 1, 0);
    if (part.band && !part.sleeve) {  // before and behind the neck
      panel.rotation = upright;
      panel.translation = Vec3(0, front ? -0.25 : 0.22, hps + 0.02);
      continue;
    }
    if (!part.sleeve) {
      panel.rotation = upright;
      panel.translation = Vec3(0, front ? -0.25 : 0.22, hps);
      continue;
    }
    const double side = part.side;
    // The hanging arm swings outwards about the fore-aft axis.
    const Mat3 swing =
        Eigen::AngleAxisd(-side * placement.arm_abduction, Vec3::UnitY()).toRotationMatrix();
    panel.rotation = swing * upright;
    const Vec3 cap_top(side * (shoulder_point.x() + 0.03), front ? -0.175 : 0.125,
                       hps + shoulder_point.y());
    panel.translation = cap_top - panel.rotation * Vec3(0, cap_height, 0);
    if (part.band)  // beyond the end of the sleeve
      panel.translation -= panel.rotation * Vec3(0, sleeve_length - cap_height + 0.01, 0);
  }
}

}  // namespace loosefit::kinds
