#pragma once
#include <string>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// `lines.<name>` of summary.json (docs/outputs.md), as JSON. `mesh`: the garment that it runs on.
std::string lines_json(const CaseLine& line, const garment::Garment& mesh);

}  // namespace loosefit::pipeline
