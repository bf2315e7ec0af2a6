#pragma once
#include <array>
#include <vector>

#include "loosefit/particles/block_gather.h"
#include "loosefit/particles/energy.h"

namespace loosefit::fabric {

/// Triangles round one vertex that lie in one piece of the flat pattern.
struct StrainPatch {
  static constexpr int kMost = 12;    ///< particles; more triangles than that meet nowhere
  int first = 0, count = 0;           ///< of its triangles, in StrainPatches::triangle
  std::array<int, kMost> particle{};  ///< corners of its triangles, rising
  int particles = 0;                  ///< of these
  double weight = 0;                  ///< a third of what its triangles weigh [m²]
};

/// All patches of a garment. A vertex on a seam has one on each side of it, because weft and warp
/// turn there; so has one where the stiffness jumps.
struct StrainPatches {
  std::vector<StrainPatch> patches;
  std::vector<int> triangle;
  std::vector<std::array<int, 3>> at_corner;  ///< patch of each corner of a triangle; −1: none
};

/// `weight`: of each triangle, flat area times stiffness factor [m²]; `factor` that factor.
StrainPatches strain_patches(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const std::vector<double>& factor, const std::vector<double>& weight);

/// Second derivative of the patch energies at fixed ∂strain/∂x: Σ Bᵀ C B of each patch, B two rows
/// (ε_uu, ε_vv). Only B and C B are kept, and each place of the matrix sums its own products.
class StrainPatchTangent {
 public:
  explicit StrainPatchTangent(const std::vector<StrainPatch>& patches);
  void add_pattern(particles::BlockPattern& pattern) const { products_.add_pattern(pattern); }

  /// B and C B of one particle: two rows of three each.
  using Factor = std::array<double, 12>;
  /// The factors of patch p, one per particle, to be set.
  Factor* factors(int p) { return factor_.data() + StrainPatch::kMost * p; }
  /// Into the columns of the active set alone; into all if that is null.
  void add(particles::BlockMatrix& h, const particles::ActiveSet* active_set) const;

 private:
  static constexpr int kPairs = StrainPatch::kMost * (StrainPatch::kMost + 1) / 2;
  class Products : public particles::BlockGather {
   public:
    explicit Products(const std::vector<StrainPatch>& patches);
    void add(const std::vector<Factor>& factor, particles::BlockMatrix& h,
             const particles::ActiveSet* active_set) const;

   private:
    void add_products(int begin, int end, const std::vector<Factor>& factor,
                      particles::BlockMatrix& h) const;
    std::vector<std::array<int, 2>> factors_;  ///< of each contribution: of the row, of the column
  };
  Products products_;
  std::vector<Factor> factor_;
};

}  // namespace loosefit::fabric
