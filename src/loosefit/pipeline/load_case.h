#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// An earlier output taken up again: body, pattern and garment are made anew from its scenario.toml
/// (the same bits), positions and certificate come from its drape.vtp, those of other postures and
/// donnings from the files of write_case_files, seconds of draping and the spread over repeats from
/// its summary.json. Whether it is worn is asked anew. What a killed process left half replaced is
/// repaired first. Maps and sites are empty. \throws IoError, InvalidInput when a file is missing,
/// damaged, or does not belong to the scenario: another mesh, or skin more than 10 µm from the
/// body.vtp of the run.
CaseResult load_case(const std::filesystem::path& folder, Progress& progress);

/// A loaded case with stages "maps" and "placement" made again, by the maps of its scenario, and
/// the spreads and warnings that go with them. \throws Error for a drape that is not settled and
/// worn, unless `allow_unsettled`.
CaseResult remap_case(CaseResult loaded, bool allow_unsettled, Progress& progress);

}  // namespace loosefit::pipeline
