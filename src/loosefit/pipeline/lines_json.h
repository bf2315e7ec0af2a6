#pragma once
#include <nlohmann/json_fwd.hpp>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// `lines.<name>` of summary.json (docs/outputs.md). `mesh`: the garment that it runs on.
nlohmann::ordered_json lines_json(const CaseLine& line, const garment::Garment& mesh);

}  // namespace loosefit::pipeline
