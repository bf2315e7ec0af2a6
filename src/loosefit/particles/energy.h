#pragma once
#include <cstdint>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/particles/block_matrix.h"
#include "loosefit/particles/focus.h"

namespace loosefit {

/// One 3-vector per particle: positions [m], displacements [m], forces [N] or gradients [N].
using VectorField = std::vector<Vec3>;

/// Which second derivative the solver wants.
enum class HessianKind {
  exact,     ///< the derivative of the gradient, possibly indefinite (see TangentReach)
  halved,    ///< between the two: half of what would make element blocks indefinite is left in
  definite,  ///< a positive semi-definite approximation: every element block is ⪰ 0
};

/// How far HessianKind::exact reaches. An energy with a wide stencil may offer a cheaper matrix on
/// a narrow one that lies close enough for Newton's method to converge, if only linearly.
enum class TangentReach {
  near,  ///< the narrow stencil, where there is one
  full,  ///< the derivative of the gradient
};

/// A contribution to the total potential Π(x) [J] of the particles. Force = −∂Π/∂x.
///
/// Lagged state (contact sets, friction anchors, strains at the start of a time step) changes only
/// in `begin_step` and `begin_search`, and `set_focus` leaves parts out, so between two such calls
/// every energy is a plain smooth function of x and may be line-searched.
class Energy {
 public:
  virtual ~Energy() = default;
  /// A new time step of length dt [s] starts at x. dt = ∞: no time passes, x is the next iterate of
  /// the static balance of the step that began last.
  virtual void begin_step(const VectorField& /*x*/, double /*dt*/) {}
  /// A line search from x along dx is about to start. Returns the largest share in (0, 1] of dx
  /// that is admissible (1 = all of it).
  virtual double begin_search(const VectorField& /*x*/, const VectorField& /*dx*/) { return 1.0; }
  /// ‖forces‖ [N] by which the lagged state of the last `begin_step` departs from what its place
  /// asks for; part of the residual.
  virtual double lag() const { return 0; }
  /// Applies to add_pattern and add_hessian from now on; energies start with `full`.
  virtual void set_tangent(TangentReach /*reach*/) {}
  /// From now on only the particles of the focus differ between the places that are asked for, and
  /// those that `begin_search` is about. What touches none of them may be left out of the energy,
  /// which then is right but for a constant; forces on other particles are void, and so is the
  /// matrix but for blocks of which both particles are in the focus. No `begin_step` in between.
  /// The focus lives until it is replaced; null: everything counts again, and what the last
  /// searches found holds for all particles together.
  virtual void set_focus(const Focus* /*focus*/) {}
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

}  // namespace loosefit
