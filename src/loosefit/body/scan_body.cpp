#include "loosefit/body/scan_body.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/scan_girths.h"
#include "loosefit/body/scan_segments.h"
#include "loosefit/body/section.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit::body {
namespace {

constexpr double kDensity = 985;  // kg/m³, whole body

// y of the frontmost (sign -1) or backmost (+1) trunk point in the mid-sagittal plane at height z.
Vec3 midline_point(const geometry::TriangleMesh& mesh, double z, double sign) {
  Vec3 best(0, -sign * 10, z);
  for (const auto& loop : plane_section(mesh, Vec3(0, 0, z), Vec3::UnitZ())) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec3& a = loop.points[i];
      const Vec3& b = loop.points[(i + 1) % loop.points.size()];
      if ((a.x() < 0) == (b.x() < 0)) continue;
      const Vec3 p = a + a.x() / (a.x() - b.x()) * (b - a);
      if (sign * p.y() > sign * best.y()) best = p;
    }
  }
  return best;
}

Vec3 mirrored(const Vec3& p) { return {-p.x(), p.y(), p.z()}; }

// The ridge from acromion to neck: the neck begins where it gets steeper than 45°.
Vec3 neck_shoulder_point(const geometry::TriangleMesh& mesh, const ScanSections& s, double sign,
                         double acromion_x) {
  const double step = 0.004 * s.height;
  Vec3 here = top_at(mesh, sign * acromion_x, s.neck);
  for (double x = acromion_x - step; x > 0.02 * s.height; x -= step) {
    const Vec3 next = top_at(mesh, sign * x, s.neck);
    if (next.z() - here.z() > step) break;
    here = next;
  }
  return here;
}

int nearest_vertex(const geometry::TriangleMesh& mesh, const Vec3& p) {
  int best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double d = (mesh.vertices[v] - p).squaredNorm();
    if (d < nearest) nearest = d, best = int(v);
  }
  return best;
}

/// Of an upper arm from hanging down, aside [degrees].
double abduction(const Vec3& shoulder, const Vec3& elbow) {
  const Vec3 arm = elbow - shoulder;
  return degrees(std::atan2(std::abs(arm.x()), -arm.z()));
}

// The underarm fold sinks as the arm is lowered: by 1.9 % of the stature from 41° to 25° on the
// parametric body (women, men and children: 1.5 to 2.4 %). Arms raised farther take the shoulder
// point up with them: at 90° both have risen alike. Shirts are drafted for hanging arms.
double hanging_arm_gain(const Vec3& shoulder, const Vec3& elbow, double height) {
  const double angle = abduction(shoulder, elbow);
  const double risen = angle < 41 ? (angle - 25) / 16 : std::max(0.0, (90 - angle) / (90 - 41));
  return 0.019 * height * risen;
}

// Where the arm is usually fullest or, where trunk and arm are one there, below. The rings of the
// arm go round the arm alone, if a little aslant.
double upper_arm_girth(const geometry::TriangleMesh& mesh, const Vec3& shoulder, const Vec3& elbow,
                       const LimbChain& arm, double stature) {
  constexpr double kAboveElbow = 0.8, kAslant = 1.3;
  double widest = 0;
  for (const auto& ring : arm.rings)
    if (ring.reach >= arm.rings.front().reach + 0.03 * stature)
      widest = std::max(widest, ring.length);
  for (double t = 0.3; t < kAboveElbow; t += 0.05) {
    const double girth = girth_round(mesh, shoulder + t * (elbow - shoulder), elbow - shoulder);
    if (girth < kAslant * widest) return girth;
  }
  return widest;
}

void add_joints(const ScanSections& s, const std::array<ArmLine, 2>& arms, Body& body) {
  const char* names[2] = {"_L", "_R"};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string under = names[side];
    const double sign = side == 0 ? 1 : -1;
    body.joints["shoulder" + under] = arms[side].points.front();
    body.joints["elbow" + under] = arms[side].elbow();
    body.joints["wrist" + under] = arms[side].wrist();
    body.joints["hand" + under] = arms[side].points.back();
    // As on the parametric body, where it is 0.059 to 0.064 aside and 0.048 to 0.066 up.
    const Vec3 pelvis = centre_at(s, s.crotch + 0.06 * s.height);
    body.joints["hip" + under] = Vec3(s.crotch_x + sign * 0.060 * s.height, pelvis.y(), pelvis.z());
    body.joints["knee" + under] = leg_at(s, side, 0.285 * s.height);
    body.joints["ankle" + under] = leg_at(s, side, 0.039 * s.height);
    body.joints["clavicle" + under] =
        centre_at(s, s.armpit + 0.05 * s.height) + Vec3(sign * 0.015, 0, 0);
  }
  const double low = s.crotch + 0.05 * s.height, high = s.armpit + 0.075 * s.height;
  body.joints["pelvis"] = centre_at(s, low);
  body.joints["neck"] = centre_at(s, high);
  body.joints["head"] = centre_at(s, s.neck + 0.03 * s.height);
  for (int i = 1; i <= 5; ++i) {
    body.joints["spine_" + std::to_string(i)] = centre_at(s, high + (low - high) * i / 5.0);
  }
}

/// What drafts take from others where a scan cannot tell it: shape of front, neck and elbow.
void add_draft_measures(const geometry::TriangleMesh& surface, const Vec3& hps, const Vec3& c7,
                        const Vec3& acromion, const ArmLine& arm, const TrunkTapes& tapes,
                        std::map<std::string, double>& m) {
  m["neck_depth_back"] = std::hypot(hps.y() - c7.y(), hps.z() - c7.z());
  m["elbow_length"] = (acromion - arm.elbow()).norm();
  try {
    m["elbow"] = bent_elbow_girth(surface, arm.points.front(), arm.elbow(), arm.wrist());
  } catch (const GeometryError&) {  // no closed section there
  }
  m["front_balance"] = front_tape(surface, hps, tapes.hip.level) - m.at("hps_to_hip");
  // Where the arms have grown together with the trunk, half of their section is no front.
  constexpr double kAlike = 0.01;
  if (std::abs(trunk_girth(surface, tapes.chest.level) / tapes.chest.girth - 1) < kAlike)
    m["front_fullness"] = trunk_girth_front(surface, tapes.chest.level) - tapes.chest.girth / 2;
}

void warn_of_touching_limbs(const ScanSections& s, const ScanLimbs& limbs,
                            std::vector<std::string>& warnings) {
  if (!s.legs_apart) {
    warnings.push_back(
        limbs.leg[0].found()
            ? fmt::format(
                  "the legs are one surface down to {:.2f} m above the floor: the crotch is "
                  "taken at {:.2f} m, 0.47 of the height",
                  limbs.leg[0].fold.z(), s.crotch)
            : fmt::format("the legs are one surface: the crotch is taken at {:.2f} m above the "
                          "floor, 0.47 of the height",
                          s.crotch));
  }
  for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
    const LimbChain& arm = limbs.arm[side];
    if (arm.fold.z() > arm.parted.z()) {
      warnings.push_back(fmt::format(
          "the {} arm and the trunk are one surface down to {:.2f} m above the floor: the armpit "
          "is "
          "taken at {:.2f} m, 0.745 of the height, and the chest is what lies between the arms",
          side == 0 ? "left" : "right", arm.parted.z(), arm.fold.z()));
    }
    if (!arm.touches) continue;
    warnings.push_back(fmt::format(
        "the {} hand has grown together with the body {:.2f} m above the floor: wrist and hand are "
        "placed by proportion",
        side == 0 ? "left" : "right", arm.rings.back().centre.z()));
  }
}

}  // namespace

ScanBody body_from_scan(geometry::TriangleMesh mesh, const ScanOptions& options) try {
  // A closed surface in our frame and in metres.
  CheckedSurface checked = check_surface(std::move(mesh), options);
  ScanBody made;
  made.warnings = std::move(checked.warnings);
  Body& body = made.body;
  body.surface = std::move(checked.mesh);
  body.from_world = checked.from_world;
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  // Limbs from sections in many heights, then the lines of the arms with wrist and elbow.
  const geometry::TriangleMesh& surface = body.surface;
  double height = 0;
  for (const auto& p : surface.vertices) height = std::max(height, p.z());
  const ScanLimbs limbs = find_limbs(surface, height);
  const ScanSections s = slice_scan(surface, limbs);
  warn_of_touching_limbs(s, limbs, made.warnings);
  std::array<ArmLine, 2> arms = {arm_line(s, limbs.arm[0], 0), arm_line(s, limbs.arm[1], 1)};
  for (auto& arm : arms) {
    find_wrist(surface, arm);
    find_elbow(arm);
  }
  add_joints(s, arms, body);

  // Landmarks at neck and shoulders, which everything else refers to.
  std::map<std::string, Vec3> place;
  const double acromion_x =
      0.5 * (arms[0].points.front().x() - arms[1].points.front().x()) + 0.002 * s.height;
  Vec3 hps[2], acromion[2];
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? 1 : -1;
    const std::string under = side == 0 ? "_L" : "_R";
    const ArmLine& arm = arms[std::size_t(side)];
    hps[side] = place["hps" + under] = neck_shoulder_point(surface, s, sign, acromion_x);
    acromion[side] = place["acromion" + under] = top_at(surface, sign * acromion_x, s.neck);
    place["elbow" + under] = arm.elbow();
    place["wrist" + under] = arm.wrist();
  }
  // Segments and the three girths of the trunk need the height of the neck.
  const double c7_height = 0.25 * (hps[0].z() + hps[1].z() + acromion[0].z() + acromion[1].z());
  label_segments(s, limbs, arms, c7_height, body);
  const TrunkTapes tapes = tape_trunk(s, body, made.warnings);
  const auto& [chest, waist, hip] = tapes;
  // Landmarks along the middle of the trunk.
  const Vec3 c7 = place["c7"] = midline_point(surface, c7_height, 1);
  const Vec3 pit = place["neck_pit"] = midline_point(surface, c7_height - 0.008 * s.height, -1);
  place["back_waist"] = midline_point(surface, waist.level, 1);
  place["front_waist"] = midline_point(surface, waist.level, -1);
  place["sternum"] = midline_point(surface, chest.level, -1);
  place["crotch"] = midline_point(surface, s.crotch + 0.004 * s.height, -1);
  place["crown"] = Vec3(0, c7.y(), s.height);
  // The same shares of C7 → waist as on the parametric body.
  const auto back = [&](double share, double x) {
    const Vec3 middle = midline_point(surface, c7.z() + share * (waist.level - c7.z()), 1);
    return Vec3(x, middle.y(), middle.z());
  };
  place["upper_back"] = back(0.22, 0);
  place["mid_back"] = back(0.50, 0);
  place["lower_back"] = back(0.86, 0);
  place["scapula_L"] = back(0.28, 0.52 * acromion_x);
  place["scapula_lower_L"] = back(0.41, 0.45 * acromion_x);
  for (const char* name : {"scapula", "scapula_lower"}) {
    place[std::string(name) + "_R"] = mirrored(place[std::string(name) + "_L"]);
  }
  // The front ends of the armpits.
  const double front = midline_point(surface, s.armpit, -1).y();
  place["armpit_front_L"] = Vec3(0.8 * acromion_x, 0.7 * front, s.armpit);
  place["armpit_front_R"] = mirrored(place["armpit_front_L"]);
  // Every landmark is a vertex of the surface, so that it goes along with a posture.
  for (const auto& [name, p] : place) {
    const int v = body.landmark_vertex[name] = nearest_vertex(surface, p);
    body.landmarks[name] = surface.vertices[std::size_t(v)];
  }

  // Measures by the names and rules of BodyTape, as far as a scan has them.
  auto& m = body.measured;
  const ArmLine& arm = arms[0];
  const Vec3 shoulder = arm.points.front(), elbow = arm.elbow(), wrist = arm.wrist();
  m["height"] = s.height;
  m["chest"] = chest.girth;
  m["waist"] = waist.girth;
  m["hip"] = hip.girth;
  m["mid_neck"] = trunk_girth(surface, s.neck);
  m["neck"] = neck_base_girth(hps[0], hps[1], c7, pit);
  m["upper_arm"] = upper_arm_girth(surface, shoulder, elbow, limbs.arm[0], s.height);
  m["forearm"] = girth_round(surface, elbow + 0.25 * (wrist - elbow), wrist - elbow);
  m["wrist"] =
      girth_round(surface, wrist, arm.at(arm.wrist_share + 0.02) - arm.at(arm.wrist_share - 0.04));
  m["shoulder_breadth"] = (acromion[0] - c7).norm() + (c7 - acromion[1]).norm();
  m["shoulder_slope"] = std::atan2(hps[0].z() - acromion[0].z(), acromion[0].x() - hps[0].x());
  m["shoulder_length"] = (hps[0] - acromion[0]).norm();
  m["neck_width"] = hps[0].x() - hps[1].x();
  // Under a level arm the fold is at the joint; farther out the section runs up along the arm.
  constexpr double kRaised = 60;  // degrees
  const Armscye armscye = abduction(shoulder, elbow) > kRaised ? armscye_round(surface, shoulder, 0)
                                                               : armscye_round(surface, shoulder);
  m["armscye"] = armscye.girth;
  m["scye_depth"] = acromion[0].z() - armscye.fold + hanging_arm_gain(shoulder, elbow, s.height);
  m["hps_to_waist"] = back_tape(surface, hps[0], waist.level);
  m["hps_to_hip"] = back_tape(surface, hps[0], hip.level);
  m["arm_length"] = (acromion[0] - elbow).norm() + (elbow - wrist).norm();
  add_draft_measures(surface, hps[0], c7, acromion[0], arm, tapes, m);
  m["back_length"] = back_tape(surface, c7 + Vec3(1e-6, 0, 0), waist.level);
  m["crotch_height"] = s.crotch;
  m["chest_level"] = chest.level;
  m["waist_level"] = waist.level;
  m["hip_level"] = hip.level;
  m["armpit_level"] = s.armpit;
  m["volume"] = geometry::enclosed_volume(surface);
  m["mass"] = kDensity * m["volume"];
  return made;
} catch (const GeometryError& error) {  // of a tape or section, which does not know the file
  if (!error.place().file.empty()) throw;
  if (!error.hint().empty()) throw GeometryError(error.at({options.file, 0, ""}));
  throw GeometryError({options.file, 0, ""},
                      std::string("a place where a tape does not close round the limb or trunk (") +
                          error.what() + ")",
                      "a standing person whose arms are free of the trunk",
                      "look for folds, gaps and surfaces that pass through each other at the "
                      "shoulders, or make a body from measures instead");
}

}  // namespace loosefit::body
