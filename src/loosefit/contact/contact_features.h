#pragma once
#include <cstdint>
#include <vector>

#include "loosefit/contact/pair_distance.h"

namespace loosefit::contact {

/// Two features that share no vertex.
struct FeaturePair {
  PairKind kind = PairKind::point_triangle;
  int first = 0, second = 0;  ///< vertex and triangle, or two edges with first < second
  std::array<int, 4> particle{};
  double reach = 0;  ///< distance at which they begin to repel, ContactFeatures::reach [m]

  std::uint64_t key() const {
    const std::uint64_t edges = kind == PairKind::edge_edge ? 1 : 0;
    return (edges << 62) | (static_cast<std::uint64_t>(first) << 31) |
           static_cast<std::uint64_t>(second);
  }
  PairPoints points(const std::vector<Vec3>& x) const {
    return {x[particle[0]], x[particle[1]], x[particle[2]], x[particle[3]]};
  }
};

/// Vertices, edges and triangles of a cloth mesh as partners of contact. Vertices and edges carry a
/// third of the flat area of every triangle at them [m²], the mean thickness of these triangles
/// weighted by area [m], and the layer of the first of them.
struct ContactFeatures {
  /// triangle_area: flat [m²]. triangle_thickness [m] and triangle_layer (0, 1, …) may be empty:
  /// then every triangle has `thickness` and layer 0.
  /// rest: places of the particles in the surface's own shape [m], or none; with them, neighbours
  /// do not repel each other in a mesh that is finer than the surface is thick, such as skin.
  /// Throws InvalidInput when a list has another length than `triangles`, or `rest` than particles,
  /// when a thickness is not positive or a layer is negative.
  ContactFeatures(const std::vector<Triangle>& triangles, const std::vector<double>& triangle_area,
                  int particles, double thickness, const std::vector<double>& triangle_thickness,
                  const std::vector<int>& triangle_layer, std::vector<Vec3> rest = {});

  /// Distance at which two features begin to repel [m]: their mean thickness, but no more than half
  /// of their distance at rest where that is known, or 0.1 mm.
  double reach(const FeaturePair& pair) const;

  struct Properties {
    double area = 0;
    double thickness = 0;
    int layer = 0;
  };
  std::vector<Triangle> triangles;
  std::vector<std::array<int, 2>> edges;  ///< lower particle first, sorted
  std::vector<Properties> of_triangle, of_edge, of_vertex;
  double max_thickness = 0;
  std::vector<Vec3> rest_positions;  ///< [m]; empty: not known

  /// Every edge, and every vertex that bears area, belongs to just one triangle, so that going
  /// through pairs of triangles meets every pair of features once (Curtis, Tamstorf and Manocha
  /// 2008). −1: none.
  std::vector<std::array<int, 3>> owned_vertices, owned_edges;
};

}  // namespace loosefit::contact
