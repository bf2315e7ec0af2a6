#pragma once
#include <string>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_model.h"

namespace loosefit::io {

/// Writes measures, landmarks, joints, asked-against-measured table, warnings and the parameters of
/// the body model as JSON; lengths in metres, angles in radians. \throws IoError.
void write_body_json(const std::string& path, const body::Body& body, const body::BodyFit& fit);

}  // namespace loosefit::io
