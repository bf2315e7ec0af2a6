#include "loosefit/body/scan_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit {
namespace {

const BodySlice& slice_near(const ScanSections& s, double z) {
  const int i = int(z / s.height * kSliceCount);
  return s.slices[std::size_t(std::clamp(i, 0, kSliceCount - 1))];
}

// The nearest slice at or below (above) this one that has what is wanted.
template <class Get>
Vec3 nearest_centre(const ScanSections& s, double z, Get get) {
  const int start = std::clamp(int(z / s.height * kSliceCount), 0, kSliceCount - 1);
  for (int off = 0; off < kSliceCount; ++off) {
    for (const int i : {start - off, start + off}) {
      if (i < 0 || i >= kSliceCount) continue;
      const std::optional<Vec3> found = get(s.slices[std::size_t(i)]);
      if (found) return Vec3(found->x(), found->y(), z);
    }
  }
  return Vec3(0, 0, z);
}

// Arm or not: below the armpit by the gap beside the trunk or leg, above it by the slanted plane
// from armpit to acromion.
bool belongs_to_arm(const ScanSections& s, const ArmLine& arm, std::size_t side, const Vec3& p) {
  const double x = side == 0 ? p.x() : -p.x();
  if (x <= 0) return false;
  const Vec3 shoulder = arm.points.front();
  if (p.z() > s.armpit) {
    const BodySlice& below = slice_near(s, s.armpit);
    const double from = 0.5 * (below.trunk_side[side] + below.arm_inner[side]);
    const double to = std::abs(shoulder.x()) + 0.002 * s.height;
    const double top = shoulder.z() + 0.022 * s.height;
    const double share = std::clamp((p.z() - s.armpit) / (top - s.armpit), 0., 1.);
    return p.z() < top + 0.03 * s.height && x > from + share * (to - from);
  }
  const BodySlice& slice = slice_near(s, p.z());
  if (!slice.arm[side]) return false;
  return x > slice.arm_inner[side] - 0.25 * 0.02;
}

/// Per vertex +1 for the left arm, −1 for the right one, 0 for the rest of the body.
std::vector<int> arm_sides(const ScanSections& s, const std::array<ArmLine, 2>& arms,
                           const TriangleMesh& mesh) {
  std::vector<int> sides(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < sides.size(); ++v)
    for (const std::size_t which : {std::size_t(0), std::size_t(1)})
      if (belongs_to_arm(s, arms[which], which, mesh.vertices[v])) sides[v] = which == 0 ? 1 : -1;
  // Tips of thumbs and fingers lie between slices: the rest of the body is one piece, and what is
  // cut off from it by an arm belongs to that arm.
  TriangleMesh rest = mesh;
  std::erase_if(rest.triangles, [&](const Triangle& t) {
    return sides[t[0]] != 0 || sides[t[1]] != 0 || sides[t[2]] != 0;
  });
  const std::vector<Piece> pieces = connected_pieces(rest);
  if (pieces.empty()) return sides;
  std::vector<char> in_trunk(sides.size(), 0);
  for (const int t : pieces.front().triangles)
    for (const int v : rest.triangles[t]) in_trunk[v] = 1;
  for (std::size_t v = 0; v < sides.size(); ++v)
    if (sides[v] == 0 && !in_trunk[v]) sides[v] = mesh.vertices[v].x() > 0 ? 1 : -1;
  return sides;
}

Segment arm_segment(const ArmLine& arm, const Vec3& p) {
  const Vec3 elbow = arm.elbow(), wrist = arm.wrist(), tip = arm.points.back();
  const Vec3 forearm = (wrist - elbow).normalized();
  // At the elbow the plane halves the angle between upper arm and forearm.
  const Vec3 bend = ((elbow - arm.points.front()).normalized() + forearm).normalized();
  const Vec3 turn = (forearm + (tip - wrist).normalized()).normalized();
  if (bend.dot(p - elbow) < 0) return Segment::upper_arm;
  return turn.dot(p - wrist) < 0 ? Segment::forearm : Segment::hand;
}

}  // namespace

Vec3 ArmLine::at(double share) const {
  double total = 0;
  for (std::size_t i = 1; i < points.size(); ++i) total += (points[i] - points[i - 1]).norm();
  double left = share * total;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    if (left <= length && length > 0)
      return points[i - 1] + left / length * (points[i] - points[i - 1]);
    left -= length;
  }
  return points.back();
}

ArmLine arm_line(const ScanSections& s, int side) {
  std::vector<Vec3> centres;  // downwards
  int missing = 0;
  for (int i = kSliceCount - 1; i >= 0 && missing < 3; --i) {
    const BodySlice& slice = s.slices[std::size_t(i)];
    if (slice.z > s.armpit) continue;
    if (slice.arm[std::size_t(side)]) {
      centres.push_back(*slice.arm[std::size_t(side)]);
      missing = 0;
    } else {
      ++missing;
    }
  }
  // The axis of the upper arm, from below the armpit's fold; the joint lies on it above the armpit.
  const auto near = std::size_t(0.015 * kSliceCount), far = std::size_t(0.08 * kSliceCount);
  if (centres.size() < 2 * far) {
    throw GeometryError("found an arm of " + std::to_string(centres.size()) +
                            " slices below the armpit, expected arms hanging beside the trunk",
                        "scan in an A-pose, or make a body from measures instead");
  }
  Vec3 slope = (centres[near] - centres[far]) / (centres[near].z() - centres[far].z());
  slope.y() = 0;  // the bend of the elbow would tip the axis backwards
  const double joint_height = s.armpit + 0.033 * s.height;
  ArmLine arm;
  arm.points.push_back(centres[near] + slope * (joint_height - centres[near].z()));
  for (std::size_t i = near; i < centres.size(); i += 2) arm.points.push_back(centres[i]);
  arm.points.push_back(centres.back());
  return arm;
}

void find_wrist(const TriangleMesh& mesh, ArmLine& arm) {
  double narrowest = std::numeric_limits<double>::infinity();
  double best = arm.wrist_share;
  for (double share = 0.62; share < 0.80; share += 0.01) {
    const Vec3 here = arm.at(share);
    const Vec3 along = arm.at(share + 0.02) - arm.at(share - 0.04);
    double girth = 0;
    try {
      girth = girth_round(mesh, here, along);
    } catch (const GeometryError&) {
      continue;  // between the fingers the line may leave the body
    }
    if (girth < narrowest) narrowest = girth, best = share;
  }
  arm.wrist_share = best;
}

Vec3 centre_at(const ScanSections& s, double z) {
  return nearest_centre(s, z, [](const BodySlice& slice) -> std::optional<Vec3> {
    if (slice.trunk) return slice.trunk;
    if (slice.leg[0] && slice.leg[1]) return Vec3(0.5 * (*slice.leg[0] + *slice.leg[1]));
    return std::nullopt;
  });
}

Vec3 leg_at(const ScanSections& s, std::size_t side, double z) {
  if (!s.legs_apart) return centre_at(s, z) + Vec3((side == 0 ? 1 : -1) * 0.05 * s.height, 0, 0);
  return nearest_centre(s, z, [&](const BodySlice& slice) { return slice.leg[side]; });
}

void label_segments(const ScanSections& s, const std::array<ArmLine, 2>& arms, Body& body) {
  const double neck_base = s.armpit + 0.5 * (s.neck - s.armpit) + 0.02 * s.height;
  body.side = arm_sides(s, arms, body.surface);
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    Segment segment = Segment::torso;
    if (body.side[v] != 0) {
      segment = arm_segment(arms[body.side[v] > 0 ? 0 : 1], p);
    } else if (p.z() < s.crotch) {
      segment = p.z() > 0.285 * s.height   ? Segment::thigh
                : p.z() > 0.039 * s.height ? Segment::shank
                                           : Segment::foot;
      body.side[v] = p.x() > 0 ? 1 : -1;
    } else if (p.z() > s.neck + 0.02 * s.height) {
      segment = Segment::head;
    } else if (p.z() > neck_base && std::abs(p.x()) < 0.045 * s.height) {
      segment = Segment::neck;
    }
    body.segment.push_back(segment);
  }
}

}  // namespace loosefit
