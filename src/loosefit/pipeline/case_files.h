#pragma once
#include <filesystem>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Writes drape.vtp, drape.vtp and pattern.json in under_folder for every garment under it,
/// body.vtp, pattern.json, sites.csv (when there are maps), scenario.toml, and per posture and
/// donning beyond the first drape.vtp in state_folder, body.vtp beside it where the posture is new.
/// \throws IoError.
void write_case_files(const std::filesystem::path& folder, const CaseResult& result);

/// Writes summary.json; last, so that its seconds are complete and a folder that has one is whole.
void write_summary_file(const std::filesystem::path& folder, const CaseResult& result);

}  // namespace loosefit::pipeline
