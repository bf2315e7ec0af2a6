#include "loosefit/placement/address_landmarks.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "loosefit/body/stumps.h"
#include "loosefit/placement/ray.h"

namespace loosefit::placement {
namespace {

constexpr double kXiphoid = 0.30;  // breast level → navel; women .28, men .34, children .31
// The hip joint lies 14 % of the distance between the ASIS medial of and 30 % below it.
constexpr double kMedial = 0.14, kDistal = 0.30;
constexpr double kInside = 0.75;  // of the trunk's half width there: the model's hips are wide
constexpr double kStraight = 0.1736481776669303;  // sin 10°

std::optional<Vec3> place(const std::map<std::string, Vec3>& of, const std::string& name) {
  const auto found = of.find(name);
  return found == of.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

std::string sided(const std::string& name, int side) { return name + (side > 0 ? "_L" : "_R"); }

std::optional<Vec3> joint(const body::Body& body, const std::string& name, int side) {
  return place(body.joints, sided(name, side));
}

/// v without its part along the unit vector n, unit; zero where nothing is left.
Vec3 square_to(const Vec3& n, const Vec3& v) {
  const Vec3 rest = v - v.dot(n) * n;
  return rest.norm() > 1e-9 ? rest.normalized() : Vec3(Vec3::Zero());
}

Vec3 right_of(const body::Body& body) {
  for (const auto* names : {&body.landmarks, &body.joints})
    for (const char* name : {"acromion", "shoulder"}) {
      const auto l = place(*names, sided(name, 1)), r = place(*names, sided(name, -1));
      if (l && r && (*r - *l).norm() > 1e-3) return (*r - *l).normalized();
    }
  return -Vec3::UnitX();
}

/// Puts skin points into the list, by rays.
struct SkinRays {
  const body::Body& body;
  std::map<std::string, Vec3>& points;
  void add(const std::string& name, const Vec3& from, const Vec3& direction) {
    if (const auto hit = ray_exit(body.surface, from, direction)) points[name] = *hit;
  }
  /// Where the trunk's own skin is left first: not the thighs of a sitting wearer.
  std::optional<Vec3> trunk_exit(const Vec3& from, const Vec3& direction) const {
    std::optional<RayCrossing> first;
    for (const RayCrossing& hit : ray_crossings(body.surface, from, direction, [this](int t) {
           return body.segment[body.surface.triangles[t][0]] == body::Segment::torso;
         }))
      if (hit.leaving && (!first || hit.distance < first->distance)) first = hit;
    return first ? std::optional<Vec3>(first->point) : std::nullopt;
  }
};

void add_pelvis(const body::Body& body, SkinRays& rays) {
  const auto l = joint(body, "hip", 1), r = joint(body, "hip", -1);
  if (!l || !r || (*r - *l).norm() < 1e-3) return;
  // In every posture of the model the pelvis stays upright.
  const Vec3 right = (*r - *l).normalized(), up = square_to(right, Vec3::UnitZ());
  const Vec3 front = right.cross(-up);
  const double between = (*r - *l).norm() / (1 - 2 * kMedial);
  const Vec3 middle = (*l + *r) / 2 + between * kDistal * up;
  for (const int side : {1, -1}) {
    const auto flank = rays.trunk_exit(middle, -side * right);
    if (!flank) continue;
    const double aside = std::min(between / 2, kInside * (*flank - middle).norm());
    if (const auto skin = rays.trunk_exit(middle - side * aside * right, front))
      rays.points[sided("asis", side)] = *skin;
  }
  if (const auto skin = rays.trunk_exit(middle, -front)) rays.points["psis"] = *skin;
}

void add_arm(const body::Body& body, int side, SkinRays& rays) {
  const auto arm = arm_of(body, side);
  if (!arm) return;
  const Vec3 lateral = -side * arm->across;
  if (body::is_beyond_end(body.joints, sided("elbow", side))) return;
  rays.add(sided("epicondyle_lateral", side), arm->joint, lateral);
  rays.add(sided("epicondyle_medial", side), arm->joint, -lateral);
  rays.add(sided("olecranon", side), arm->joint, -arm->front);
  rays.add(sided("cubital_fossa", side), arm->joint, arm->front);
  if (body::is_beyond_end(body.joints, sided("wrist", side))) return;
  const Vec3 wrist = *joint(body, "wrist", side), out = square_to(arm->lower, lateral);
  rays.add(sided("wrist_lateral", side), wrist, out);
  rays.add(sided("wrist_medial", side), wrist, -out);
}

void add_leg(const body::Body& body, int side, SkinRays& rays) {
  const auto leg = leg_of(body, side);
  if (!leg) return;
  const Vec3 lateral = -side * leg->across;
  rays.add(sided("trochanter", side), *joint(body, "hip", side), lateral);
  if (body::is_beyond_end(body.joints, sided("knee", side))) return;
  rays.add(sided("knee_lateral", side), leg->joint, lateral);
  rays.add(sided("knee_medial", side), leg->joint, -lateral);
  rays.add(sided("patella", side), leg->joint, leg->front);
  rays.add(sided("popliteal", side), leg->joint, -leg->front);
  if (body::is_beyond_end(body.joints, sided("ankle", side))) return;
  const Vec3 ankle = *joint(body, "ankle", side), out = square_to(leg->lower, lateral);
  rays.add(sided("malleolus_lateral", side), ankle, out);
  rays.add(sided("malleolus_medial", side), ankle, -out);
}

}  // namespace

std::optional<TrunkAxes> trunk_axes(const body::Body& body) {
  const auto breast = place(body.landmarks, "sternum"), back = place(body.landmarks, "back_waist");
  if (!breast || !back) return std::nullopt;
  TrunkAxes axes;
  axes.right = right_of(body);
  const auto c7 = place(body.landmarks, "c7");
  axes.down = square_to(axes.right, c7 ? Vec3(*back - *c7) : Vec3(-Vec3::UnitZ()));
  if (axes.down.isZero()) axes.down = -Vec3::UnitZ();
  axes.front = axes.right.cross(axes.down);
  axes.middle = (*breast + *back) / 2;
  return axes;
}

std::optional<BentLimb> arm_of(const body::Body& body, int side) {
  const auto s = joint(body, "shoulder", side), e = joint(body, "elbow", side),
             w = joint(body, "wrist", side);
  if (!s || !e || !w || (*e - *s).norm() < 1e-3 || (*w - *e).norm() < 1e-3) return std::nullopt;
  BentLimb arm;
  arm.joint = *e;
  arm.upper = (*e - *s).normalized();
  arm.lower = (*w - *e).normalized();
  const Vec3 hinge = arm.upper.cross(arm.lower);
  const Vec3 middle = (arm.upper + arm.lower).normalized();
  if (hinge.norm() > kStraight) {
    arm.across = hinge.normalized();
  } else {
    // The hinge of a straight arm: the trunk's right, of an arm held out to the side its down.
    const auto trunk = trunk_axes(body);
    const Vec3 right = trunk ? trunk->right : right_of(body);
    const Vec3 down = trunk ? trunk->down : Vec3(-Vec3::UnitZ());
    const bool aside = std::abs(right.dot(middle)) > 0.9;
    arm.across = square_to(middle, aside ? Vec3(side * down) : right);
  }
  arm.front = arm.across.cross(middle);
  return arm;
}

std::optional<BentLimb> leg_of(const body::Body& body, int side) {
  const auto l = joint(body, "hip", 1), r = joint(body, "hip", -1), h = joint(body, "hip", side),
             k = joint(body, "knee", side), a = joint(body, "ankle", side);
  if (!l || !r || !k || !a || (*k - *h).norm() < 1e-3 || (*a - *k).norm() < 1e-3)
    return std::nullopt;
  BentLimb leg;
  leg.joint = *k;
  leg.upper = (*k - *h).normalized();
  leg.lower = (*a - *k).normalized();
  leg.across = square_to(leg.upper, *r - *l);
  if (leg.across.isZero()) return std::nullopt;
  leg.front = leg.across.cross(square_to(leg.across, leg.upper + leg.lower));
  return leg;
}

std::map<std::string, Vec3> address_landmarks(const body::Body& body) {
  std::map<std::string, Vec3> points;
  SkinRays rays{body, points};
  if (const auto trunk = trunk_axes(body)) {
    const Vec3 breast = body.landmarks.at("sternum");
    const auto navel = place(body.landmarks, "front_waist");
    const Vec3 low = navel ? *navel : body.landmarks.at("back_waist");
    rays.add("xiphoid", trunk->middle_at(breast + kXiphoid * (low - breast)), trunk->front);
  }
  add_pelvis(body, rays);
  for (const int side : {1, -1}) {
    add_arm(body, side, rays);
    add_leg(body, side, rays);
  }
  return points;
}

}  // namespace loosefit::placement
