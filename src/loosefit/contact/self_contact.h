#pragma once
#include <vector>

#include "loosefit/contact/friction.h"
#include "loosefit/contact/pair_distance.h"

namespace loosefit {

/// Contact of the cloth with itself (and of layers with each other) by point-triangle and
/// edge-edge pairs. A barrier keeps them apart, continuous detection limits every step, so cloth
/// that starts free of intersections stays so (Li et al. 2020; Li, Kaufman and Jiang 2021).
///
///   Π = Σ e · p₀ A d̂ · b(d/d̂),   b(s) = −(s − 1)² ln s for 0 < s < 1, 0 beyond             [J]
///
/// d distance, d̂ fabric thickness [m], A tributary area [m²], p₀ pressure scale [Pa]; e is the
/// parallel-edge mollifier for edge pairs (1 for point-triangle pairs). Features that share a
/// vertex are no pairs. Friction as in
/// Friction.
class SelfContact : public Energy {
 public:
  struct Options {
    double thickness = 5e-4;    ///< d̂ [m]
    double pressure = 1000;     ///< p₀ [Pa]
    double friction = 0.4;      ///< Coulomb [–]
    double stick_reach = 1e-4;  ///< ε [m]
  };
  /// triangle_area: flat areas [m²], for the tributary areas.
  SelfContact(const std::vector<Triangle>& triangles, const std::vector<double>& triangle_area,
              int particles, const Options& options);

  void forget_anchors() { friction_.forget(); }
  void begin_step(const VectorField& x, double dt) override;
  double begin_search(const VectorField& x, const VectorField& dx) override;
  double value(const VectorField& x) const override;
  void add_gradient(const VectorField& x, VectorField& g) const override;
  void add_pattern(const VectorField& x, BlockPattern& pattern) const override;
  void add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const override;

  int active(const VectorField& x) const;
  long searches() const { return searches_; }  ///< continuous detections so far

 private:
  struct Pair {
    PairKind kind;
    int first, second;  ///< vertex + triangle, or two edges
    std::array<int, 4> particle;
    double area;
    double parallel_threshold;  ///< of |e₁ × e₂|², 0 for point-triangle
  };
  struct Term {
    PairDistance d;
    double energy = 0;     ///< [J]
    double slope = 0;      ///< dΠ/dd [N]
    double curvature = 0;  ///< d²Π/dd² [N/m]; all three without the mollifier
    bool active = false;
  };
  Term evaluate(const Pair& pair, const VectorField& x) const;
  double mollifier(const Pair& pair, const VectorField& x) const;
  void find_pairs(const VectorField& x, const VectorField* dx);

  std::vector<Triangle> triangles_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<double> vertex_area_, edge_area_;
  Options options_;
  std::vector<int> used_vertices_;
  std::vector<Pair> pairs_;
  Friction friction_;
  long searches_ = 0;
};

}  // namespace loosefit
