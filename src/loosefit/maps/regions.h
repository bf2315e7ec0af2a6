#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/maps/body_partner.h"

namespace loosefit {

/// Region of the body under a place of the garment.
enum class Region {
  upper_back,
  mid_back,
  lower_back,  ///< thirds of C7 → waist; lower back reaches to hip level
  scapula_left,
  scapula_right,  ///< within a sixth of C7 → waist of the shoulder blade's centre
  chest,
  abdomen,  ///< front, above and below the underbust level
  side_left,
  side_right,  ///< flanks between armpit and hip level
  shoulder_left,
  shoulder_right,  ///< tops of the shoulders
  hips,            ///< below hip level, thighs included
  upper_sleeve_left,
  upper_sleeve_right,
  forearm_sleeve_left,
  forearm_sleeve_right,
  neck,
};

/// All regions in the order of the enum.
const std::vector<Region>& all_regions();
/// "upper_back", "scapula_L", "forearm_sleeve_R", …
std::string name(Region region);

/// Region of every body surface vertex, decided in the rest posture (through pose_from_rest) so
/// that a bent or sitting wearer keeps them. Uses segments, the landmarks c7, back_waist and
/// scapula_L/R and the measured levels underbust, armpit, hip; what a scanned body lacks is taken
/// from usual proportions of its height.
std::vector<Region> body_regions(const Body& body);

/// Region of a partner point: that of the nearest corner of its triangle.
Region region_of(const std::vector<Region>& body_regions, const TriangleMesh& surface,
                 const ClosestPoint& partner);

}  // namespace loosefit
