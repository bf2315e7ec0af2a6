#pragma once
#include "loosefit/body/body_model.h"
#include "loosefit/body/registered_person.h"

namespace loosefit::body {

/// Non-rigid registration: moves the skin of a person who nearly fits a scan, the template, onto it
/// by a field of shifts that is smooth over the surface and follows the scan where a point of it
/// faces the same way nearby: elsewhere, and on hands and feet, it goes on as its neighbours do
/// (Allen et al. 2003). The shifts are turned back into the rest posture and become
/// BodyParameters::shift. Skin of `missing` limbs goes on as its neighbours do, too, and counts in
/// no distance.
RegisteredPerson lay_skin(const BodyModel& model, const geometry::TriangleMesh& scan,
                          const PosedPerson& person, std::vector<MissingLimb> missing);

}  // namespace loosefit::body
