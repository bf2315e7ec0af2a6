#pragma once
#include <array>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/scan_sections.h"

namespace loosefit {

/// Centre line of an arm from the estimated shoulder joint to the finger tips.
struct ArmLine {
  std::vector<Vec3> points;
  /// Point at a share of the line's length.
  Vec3 at(double share) const;
  // Upper arm : forearm : hand = 0.186 : 0.146 : 0.108 of the stature (Drillis and Contini 1966).
  Vec3 elbow() const { return at(wrist_share * 0.186 / 0.332); }
  Vec3 wrist() const { return at(wrist_share); }
  double wrist_share = 0.332 / 0.440;
};

/// \throws GeometryError when the arm's centre line is too short to be an arm.
ArmLine arm_line(const ScanSections& sections, int side);

/// Moves the wrist to the narrowest place between the middle of the forearm and the hand.
void find_wrist(const TriangleMesh& mesh, ArmLine& arm);

/// Trunk centroid at a height, interpolated (legs: the middle between them).
Vec3 centre_at(const ScanSections& sections, double z);
/// Leg centroid at a height; beside the trunk centre where the legs touch.
Vec3 leg_at(const ScanSections& sections, std::size_t side, double z);

/// Fills Body::segment and Body::side by level and by nearness to the arms' centre lines.
void label_segments(const ScanSections& sections, const std::array<ArmLine, 2>& arms, Body& body);

}  // namespace loosefit
