#pragma once
#include <cstdint>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/particles/block_matrix.h"

namespace loosefit::particles {

/// One 3-vector per particle: positions [m], displacements [m], forces [N] or gradients [N].
using VectorField = std::vector<Vec3>;

/// Which second derivative the solver asks for (solver/matrix_choice.h decides).
enum class HessianKind {
  exact,             ///< the derivative of the gradient, possibly indefinite (see BendingTangent)
  half_compression,  ///< between the two: half of what makes element blocks indefinite is kept
  projected,         ///< positive semi-definite: every element block is ⪰ 0 (projected Newton)
};

/// A contribution to the total potential Π(x) [J] of the particles. Force = −∂Π/∂x. What an energy
/// may be besides a potential (with lagged state, with a step limit, ...) stands in
/// energy_capabilities.h; between two calls of those it is a plain smooth function of x, so a line
/// search may use it.
class Energy {
 public:
  virtual ~Energy() = default;
  /// Π [J]; +∞ where x is not admissible.
  virtual double value(const VectorField& x) const = 0;
  /// g += ∂Π/∂x [N].
  virtual void add_gradient(const VectorField& x, VectorField& g) const = 0;
  /// Both in one pass, where that is cheaper: g += ∂Π/∂x, returns Π.
  virtual double value_and_gradient(const VectorField& x, VectorField& g) const {
    const double energy = value(x);
    add_gradient(x, g);
    return energy;
  }
  /// Blocks (i, j) that add_hessian will touch at x; more are allowed.
  virtual void add_pattern(const VectorField& x, BlockPattern& pattern) const = 0;
  /// Changes when add_pattern would no longer give the same blocks as at the last call, so that a
  /// matrix and its symbolic factor can be kept until then.
  virtual std::uint64_t pattern_version(const VectorField& /*x*/) const { return 0; }
  /// H += ∂²Π/∂x² [N/m].
  virtual void add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const = 0;
};

}  // namespace loosefit::particles
