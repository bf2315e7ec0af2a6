#pragma once
#include "loosefit/body/body_model.h"
#include "loosefit/body/laid_skin.h"

namespace loosefit::body {

/// The skin of a person of the model where it stands, whole. No measure is taken, so any shape will
/// do.
LaidSkin lay(const BodyModel& model, const PosedPerson& person);

}  // namespace loosefit::body
