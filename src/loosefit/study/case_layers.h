#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/drape/cloth_layer.h"
#include "loosefit/study/case_result.h"

// What is worn under the garment that is studied.
namespace loosefit {

/// Stage "pattern" for every [[under]] of the scenario. \throws as make_pattern, naming the
/// section.
std::vector<CaseUnder> make_under_patterns(const Scenario& scenario, const Body& body);

/// Stage "garment" for them: meshes at `edge_length` [m]. Needs scenario and their patterns.
/// \throws as build_hierarchy.
void mesh_under(CaseResult& result, double edge_length);

/// All garments for the drape stage, the studied one last. Points into `result`. friction_share: of
/// every coefficient.
std::vector<ClothLayer> cloth_layers(const CaseResult& result, double friction_share = 1);

/// Gives each garment its part of a drape of cloth_layers(result).
void take_drape(const Drape& all, CaseResult& result);
/// The same of the parts of a state.
void take_drape(const Drape& all, const CaseResult& result, CaseState& state);

/// Folder of a garment under the studied one in the folder of a run or a state: "under/1", the
/// innermost, and so on.
std::filesystem::path under_folder(int layer);

/// All garments under the studied one as one surface; `state` nullptr: in the case's own drape.
TriangleMesh under_surface(const CaseResult& result, const CaseState* state = nullptr);

}  // namespace loosefit
