#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_check.h"

namespace loosefit::body {

/// A body made from a scanned or foreign surface on which the model does not lie (scan_person.h),
/// and what had to be assumed.
struct ScanBody {
  Body body;
  std::vector<std::string> warnings;
};

/// Checks a surface and finds limbs, levels, segments, joints, landmarks and measures on it: limbs
/// by topology (scan_limbs.h), the rest by horizontal sections. Needs a standing person whose arms
/// are free of the trunk from the armpit on, hanging, aside or horizontal; hands may touch the
/// thighs. Joints come from folds, rings and body proportions (Drillis and Contini 1966): good to a
/// few centimetres, enough to draft and dress a shirt. A scan keeps its posture (pose_from_rest
/// stays empty) and has no nipple or scapula landmarks better than that.
/// \throws what check_surface throws; GeometryError when an arm is not free of the trunk.
ScanBody body_from_scan(geometry::TriangleMesh mesh, const ScanOptions& options);

}  // namespace loosefit::body
