#pragma once
#include <array>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/scan_sections.h"

namespace loosefit::body {

/// Centre line of an arm from the estimated shoulder joint to the finger tips.
struct ArmLine {
  std::vector<Vec3> points;
  /// Point at a share of the line's length.
  Vec3 at(double share) const;
  // Upper arm : forearm : hand = 0.186 : 0.146 : 0.108 of the stature (Drillis and Contini 1966).
  Vec3 elbow() const { return at(elbow_share); }
  Vec3 wrist() const { return at(wrist_share); }
  double elbow_share = 0.186 / 0.440, wrist_share = 0.332 / 0.440;
};

/// Along the rings of the arm. The shoulder joint lies above and inside of the armpit; its place
/// against the fold, as a share of the arm's girth and by how far the arm is raised, is that of the
/// parametric body (women, men, children, slim and stout, 12° to 90°: within 30 mm). Where the hand
/// has grown together with the thigh, hand and wrist lie straight on, at the arm's usual length.
ArmLine arm_line(const ScanSections& sections, const LimbChain& arm, int side);

/// Moves the wrist to the narrowest place between the middle of the forearm and the hand.
void find_wrist(const geometry::TriangleMesh& mesh, ArmLine& arm);

/// Moves the elbow, after the wrist was found, to where a bent arm bends, or a straight one to the
/// usual share of the way to the wrist.
void find_elbow(ArmLine& arm);

/// Trunk centroid at a height, interpolated (legs: the middle between them).
Vec3 centre_at(const ScanSections& sections, double z);
/// Leg centroid at a height; beside the trunk centre where the legs touch.
Vec3 leg_at(const ScanSections& sections, std::size_t side, double z);

/// Fills Body::segment and Body::side: limbs by topology, their parts by the arms' centre lines and
/// by planes, which lie where they do on the parametric body.
void label_segments(const ScanSections& sections, const ScanLimbs& limbs,
                    const std::array<ArmLine, 2>& arms, double c7_height, Body& body);

}  // namespace loosefit::body
