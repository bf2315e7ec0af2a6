#pragma once
#include <filesystem>

#include "loosefit/body/body.h"
#include "loosefit/body/body_fit.h"

namespace loosefit::report {

/// Adds body.obj, body.vtp and body.json to `folder`, or makes it: all of them or none. `fit` is
/// how the body came about; of a scan only its warnings.
/// \throws InvalidInput if it is the output of a run or something foreign is in the way; IoError.
void write_body(const std::filesystem::path& folder, const body::Body& body,
                const body::BodyFit& fit);

}  // namespace loosefit::report
