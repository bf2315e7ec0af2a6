#pragma once
#include <string>

#include "loosefit/report/case_forms.h"
#include "loosefit/report/packed_arrays.h"

namespace loosefit::report {

/// What the interactive page draws, as a JSON object whose arrays lie in `arrays`: `garment` (the
/// studied one: mesh, flat pattern, skin partners), `maps` (how each array is drawn and what it
/// means), `states` (the drapes, the reference state first, each with its positions, the values of
/// its maps and the arrows of its slip), `bodies` (the mannequin per posture) and `colours`. The
/// keys are read by web/src/case_data.ts. A sealed drape has no maps and no partners.
std::string scene_json(const pipeline::CaseResult& result, const CaseForms& forms,
                       PackedArrays& arrays);

}  // namespace loosefit::report
