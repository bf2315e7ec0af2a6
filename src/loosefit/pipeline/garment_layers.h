#pragma once
#include <vector>

#include "loosefit/drape/cloth_layer.h"
#include "loosefit/pipeline/case_result.h"

// The garments of a case, worn over each other. Lists begin with the innermost garment.
namespace loosefit::pipeline {

/// Stage "pattern". \throws as make_pattern, naming the section of the garment.
std::vector<CasePattern> make_patterns(const scenario::Scenario& scenario, const body::Body& body,
                                       const kinds::GirthsAlong& girths = {});

/// Which levels of a mesh hierarchy to make.
enum class MeshLevels { all, coarsest };

/// Stage "garment": meshes of the patterns; `attachments` are those of the studied garment.
/// \throws as build_hierarchy, naming the section of the garment.
std::vector<CaseGarment> mesh_garments(const scenario::Scenario& scenario,
                                       const std::vector<CasePattern>& patterns,
                                       const std::vector<garment::Attachment>& attachments,
                                       MeshLevels levels = MeshLevels::all);

/// The garments for the drape stage; refers to their meshes. friction_share: of every coefficient.
std::vector<drape::ClothLayer> cloth_layers(const scenario::Scenario& scenario,
                                            const std::vector<CaseGarment>& garments,
                                            double friction_share = 1);

/// A drape of cloth_layers as one per garment: positions and forces are those of the garment, the
/// certificate is that of all. The last one says what to try when it is not settled.
std::vector<drape::Drape> split_drape(const drape::Drape& all, const scenario::Scenario& scenario,
                                      const std::vector<CaseGarment>& garments);

/// All garments under the studied one as one surface; `state` nullptr: in the reference state.
geometry::TriangleMesh surface_under_studied(const CaseResult& result,
                                             const CaseState* state = nullptr);

}  // namespace loosefit::pipeline
