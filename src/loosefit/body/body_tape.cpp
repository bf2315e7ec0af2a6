#include "loosefit/body/body_tape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/landmarks.h"
#include "loosefit/body/rulers.h"
#include "loosefit/body/section.h"
#include "loosefit/body/tape_paths.h"
#include "loosefit/geometry/principal_axes.h"

namespace loosefit::body {
namespace {

constexpr int kC7 = 1491, kBackWaist = 4181, kCrotch = 4372;
constexpr int kHpsLeft = 7539, kHpsRight = 828, kNeckPit = 1522, kAcromionLeft = 8274,
              kAcromionRight = 1602, kNippleLeft = 8451;
constexpr int kElbowEnd = 10037, kForearmStart = 10040, kWristOuter = 10548;
constexpr double kUpperArmShare = 0.3, kForearmShare = 0.25;  // where these are usually fullest
/// Just above the elbow, and how many times as thick an upper arm is at most: a tape that reads
/// more goes round the trunk too, as it does high on the arms of stout people.
constexpr double kAboveElbow = 0.8, kMostTaper = 1.8;
constexpr double kDensity = 985;  // kg/m³, whole body

Vec3 ring_normal(const std::vector<Vec3>& vertices, const std::string& name) {
  const Vec3 centre = ruler_centre(vertices, name);
  Mat3 spread = Mat3::Zero();
  for (const int v : ruler(name)) {
    const Vec3 d = vertices[std::size_t(v)] - centre;
    spread += d * d.transpose();
  }
  return geometry::principal_axes(spread).axes.col(0);
}

}  // namespace

const std::vector<std::string>& measure_names() {
  static const std::vector<std::string> kNames = {
      "height",   "chest",     "underbust",        "waist",      "hip",         "neck",
      "mid_neck", "upper_arm", "forearm",          "wrist",      "thigh",       "knee",
      "calf",     "ankle",     "shoulder_breadth", "arm_length", "back_length", "crotch_height"};
  return kNames;
}

const Vec3& BodyTape::joint(const std::string& bone) const {
  return rest_.joints[std::size_t(data_.bones[std::size_t(data_.bone(bone))].head)];
}

double BodyTape::floor() const {
  double low = std::numeric_limits<double>::infinity();
  for (const auto& p : rest_.surface.vertices) low = std::min(low, p.z());
  return low;
}

double BodyTape::ring_girth(const std::string& ruler_name) const {
  const auto& vertices = rest_.surface.vertices;
  return girth_round(rest_.surface, ruler_centre(vertices, ruler_name),
                     ring_normal(vertices, ruler_name));
}

double BodyTape::limb_girth(const std::string& bone_a, const std::string& bone_b, double t) const {
  const Vec3 a = joint(bone_a), b = joint(bone_b);
  return girth_round(rest_.surface, a + t * (b - a), b - a);
}

double BodyTape::upper_arm_girth() const {
  const auto girth = [&](double t) { return limb_girth("upperarm01.L", "lowerarm01.L", t); };
  const double most = kMostTaper * girth(kAboveElbow);
  double t = kUpperArmShare;
  while (t < kAboveElbow && girth(t) > most) t += 0.05;
  return girth(t);
}

// The lowest height at which the arm still belongs to the trunk section, from below the shoulder.
double BodyTape::armpit_height() const {
  double apart = ruler_centre(rest_.surface.vertices, "bust_circ").z();
  double together = joint("upperarm01.L").z();
  const double shoulder_x = vertex(kAcromionLeft).x();
  const auto arm_is_apart = [&](double z) {
    const auto loops = plane_section(rest_.surface, Vec3(0, 0, z), Vec3::UnitZ());
    const SectionLoop* trunk = trunk_loop(loops);
    if (!trunk) return false;
    int beside = 0;
    for (const auto& loop : loops) {
      const bool left = std::all_of(loop.points.begin(), loop.points.end(),
                                    [&](const Vec3& p) { return p.x() > 0.3 * shoulder_x; });
      beside += left && &loop != trunk;
    }
    return beside > 0;
  };
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (apart + together);
    (arm_is_apart(middle) ? apart : together) = middle;
  }
  return apart;
}

double BodyTape::measure(const std::string& name) const {
  const auto& vertices = rest_.surface.vertices;
  const auto level = [&](const char* ring) {
    return trunk_girth(rest_.surface, ruler_centre(vertices, ring).z());
  };
  // Stature, then girths from the top downwards.
  if (name == "height") {
    const auto [low, high] =
        std::minmax_element(vertices.begin(), vertices.end(),
                            [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    return high->z() - low->z();
  }
  if (name == "chest") return level("bust_circ");
  if (name == "underbust") return level("underbust_circ");
  if (name == "waist") return level("waist_circ");
  if (name == "hip") return level("hips_circ");
  if (name == "neck") {
    return neck_base_girth(vertex(kHpsLeft), vertex(kHpsRight), vertex(kC7), vertex(kNeckPit));
  }
  if (name == "mid_neck") return ring_girth("neck_circ");
  if (name == "upper_arm") return upper_arm_girth();
  if (name == "forearm") return limb_girth("lowerarm01.L", "wrist.L", kForearmShare);
  if (name == "wrist") return ring_girth("wrist_circ");
  if (name == "thigh") return ring_girth("thigh_circ");
  if (name == "knee") return ring_girth("knee_circ");
  if (name == "calf") return ring_girth("calf_circ");
  if (name == "ankle") return ring_girth("ankle_circ");
  // Lengths along the skin or between landmarks.
  if (name == "shoulder_breadth") {
    return (vertex(kAcromionLeft) - vertex(kC7)).norm() +
           (vertex(kC7) - vertex(kAcromionRight)).norm();
  }
  if (name == "arm_length") {
    return (vertex(kAcromionLeft) - vertex(kElbowEnd)).norm() +
           (vertex(kForearmStart) - vertex(kWristOuter)).norm();
  }
  if (name == "back_length") {
    double length = 0;
    const auto& line = back_line();
    for (auto v = std::find(line.begin(), line.end(), kC7); *v != kBackWaist; ++v) {
      length += (vertex(v[1]) - vertex(v[0])).norm();
    }
    return length;
  }
  if (name == "crotch_height") return vertex(kCrotch).z() - floor();
  throw InvalidInput("the body has no measure named " + name);
}

std::map<std::string, double> BodyTape::all() const {
  std::map<std::string, double> found;
  for (const auto& name : measure_names()) found[name] = measure(name);
  const auto& vertices = rest_.surface.vertices;
  const double ground = floor(), armpit = armpit_height();
  const Vec3 hps = vertex(kHpsLeft), acromion = vertex(kAcromionLeft);
  const double waist = ruler_centre(vertices, "waist_circ").z();
  const double hip = ruler_centre(vertices, "hips_circ").z();
  found["chest_level"] = ruler_centre(vertices, "bust_circ").z() - ground;
  found["underbust_level"] = ruler_centre(vertices, "underbust_circ").z() - ground;
  found["waist_level"] = waist - ground;
  found["hip_level"] = hip - ground;
  found["armpit_level"] = armpit - ground;
  // The shoulder as cloth meets it: the top of the body above the acromion.
  const double shoulder = top_at(rest_.surface, acromion.x(), hps.z()).z();
  found["shoulder_slope"] = std::atan2(hps.z() - shoulder, acromion.x() - hps.x());
  found["shoulder_length"] = (acromion - hps).norm();
  found["neck_width"] = 2 * hps.x();
  found["hps_to_crown"] = measure("height") - (hps.z() - ground);
  found["front_fullness"] =
      trunk_girth_front(rest_.surface, found["chest_level"] + ground) - measure("chest") / 2;
  const Vec3 to_c7 = vertex(kC7) - hps;
  found["neck_depth_back"] = std::hypot(to_c7.y(), to_c7.z());
  found["armscye"] = armscye_round(rest_.surface, joint("upperarm01.L")).girth;
  found["elbow"] = bent_elbow_girth(rest_.surface, joint("upperarm01.L"), joint("lowerarm01.L"),
                                    joint("wrist.L"));
  found["elbow_length"] = (acromion - vertex(kElbowEnd)).norm();
  found["hps_to_waist"] = back_tape(rest_.surface, hps, waist);
  found["hps_to_hip"] = back_tape(rest_.surface, hps, hip);
  found["front_balance"] = front_tape(rest_.surface, hps, hip) - found["hps_to_hip"];
  // How much longer the front is, down to the bust: straight down from the shoulder seam above it.
  const Vec3 bust = vertex(kNippleLeft), above = top_at(rest_.surface, bust.x(), hps.z());
  const double to_bust = front_tape(rest_.surface, above, bust.z());
  found["bust_span"] = 2 * bust.x();
  found["hps_to_bust"] = hps.z() - above.z() + to_bust;
  found["bust_balance"] = to_bust - back_tape(rest_.surface, above, bust.z());
  found["volume"] = geometry::enclosed_volume(rest_.surface);
  found["mass"] = kDensity * found["volume"];
  return found;
}

}  // namespace loosefit::body
