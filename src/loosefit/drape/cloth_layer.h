#pragma once
#include <optional>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/fabric/material.h"
#include "loosefit/garment/hierarchy.h"

namespace loosefit::drape {

/// One garment of those that are worn over each other. Lists of layers begin with the innermost.
struct ClothLayer {
  const garment::GarmentHierarchy* garment = nullptr;
  fabric::Material material;
  /// Coulomb coefficient against every layer over it; absent: mean of their friction_self.
  std::optional<double> friction_over = {};
};

/// Several meshes as one: vertices and triangles of the innermost come first.
struct ClothMesh {
  int vertices = 0;
  std::vector<Triangle> triangles;
  std::vector<double> area;         ///< flat [m²]
  std::vector<int> triangle_layer;  ///< 0 innermost
  /// Where those of each layer begin, and one past the last.
  std::vector<int> first_vertex, first_triangle;

  int layers() const { return static_cast<int>(first_vertex.size()) - 1; }
  /// Triangles of one layer, vertices numbered as in the whole.
  std::vector<Triangle> triangles_of(int layer) const;
};
ClothMesh joined(const std::vector<const garment::Garment*>& garments);

/// What a drape of several layers says of one: positions and forces of that garment; certificate
/// and report are those of the whole. \throws Error when the drape is not of these layers.
Drape drape_of_layer(const Drape& all, const std::vector<ClothLayer>& layers, int layer);

}  // namespace loosefit::drape
