#pragma once
#include <vector>

#include "loosefit/fabric/curvature_patch.h"
#include "loosefit/fabric/hinge_blocks.h"
#include "loosefit/fabric/material.h"
#include "loosefit/particles/energy.h"

namespace loosefit::bench {

/// How a trial membrane measures the strain of the cloth.
struct MembraneTrial {
  /// Chord of a triangle edge → length of the arc that the edge spans at the cloth's curvature.
  enum class Arc { none, own_angles, patch };
  Arc arc = Arc::none;
  /// Share of the energy that stays on single triangles; the rest is that of strains averaged over
  /// the triangles round each vertex (NS-FEM), beside each edge (ES-FEM), or of pairs, each
  /// triangle in one (quadrilaterals with one point of quadrature).
  double triangle_share = 1;
  enum class Smooth { nodes, edges, pairs };
  Smooth smooth = Smooth::nodes;
  bool shear_stays = false;  ///< the shear keeps its whole energy on single triangles
};

/// St. Venant-Kirchhoff membrane with the same law as fabric::MembraneEnergy without measured
/// curves, on strains of choice:
///
///   E_T = E_CST + Q c,  c_k = (L_kᵀ κ L_k)²/24 on the edges L_k, κ = S θ     (Arc)
///   W = Σ_p A_p w(Σ_T w_pT E_T)                                              (points p)
///
/// Written for trials: dense, without tiles. One panel, or panels whose grains agree.
class TrialMembrane : public particles::Energy {
 public:
  TrialMembrane(const std::vector<Triangle>& triangles,
                const std::vector<std::array<Vec2, 3>>& triangle_uv,
                const fabric::Material& material, const MembraneTrial& trial);

  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x, particles::BlockPattern& p) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

  /// (ε_uu, ε_vv, γ) of a triangle as the trial measures it, Green [–].
  Vec3 strain(int triangle, const particles::VectorField& x) const;
  const std::vector<fabric::CurvaturePatch>& patches() const { return mesh_.patches; }

 private:
  struct Flat {
    std::array<double, 3> ru, rv;
    Mat3 chords;   ///< rows (Lu², Lv², Lu Lv) of the edges
    Mat3 inverse;  ///< Q
    double area;
  };
  struct Point {
    double area;
    std::vector<int> triangle;
    std::vector<double> weight;
    std::vector<int> particle;  ///< all that it depends on
    Mat3 law;
  };
  /// Of one triangle: strain and ∂strain/∂x of its particles.
  struct Local {
    Vec3 strain, curvature, reach;  ///< reach: L_kᵀ κ L_k
    std::vector<Mat3> rows;
  };
  void find_angles(const particles::VectorField& x) const;
  const int* particles_of(int t, int& count) const;
  Local local(int t, const particles::VectorField& x, bool with_rows) const;
  Eigen::Matrix<double, 3, 9> fit_of(int t) const;

  std::vector<Triangle> triangles_;
  std::vector<Flat> flat_;
  std::vector<Point> points_;
  fabric::CurvaturePatches mesh_;
  MembraneTrial trial_;
  mutable std::vector<double> angle_;
  mutable std::vector<std::array<Vec3, 4>> turn_;  ///< ∇θ
};

}  // namespace loosefit::bench
