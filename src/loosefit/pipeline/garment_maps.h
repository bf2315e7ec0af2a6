#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// A garment as somebody wears it; only referred to.
struct DressedGarment {
  const garment::Garment& mesh;
  const drape::Drape& drape;
  const fabric::Material& material;
  const body::PosedBody& body;
};

/// Stage "maps" of one garment: the maps that the scenario asks for, pressure, wrinkles and girth.
/// \throws Error if the drape is not settled and worn, unless `allow_unsettled`.
CaseMaps make_maps(const DressedGarment& dressed, const scenario::Scenario& scenario,
                   bool allow_unsettled);

/// The same of the studied garment of a case in its reference state.
CaseMaps make_studied_maps(const CaseResult& draped, bool allow_unsettled);

/// One map with its statistics.
CaseMap with_statistics(maps::PerformanceMap map, const maps::WornGarment& worn);

/// The maps alone.
std::vector<maps::PerformanceMap> plain_maps(const std::vector<CaseMap>& maps);

}  // namespace loosefit::pipeline
