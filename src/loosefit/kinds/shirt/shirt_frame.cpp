#include "loosefit/kinds/shirt/shirt_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/dress/front_neckline.h"
#include "loosefit/dress/no_room.h"

namespace loosefit::kinds {
namespace {

/// The corner of a panel at the armpit is this much below 180° [rad], or half of the angle that
/// trunk and arm leave for those of both panels, down to the least.
constexpr double kArmpitCorner = 0.14, kLeastCorner = 0.01;
constexpr int kArmholePoints = 12;
constexpr double kLeastArmAngle = 0.2617993877991494;  ///< 15°: less leaves no room for the seam

Vec2 seen(const Vec3& p) { return {p[0], p[2]}; }

const Vec3& place(const std::map<std::string, Vec3>& places, const std::string& name) {
  const auto found = places.find(name);
  if (found == places.end())
    throw GeometryError("body: a shirt cannot be put on, the body has no " + name,
                        "a scanned body needs arms held away from the trunk");
  return found->second;
}

double measure(const body::Body& body, const std::string& name, double otherwise) {
  const auto found = body.measured.find(name);
  return found == body.measured.end() ? otherwise : found->second;
}

/// Height of the shirt's front from the high point shoulder to the hem [m].
double flat_height(const garment::Garment& g) {
  double lower = 1e9, upper = -1e9;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    if (g.panel_parts[g.triangle_panel[t]] == "front")
      for (const Vec2& p : g.triangle_uv[t]) {
        lower = std::min(lower, p[1]);
        upper = std::max(upper, p[1]);
      }
  return upper - lower;
}

/// Arc from the armpit to the shoulder that bends inwards just as far as the corner between side
/// and armhole needs to be convex, and not so far that the one between sleeve and armhole is not:
/// the triangle in a reflex corner would be turned over. `under`: where the sleeve's seam goes.
std::vector<Vec2> armhole_line(const Vec2& hem, const Vec2& armpit, const Vec2& under,
                               const Vec2& shoulder) {
  const Vec2 side = armpit - hem, chord = shoulder - armpit;
  const auto angle = [](const Vec2& d) { return std::atan2(d[1], d[0]); };
  const double room = std::remainder(angle(armpit - under) - angle(side), 2 * kPi);
  const double corner = std::clamp(0.5 * room, kLeastCorner, kArmpitCorner);
  const double bend = std::clamp(angle(side) + corner - angle(chord), 0.0, 1.2);
  std::vector<Vec2> line;
  const Vec2 inwards(-chord[1], chord[0]);
  for (int k = 0; k <= kArmholePoints; ++k) {
    const double s = double(k) / kArmholePoints;
    // Parabola with slope tan(bend) at both ends.
    line.push_back(armpit + s * chord + s * (1 - s) * std::tan(bend) * inwards);
  }
  return line;
}

ShirtFrame::Half half_frame(const garment::Garment& g, const body::Body& body,
                            const dress::BodyOutline& outline, double clearance, int side) {
  const std::string end = side > 0 ? "_L" : "_R";
  // Work on the wearer's left; mirror at the end.
  const auto left = [&](const Vec3& p) { return Vec3(side * p[0], p[1], p[2]); };
  const Vec3 shoulder3 = left(place(body.joints, "shoulder" + end));
  const Vec3 elbow3 = left(place(body.joints, "elbow" + end));
  const Vec3 wrist3 = left(place(body.joints, "wrist" + end));
  const Vec2 acromion = seen(left(place(body.landmarks, "acromion" + end)));
  const Vec2 hps = seen(left(place(body.landmarks, "hps" + end)));
  const Vec2 elbow = seen(elbow3), wrist = seen(wrist3);
  const Vec2 arm = (elbow - seen(shoulder3)).normalized();
  const double angle = std::atan2(arm[0], -arm[1]);
  if (angle < kLeastArmAngle)
    throw dress::NoRoom("body: found the upper arm " +
                        std::to_string(static_cast<int>(std::lround(degrees(angle)))) +
                        " degrees from the vertical, expected at least 15 to put on a shirt");

  ShirtFrame::Half half;
  half.neck = hps + Vec2(clearance, 1.2 * clearance);
  half.shoulder = acromion + clearance * Vec2(0.5, 0.87);

  const double upper_radius = measure(body, "upper_arm", 0.28) / (2 * kPi) * 1.1;
  const double elbow_radius = 0.9 * upper_radius;
  const double wrist_radius = 1.3 * measure(body, "wrist", 0.16) / (2 * kPi);

  // The armpit of the shirt sits in the wedge between trunk and arm, clear of both.
  const double level =
      std::min(acromion[1] - 0.03, measure(body, "armpit_level", acromion[1] - 0.12));
  const Vec2 armpit(outline.trunk_half_width(level - 0.01, side), level);
  const Vec2 bisector = (arm + Vec2(0, -1)).normalized();
  half.armpit = armpit + bisector * (0.6 * clearance / std::sin(angle / 2));

  // Cuff: as far along the arm as the sleeve is long, beyond the wrist if need be.
  const double length = sleeve_length(g, side);
  const double upper_arm = (elbow3 - shoulder3).norm(), forearm = (wrist3 - elbow3).norm();
  const Vec2 fore = (wrist - elbow).normalized();
  // A sleeve longer than the arm starts gathered before the hand, whose fingers it could not clear.
  const double past_elbow = std::min(0.90, (length - upper_arm) / forearm);
  const bool reaches_elbow = past_elbow > 0.05;
  const Vec2 cuff = reaches_elbow
                        ? Vec2(elbow + past_elbow * (wrist - elbow))
                        : Vec2(seen(shoulder3) + length / upper_arm * (elbow - seen(shoulder3)));
  const Vec2 out_upper(-arm[1], arm[0]), out_fore(-fore[1], fore[0]);
  const Vec2 out_elbow = (out_upper + out_fore).normalized();
  const double cuff_radius =
      reaches_elbow ? std::max(wrist_radius, elbow_radius + (wrist_radius - elbow_radius) *
                                                                std::min(1.0, past_elbow))
                    : elbow_radius;
  const Vec2 out_cuff = reaches_elbow ? out_fore : out_upper;
  half.sleeve_top = {half.shoulder};
  half.sleeve_under = {half.armpit};
  if (reaches_elbow) {
    half.sleeve_top.push_back(elbow + (elbow_radius + clearance) * out_elbow);
    half.sleeve_under.push_back(elbow - (elbow_radius + clearance) * out_elbow);
  }
  half.sleeve_top.push_back(cuff + (cuff_radius + clearance) * out_cuff);
  half.sleeve_under.push_back(cuff - (cuff_radius + clearance) * out_cuff);

  // Straight side line from armpit to hem that stays clear of the trunk.
  const double hem_z = hps[1] - flat_height(g);
  double hem_x = outline.trunk_half_width(hem_z, side) + clearance;
  const double fall = half.armpit[1] - hem_z;
  if (fall < 0.02)
    throw dress::NoRoom("the body of the shirt ends above the armpits as it has to be laid");
  for (double z = hem_z; z < half.armpit[1] - 0.1 * fall; z += 0.005) {
    const double share = (half.armpit[1] - z) / fall;  // 1 at the hem
    const double need = outline.trunk_half_width(z, side) + 0.5 * clearance;
    hem_x = std::max(hem_x, half.armpit[0] + (need - half.armpit[0]) / share);
  }
  half.hem = {hem_x, hem_z};

  half.armhole = armhole_line(half.hem, half.armpit, half.sleeve_under[1], half.shoulder);

  const auto mirror = [&](Vec2& p) { p[0] *= side; };
  mirror(half.neck);
  mirror(half.shoulder);
  mirror(half.armpit);
  mirror(half.hem);
  for (Vec2& p : half.armhole) mirror(p);
  for (Vec2& p : half.sleeve_top) mirror(p);
  for (Vec2& p : half.sleeve_under) mirror(p);
  return half;
}

}  // namespace

ShirtFrame shirt_frame(const garment::Garment& shirt, const body::Body& body,
                       const dress::BodyOutline& outline, double clearance) {
  ShirtFrame frame{half_frame(shirt, body, outline, clearance, +1),
                   half_frame(shirt, body, outline, clearance, -1),
                   {}};
  frame.front_neck =
      dress::front_neckline(front_neck_length(shirt), body, frame.left.neck, frame.right.neck);
  return frame;
}

double front_neck_length(const garment::Garment& shirt) {
  const auto* neck = shirt.find_part("neckband_front", "rim");
  if (!neck) neck = shirt.find_part("front", "neck");
  return neck ? dress::flat_length(shirt, *neck) : 0;
}

double sleeve_length(const garment::Garment& shirt, int side) {
  constexpr double kNone = 0.55;
  const auto* top = shirt.find_part(side > 0 ? "sleeve_L_front" : "sleeve_R_front", "top");
  const auto* cuff = shirt.find_part(side > 0 ? "cuff_L_front" : "cuff_R_front", "top");
  if (!top) return kNone;
  return dress::flat_length(shirt, *top) + (cuff ? dress::flat_length(shirt, *cuff) : 0);
}

}  // namespace loosefit::kinds
