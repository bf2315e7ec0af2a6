#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/geometry/closest_point.h"

namespace loosefit::body {

/// Part of the body that maps, sites and keep-out zones are told by.
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
  hips,            ///< from hip level down to the crotch, the tops of the thighs included
  thigh_left,
  thigh_right,  ///< below the crotch, down to the knee
  shank_left,
  shank_right,
  foot_left,
  foot_right,
  upper_arm_left,
  upper_arm_right,
  forearm_left,
  forearm_right,  ///< hands included
  neck,           ///< head included
};

/// All regions in the order of the enum.
const std::vector<Region>& all_regions();
/// Name in files and on the command line: "upper_back", "scapula_L", "thigh_R", … Regions of the
/// arms are "upper_sleeve_L" and "forearm_sleeve_L" there.
std::string name(Region region);
/// The names of all_regions().
std::vector<std::string> region_names();
/// The region of that name.
std::optional<Region> find_region(const std::string& name);

/// Region of every body surface vertex, decided in the rest posture (through pose_from_rest) so
/// that a bent or sitting wearer keeps them. Uses segments, the landmarks c7, back_waist and
/// scapula_L/R, crotch and the measured levels underbust, armpit, hip; what a scanned body lacks is
/// taken from usual proportions of its height (Drillis and Contini 1966).
std::vector<Region> body_regions(const Body& body);

/// Region of a partner point: that of the nearest corner of its triangle.
Region region_of(const std::vector<Region>& body_regions, const geometry::TriangleMesh& surface,
                 const geometry::ClosestPoint& partner);

}  // namespace loosefit::body
