#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// The same garment on nested meshes, coarse to fine. Each finer level splits every triangle of the
/// coarser one into four at its edge midpoints, so prolongation is exact: the coarse surface is
/// representable on the fine mesh and a drape free of intersections stays so when it is carried
/// over.
struct GarmentHierarchy {
  std::vector<Garment> levels;  ///< at least one; back() is the wanted resolution
  /// For level l and each of its vertices: the two coarse vertices of level l−1 whose midpoint
  /// it is; equal indices for a vertex kept from the coarser level.
  std::vector<std::vector<std::array<int, 2>>> parents;
  pattern::Pattern pattern;

  const Garment& finest() const { return levels.back(); }
};

/// Meshes the pattern irregularly at edge_length · 2^k, k such that this lies in [18, 36) mm (k = 0
/// for longer edges), then splits k times. Vertices keep their numbers from level to level; new
/// points on outlines lie on the true curves of the pattern. parents[0] is the identity.
/// \throws InvalidInput, GeometryError as `assemble` does.
/// \param finer wanted edge of each panel over edge_length, in (0, 1]; empty: 1 for all
GarmentHierarchy build_hierarchy(const pattern::Pattern& pattern, double edge_length,
                                 const fabric::Material& material,
                                 const std::vector<Attachment>& attachments = {},
                                 const std::vector<double>& finer = {});
/// Only the coarsest level of build_hierarchy, for a quick first drape. \throws as build_hierarchy.
GarmentHierarchy build_coarsest_level(const pattern::Pattern& pattern, double edge_length,
                                      const fabric::Material& material,
                                      const std::vector<Attachment>& attachments = {},
                                      const std::vector<double>& finer = {});
/// The k above.
int hierarchy_refinements(double edge_length);

}  // namespace loosefit::garment
