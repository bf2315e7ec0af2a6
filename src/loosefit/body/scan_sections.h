#pragma once
#include <array>
#include <optional>
#include <vector>

#include "loosefit/body/scan_limbs.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// What one horizontal cut of a standing body shows. Sides: index 0 left (+x), 1 right.
struct BodySlice {
  double z = 0;
  std::optional<Vec3> trunk;                  ///< centroid of the longest loop that is no limb's
  double girth = 0;                           ///< tape round the trunk loop
  std::array<double, 2> trunk_side = {0, 0};  ///< |x| reach of the trunk loop
  std::array<std::optional<Vec3>, 2> arm, leg;
  std::array<double, 2> arm_inner = {0, 0};  ///< smallest |x| of the arm loops
};

/// Levels and limb centre lines of a scan, found from `kSliceCount` horizontal cuts.
struct ScanSections {
  double height = 0;
  std::vector<BodySlice> slices;  ///< upwards
  bool legs_apart = true;
  double crotch_x = 0;                      ///< middle between the legs
  double crotch = 0, armpit = 0, neck = 0;  ///< z [m]
};

inline constexpr int kSliceCount = 300;

/// Tells the loops of a level apart by the limb that their vertices belong to.
/// \throws GeometryError when an arm was not found, clings to the trunk below the ribs or has no
/// hand, or when a leg has no foot.
ScanSections slice_scan(const geometry::TriangleMesh& mesh, const ScanLimbs& limbs);

}  // namespace loosefit::body
