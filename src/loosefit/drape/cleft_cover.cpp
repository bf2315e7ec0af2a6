#include "loosefit/drape/cleft_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "loosefit/geometry/convex_hull.h"

namespace loosefit::drape {
namespace {

/// Width of a cleft [m]. Folds that flesh has opened (body::kSkinGap) are wider: cloth has room
/// there, and filling would hold it.
constexpr double kNarrow = 0.006;
constexpr double kBelow = 0.15, kAbove = 0.05;  ///< of the crotch, where it is looked for [m]
constexpr double kAside = 0.06, kBeforeBehind = 0.15;
/// It reaches into the flesh [m], so that nothing between its surface and the skin counts as free.
constexpr double kInside = 0.02;
constexpr int kFew = 16;  ///< points that make no cleft yet

constexpr double kArmpit = 0.09;  ///< from its front end, where folds are looked for [m]
constexpr double kAlong = 0.025;  ///< of a fold, that one hull fills [m]
constexpr double kOverlap = 0.006;
constexpr double kRaised = radians(45), kOnTheWayUp = radians(33);

constexpr double kBehindEar = 0.015;  ///< width of the furrow there, and of hollows in an ear [m]
constexpr double kBesideFace = 0.6;   ///< of half of the head's width: eyes and mouth are no ears
constexpr double kUnderEar = 0.01;    ///< that the hull reaches into the head [m]

/// By more than that from hanging down along the trunk; `side`: "L" or "R". Not raised where joints
/// are not known.
bool arm_is_raised(const body::Body& body, const std::string& side, double by) {
  const auto& joints = body.joints;
  const std::string shoulder = "shoulder_" + side, elbow = "elbow_" + side;
  for (const std::string& name : {shoulder, elbow, std::string("neck"), std::string("pelvis")})
    if (!joints.contains(name)) return false;
  const Vec3 arm = joints.at(elbow) - joints.at(shoulder);
  const Vec3 trunk = joints.at("pelvis") - joints.at("neck");
  return arm.normalized().dot(trunk.normalized()) < std::cos(by);
}

/// A box of kAlong round a part of a fold.
using Place = std::array<int, 3>;

/// All that a point `off` the armpit's front end lies in: they overlap, so that hulls leave no gap.
std::set<Place> places_along_fold(const Vec3& off) {
  std::set<Place> places;
  for (int corner = 0; corner < 8; ++corner) {
    Place place;
    for (int k = 0; k < 3; ++k)
      place[k] = static_cast<int>(
          std::floor((off[k] + (corner >> k & 1 ? kOverlap : -kOverlap)) / kAlong));
    places.insert(place);
  }
  return places;
}

/// Whether other skin is nearer than a cleft is wide, looking along the normal: two thirds of the
/// width away from the skin, nothing else is nearer to a place than that third which is left.
bool faces_other_skin(const body::PosedBody& body, std::size_t vertex, double width = kNarrow) {
  const Vec3 within = body->surface.vertices[vertex] + 2 * width / 3 * body->normals[vertex];
  return body.tree().signed_distance(within) < width / 3;
}

}  // namespace

geometry::TriangleMesh cleft_cover(const body::PosedBody& body) {
  const auto crotch = body->landmarks.find("crotch");
  if (crotch == body->landmarks.end()) return {};
  const auto& skin = body->surface.vertices;
  if (body->normals.size() != skin.size()) return {};
  std::vector<Vec3> sides;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Vec3 off = skin[i] - crotch->second;
    if (std::abs(off.x()) > kAside || std::abs(off.y()) > kBeforeBehind || off.z() > kAbove ||
        off.z() < -kBelow)
      continue;
    if (faces_other_skin(body, i))
      for (const double depth : {0.0, kInside})
        sides.emplace_back(skin[i] - depth * body->normals[i]);
  }
  if (static_cast<int>(sides.size()) < kFew) return {};
  return geometry::convex_hull(sides);
}

bool raises_an_arm(const body::Body& body) {
  return arm_is_raised(body, "L", kRaised) || arm_is_raised(body, "R", kRaised);
}

std::vector<geometry::TriangleMesh> armpit_covers(const body::PosedBody& body, bool on_the_way_up) {
  const double from = on_the_way_up ? kOnTheWayUp : kRaised;
  std::vector<geometry::TriangleMesh> covers;
  const auto& skin = body->surface.vertices;
  if (body->normals.size() != skin.size()) return covers;
  for (const std::string side : {"L", "R"}) {
    const auto armpit = body->landmarks.find("armpit_front_" + side);
    if (armpit == body->landmarks.end() || !arm_is_raised(body.body(), side, from)) continue;
    std::map<Place, std::vector<Vec3>> parts;
    for (std::size_t i = 0; i < skin.size(); ++i) {
      const Vec3 off = skin[i] - armpit->second;
      if (off.norm() > kArmpit || !faces_other_skin(body, i)) continue;
      for (const Place& place : places_along_fold(off))
        for (const double depth : {-kNarrow, 0.0, kInside})
          parts[place].emplace_back(skin[i] - depth * body->normals[i]);
    }
    for (const auto& [place, sides] : parts)
      if (static_cast<int>(sides.size()) >= kFew) covers.push_back(geometry::convex_hull(sides));
  }
  return covers;
}

std::vector<geometry::TriangleMesh> ear_covers(const body::PosedBody& body) {
  const auto &skin = body->surface.vertices, &normals = body->normals;
  const auto left = body->joints.find("shoulder_L"), right = body->joints.find("shoulder_R");
  std::vector<geometry::TriangleMesh> covers;
  if (normals.size() != skin.size() || body->segment.size() != skin.size() ||
      left == body->joints.end() || right == body->joints.end())
    return covers;
  const Vec3 aside = (left->second - right->second).normalized();
  std::vector<double> across;  // of the head
  for (std::size_t i = 0; i < skin.size(); ++i)
    if (body->segment[i] == body::Segment::head) across.push_back(aside.dot(skin[i]));
  if (across.empty()) return covers;
  const auto [least, most] = std::minmax_element(across.begin(), across.end());
  const double middle = (*least + *most) / 2, half = (*most - *least) / 2;
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec3> ear;
    for (std::size_t i = 0; i < skin.size(); ++i) {
      if (body->segment[i] != body::Segment::head) continue;
      const double out = side * (aside.dot(skin[i]) - middle);
      if (out < kBesideFace * half || !faces_other_skin(body, i, kBehindEar)) continue;
      for (const double under : {0.0, kUnderEar}) ear.emplace_back(skin[i] - side * under * aside);
    }
    if (static_cast<int>(ear.size()) >= kFew) covers.push_back(geometry::convex_hull(ear));
  }
  return covers;
}

}  // namespace loosefit::drape
