#include "loosefit/body/scan_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit::body {
namespace {

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

constexpr double kArmLength = 0.440;     // shoulder to finger tips, share of the stature
constexpr double kLargestCutOff = 0.03;  // share of the area of what an arm can cut off

double distance_to(const std::vector<Vec3>& line, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 along = line[i] - line[i - 1];
    const double share =
        std::clamp(along.dot(p - line[i - 1]) / std::max(along.squaredNorm(), 1e-18), 0., 1.);
    nearest = std::min(nearest, (line[i - 1] + share * along - p).norm());
  }
  return nearest;
}

// The shoulder is arm outside of the slanted plane from the armpit to the acromion.
bool on_shoulder(const ScanSections& s, const LimbChain& chain, const ArmLine& arm, double sign,
                 const Vec3& p) {
  const double x = sign * p.x(), fold_x = sign * chain.fold.x();
  const Vec3& shoulder = arm.points.front();
  const double to = sign * shoulder.x() - 0.034 * s.height;
  const double top = shoulder.z() + 0.022 * s.height, low = chain.fold.z();
  if (p.z() < low && p.z() > chain.parted.z()) {  // grown together with the trunk
    const double share = (p.z() - chain.parted.z()) / (low - chain.parted.z());
    return x > sign * chain.parted.x() + share * (fold_x - sign * chain.parted.x());
  }
  if (p.z() < low || p.z() > top + 0.03 * s.height || !(top > low)) return false;
  return x > fold_x + std::min(1., (p.z() - low) / (top - low)) * (to - fold_x);
}

// A hand that has grown together with a thigh: nearer to the arm's line than to the leg's, each by
// its usual thickness.
bool on_grown_hand(const ScanSections& s, const LimbChain& chain, const ArmLine& arm,
                   std::size_t side, const Vec3& p) {
  const double from_arm = distance_to(arm.points, p);
  if (!chain.touches || from_arm > 0.05 * s.height) return false;
  const Vec3 leg = p.z() < s.crotch ? leg_at(s, side, p.z()) : centre_at(s, p.z());
  return from_arm / 0.022 < (p - leg).norm() / 0.055;
}

/// Per vertex +1 for the left arm, −1 for the right one, 0 for the rest of the body.
std::vector<int> arm_sides(const ScanSections& s, const ScanLimbs& limbs,
                           const std::array<ArmLine, 2>& arms, const geometry::TriangleMesh& mesh) {
  std::vector<int> sides(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < sides.size(); ++v) {
    const ScanLimb limb = limbs.limb[v];
    const Vec3& p = mesh.vertices[v];
    if (limb == ScanLimb::left_arm || limb == ScanLimb::right_arm) {
      sides[v] = limb == ScanLimb::left_arm ? 1 : -1;
      continue;
    }
    for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
      const int sign = side == 0 ? 1 : -1;
      if ((limb == ScanLimb::core && on_shoulder(s, limbs.arm[side], arms[side], sign, p)) ||
          on_grown_hand(s, limbs.arm[side], arms[side], side, p))
        sides[v] = sign;
    }
  }
  // What an arm cuts off from head and trunk belongs to it: the outside of the upper arm.
  geometry::TriangleMesh rest = mesh;
  std::erase_if(rest.triangles, [&](const Triangle& t) {
    return sides[t[0]] != 0 || sides[t[1]] != 0 || sides[t[2]] != 0;
  });
  const std::vector<Piece> pieces = connected_pieces(rest);
  double area = 0;
  for (const Piece& piece : pieces) area += piece.area;
  std::vector<char> in_trunk(sides.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0 && pieces[i].area < kLargestCutOff * area) continue;
    for (const int t : pieces[i].triangles)
      for (const int v : rest.triangles[t]) in_trunk[v] = 1;
  }
  for (std::size_t v = 0; v < sides.size(); ++v)
    if (sides[v] == 0 && !in_trunk[v] && limbs.limb[v] == ScanLimb::core)
      sides[v] = mesh.vertices[v].x() > 0 ? 1 : -1;
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

ArmLine arm_line(const ScanSections& s, const LimbChain& chain, int side) {
  const double h = s.height, sign = side == 0 ? 1 : -1;
  const double start = chain.rings.front().reach;
  const auto ring_at = [&](double share) -> const LimbChain::Ring& {
    for (const auto& ring : chain.rings)
      if (ring.reach >= start + share * h) return ring;
    return chain.rings.back();
  };
  const LimbChain::Ring& upper = ring_at(0.02);
  const Vec3 axis = (ring_at(0.10).centre - upper.centre).normalized();
  const double raised = degrees(std::atan2(sign * axis.x(), -axis.z()));
  const double girth = ring_at(0.06).length;
  ArmLine arm;
  arm.points.push_back(chain.fold +
                       Vec3(sign * ((0.011 - 0.00038 * raised) * h + 0.17 * (0.17 * h - girth)),
                            -0.003 * h, (0.34 - 0.0014 * raised) * girth));
  // The last rings before a place where hand and thigh have grown together lean towards it.
  const double end = chain.rings.back().reach - (chain.touches ? 0.03 * h : 0);
  for (const auto& ring : chain.rings)
    if (ring.reach >= start + 0.015 * h && ring.reach <= end) arm.points.push_back(ring.centre);
  if (chain.touches) {
    double length = 0;
    for (std::size_t i = 1; i < arm.points.size(); ++i)
      length += (arm.points[i] - arm.points[i - 1]).norm();
    const std::size_t back = std::min<std::size_t>(arm.points.size() - 1, 12);
    const Vec3 last = arm.points.back();
    const Vec3 along = (last - arm.points[arm.points.size() - 1 - back]).normalized();
    arm.points.push_back(last + std::max(0.02 * h, kArmLength * h - length) * along);
  } else {
    arm.points.push_back(chain.tip);
  }
  return arm;
}

void find_wrist(const geometry::TriangleMesh& mesh, ArmLine& arm) {
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

void find_elbow(ArmLine& arm) {
  constexpr double kBent = 0.06;  // sagitta against the length from shoulder to wrist
  arm.elbow_share = arm.wrist_share * 0.186 / 0.332;
  const Vec3 shoulder = arm.points.front(), line = arm.wrist() - shoulder;
  const Vec3 along = line.normalized();
  double farthest = kBent * line.norm();
  for (double share = 0.42; share < 0.66; share += 0.01) {
    const Vec3 off = arm.at(share * arm.wrist_share) - shoulder;
    const double sagitta = (off - along.dot(off) * along).norm();
    if (sagitta > farthest) farthest = sagitta, arm.elbow_share = share * arm.wrist_share;
  }
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

void label_segments(const ScanSections& s, const ScanLimbs& limbs,
                    const std::array<ArmLine, 2>& arms, double c7_height, Body& body) {
  const double h = s.height;
  const Vec3 knee[2] = {leg_at(s, 0, 0.28 * h), leg_at(s, 1, 0.28 * h)};
  const Vec3 ankle[2] = {leg_at(s, 0, 0.054 * h), leg_at(s, 1, 0.054 * h)};
  body.side = arm_sides(s, limbs, arms, body.surface);
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    const ScanLimb limb = limbs.limb[v];
    Segment segment = Segment::torso;
    if (body.side[v] != 0) {
      segment = arm_segment(arms[body.side[v] > 0 ? 0 : 1], p);
    } else if (p.z() <
               s.crotch + 0.004 * h + std::min(0.085 * h, 0.85 * std::abs(p.x() - s.crotch_x))) {
      const bool left =
          limb == ScanLimb::left_leg || (limb != ScanLimb::right_leg && p.x() > s.crotch_x);
      const std::size_t side = left ? 0 : 1;
      segment = p.z() > knee[side].z() + 0.45 * (p.y() - knee[side].y())    ? Segment::thigh
                : p.z() > ankle[side].z() - 0.2 * (p.y() - ankle[side].y()) ? Segment::shank
                                                                            : Segment::foot;
      body.side[v] = left ? 1 : -1;
    } else if (p.z() > c7_height + 0.034 * h + 0.65 * p.y()) {
      segment = Segment::head;
    } else if (p.z() > c7_height + 0.007 * h + 0.35 * p.y() - 0.3 * std::abs(p.x()) &&
               std::abs(p.x()) < 0.058 * h) {
      segment = Segment::neck;
    }
    body.segment.push_back(segment);
  }
}

}  // namespace loosefit::body
