#pragma once
#include <vector>

#include "loosefit/fabric/curvature_patch.h"
#include "loosefit/particles/block_gather.h"

namespace loosefit::fabric {

/// Second derivative of Σ ½ κᵀ K κ at fixed ∇θ: Σ Bᵀ K B, B = ∂κ/∂x = S ∇θ of a patch with up to
/// twelve particles. With K = L Lᵀ the block of two particles is the product of their columns of
/// Lᵀ B: only these are kept, and each place of the matrix sums its own products.
class PatchTangent {
 public:
  explicit PatchTangent(const std::vector<CurvaturePatch>& patches);
  void add_pattern(particles::BlockPattern& pattern) const { products_.add_pattern(pattern); }

  /// Sets Lᵀ B of patch t for K ⪰ 0; gradient[4 hinge + point] = ∇θ.
  void set(std::size_t t, const CurvaturePatch& patch, const Mat3& k,
           const std::vector<Vec3>& gradient);
  void add(particles::BlockMatrix& h) const { products_.add(factor_, h); }

 private:
  static constexpr int kMost = 12;                        ///< particles of a patch
  static constexpr int kPairs = kMost * (kMost + 1) / 2;  ///< of these, a ≥ b
  /// Lᵀ B of one particle: entry 4 r + c, row r, coordinate c; the fourth stays 0.
  using Factor = std::array<double, 12>;

  class Products : public particles::BlockGather {
   public:
    explicit Products(const std::vector<CurvaturePatch>& patches);
    void add(const std::vector<Factor>& factor, particles::BlockMatrix& h) const;

   private:
    std::vector<std::array<int, 2>> factors_;  ///< of each contribution: of the row, of the column
  };

  Products products_;
  std::vector<Factor> factor_;
};

}  // namespace loosefit::fabric
