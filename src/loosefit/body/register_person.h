#pragma once
#include "loosefit/body/body_model.h"
#include "loosefit/body/registered_person.h"

namespace loosefit::body {

/// Registration of the parametric body to a scan: shape and pose together by Gauss-Newton on
/// point-to-plane distances of closest points both ways (Chen and Medioni 1992) with weights that
/// forget outliers (Geman and McClure 1987), from the best of several poses of the arms; then the
/// skin by a smooth field of shifts (Allen et al. 2003), which is carried back into the rest
/// posture. The scan is closed, z up, facing -y, trunk over the origin, floor at z = 0. It may lack
/// what it likes, as long as most of it is the skin of one standing person.
RegisteredPerson register_person(const BodyModel& model, const geometry::TriangleMesh& scan);

}  // namespace loosefit::body
