#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_check.h"

namespace loosefit {

/// A body made from a scanned or foreign surface, and what had to be assumed.
struct ScanBody {
  Body body;
  std::vector<std::string> warnings;
};

/// Checks a surface and finds levels, segments, joints, landmarks and measures on it by horizontal
/// sections. Needs a standing person with the arms apart from the trunk and hanging at 15° … 65°
/// to the vertical. Joints come from section centroids and body proportions (Drillis and Contini
/// 1966): good to a few centimetres, enough to draft and dress a shirt. A scan keeps its posture
/// (pose_from_rest stays empty) and has no nipple or scapula landmarks better than that.
/// \throws what check_surface throws; GeometryError when the arms are not apart from the trunk.
ScanBody body_from_scan(TriangleMesh mesh, const ScanOptions& options);

}  // namespace loosefit
