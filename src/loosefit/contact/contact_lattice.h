#pragma once
#include <map>
#include <memory>
#include <vector>

#include "loosefit/contact/body_contact.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::contact {

/// Which contact points stand for a triangle mesh, and for how much of its area: vertices and edge
/// midpoints at first (contact_points), closer ones on triangles of choice. The areas add up to
/// that of the mesh at any time, so that pressures are right, and no point ever goes or changes its
/// place in the list, so that anchors of friction stay.
///
/// A refined triangle has the points of a regular lattice with the weights of the composite
/// trapezoidal rule (exact for linear pressures, error O(spacing²)). A cell of the lattice may have
/// a further point, where the cloth comes nearest to the skin: it takes three quarters of the
/// cell, as the middle of a triangle does next to its corners.
///
/// The list of points is the caller's (BodyContact::change_points), always the same one.
class ContactLattice {
 public:
  using Weights = std::array<double, 3>;  ///< of the triangle's corners, Σ = 1

  /// first_vertex: the lowest vertex of the mesh, whose point is the first of the list.
  /// intervals: of the lattice along an edge; even, at least 2. \pre indices are consecutive
  ContactLattice(std::vector<Triangle> triangles, std::vector<double> area, int first_vertex,
                 int vertices, int intervals);

  /// Vertices and edge midpoints, which is how the list begins.
  std::vector<ContactPoint> first_points(double offset) const;

  int intervals() const { return intervals_; }
  const std::vector<Triangle>& triangles() const { return mesh_->triangles; }
  bool is_refined(int triangle) const { return first_inner_[triangle] >= 0; }
  /// Gives the triangle its lattice; nothing when it has it.
  void refine(int triangle, std::vector<ContactPoint>& points);

  /// The n² cells of a refined triangle's lattice: weights of their corners.
  static std::vector<std::array<Weights, 3>> cells(int intervals);
  /// Gives the cell a further point, or moves the last one that it has; `beside`: keeps that one,
  /// which gives half its area to the new one. \pre the triangle is refined
  void add_nearest(int triangle, int cell, const Weights& at, bool beside,
                   std::vector<ContactPoint>& points);

  /// The points of a triangle, with corners, midpoints and further ones: indices of the list.
  std::vector<int> points_of(int triangle) const;

 private:
  struct Mesh {
    std::vector<Triangle> triangles;
    std::vector<double> area;
    geometry::MeshTopology topology;
    int first_vertex, vertices;
  };
  /// Index of the lattice's node with weights i/n, j/n and the rest.
  int node(int triangle, int i, int j) const;
  int midpoint(int edge) const { return mesh_->vertices + edge; }

  std::shared_ptr<const Mesh> mesh_;
  int intervals_;
  std::vector<int> first_inner_;  ///< per triangle, of the nodes off its edges; −1: not refined
  std::vector<int> first_on_;     ///< per edge, of the nodes on it but for the midpoint; −1: none
  std::map<std::pair<int, int>, std::vector<int>> nearest_;  ///< triangle and cell → points
};

}  // namespace loosefit::contact
