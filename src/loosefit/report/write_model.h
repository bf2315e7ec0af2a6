#pragma once
#include <filesystem>

#include "loosefit/report/case_forms.h"

namespace loosefit::report {

inline constexpr const char* kModelFile = "drape.glb";

/// Writes DIR/drape.glb: the studied garment in the colours of the first map that the scenario asks
/// for and that is drawn, in its fixed range, with its mannequin. Plain cloth without maps.
/// \throws IoError when it cannot be written in full.
void write_model(const std::filesystem::path& folder, const pipeline::CaseResult& result,
                 const CaseForms& forms);

}  // namespace loosefit::report
