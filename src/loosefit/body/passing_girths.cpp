#include "loosefit/body/passing_girths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit::body {
namespace {

/// Where the palm lies beyond the wrist, in lengths of the forearm: from the root of the thumb,
/// where a fist is still narrow, to the knuckles (measured on the body model).
constexpr double kPalmFrom = 0.2, kPalmTo = 0.36;
constexpr int kSections = 8;  ///< of a palm or of half a head

const Vec3* joint(const Body& body, const std::string& name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? nullptr : &found->second;
}

std::optional<double> tape(const Body& body, const Vec3& origin, const Vec3& normal) {
  try {
    return girth_round(body.surface, origin, normal);
  } catch (const GeometryError&) {
    return std::nullopt;  // the limb ends before this plane
  }
}

std::optional<double> head_girth(const Body& body) {
  const Vec3* base = joint(body, "head");
  const auto found = body.landmarks.find("crown");
  if (!base || body.surface.vertices.empty()) return {};
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  const Vec3 crown = found != body.landmarks.end()
                         ? found->second
                         : *std::ranges::max_element(body.surface.vertices, lower);
  if ((crown - *base).norm() < 1e-3) return {};
  std::optional<double> widest;
  for (int k = 0; k < 2 * kSections; ++k) {
    const double share = static_cast<double>(k) / (2 * kSections);
    const auto girth = tape(body, *base + share * (crown - *base), crown - *base);
    if (girth && (!widest || *girth > *widest)) widest = girth;
  }
  return widest;
}

std::optional<double> hand_girth(const Body& body, const std::string& side) {
  const Vec3 *elbow = joint(body, "elbow" + side), *wrist = joint(body, "wrist" + side),
             *hand = joint(body, "hand" + side);
  if (!elbow || !wrist) return {};
  const Vec3 straight = *wrist - *elbow;
  const bool bends = hand && (*hand - *wrist).norm() > 1e-3;
  const Vec3 along = (bends ? Vec3(*hand - *wrist) : straight).normalized();
  std::optional<double> narrowest;
  for (int k = 0; k <= kSections; ++k) {
    const double share = kPalmFrom + (kPalmTo - kPalmFrom) * k / kSections;
    const auto girth = tape(body, *wrist + share * straight.norm() * along, along);
    if (girth && (!narrowest || *girth < *narrowest)) narrowest = girth;
  }
  return narrowest;
}

std::optional<double> foot_girth(const Body& body, const std::string& side, int sign) {
  const Vec3 *knee = joint(body, "knee" + side), *ankle = joint(body, "ankle" + side);
  if (!knee || !ankle || body.segment.size() != body.surface.vertices.size() ||
      body.side.size() != body.segment.size())
    return {};
  const Vec3 down = (*ankle - *knee).normalized();
  const Vec3 back = Vec3::UnitX().cross(down).normalized();
  const Vec3* heel = nullptr;
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    if (body.segment[v] == Segment::foot && body.side[v] == sign &&
        (!heel || (p - *heel).dot(down + back) > 0))
      heel = &p;
  }
  if (!heel) return {};
  return tape(body, *ankle, Vec3::UnitX().cross(*heel - *ankle));
}

std::optional<double> measured(const Body& body, const std::string& name) {
  const auto found = body.measured.find(name);
  return found == body.measured.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

PassingGirths passing_girths(const Body& body) {
  PassingGirths girths;
  girths.head = head_girth(body);
  girths.hand = {hand_girth(body, "_L"), hand_girth(body, "_R")};
  girths.foot = {foot_girth(body, "_L", 1), foot_girth(body, "_R", -1)};
  for (const int side : {0, 1}) {
    const std::string end = side == 0 ? "_end_L" : "_end_R";
    if (!girths.hand[side] && joint(body, "arm" + end)) girths.hand[side] = 0;
    if (!girths.foot[side] && joint(body, "leg" + end)) girths.foot[side] = 0;
  }
  girths.chest = measured(body, "chest");
  girths.hip = measured(body, "hip");
  return girths;
}

}  // namespace loosefit::body
