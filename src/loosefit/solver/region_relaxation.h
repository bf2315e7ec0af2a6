#pragma once
#include <optional>

#include "loosefit/solver/backoff.h"
#include "loosefit/solver/inertia_term.h"
#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/residual_region.h"
#include "loosefit/solver/tangent_matrix.h"

namespace loosefit {

/// Nonlinear elimination (Lanzkron, Rose and Wilkes 1996; Cai and Li 2011): after a Newton step on
/// a drape nearly all of the unbalanced force sits on a few vertices, the tips of folds, which the
/// step would move along by one triangle at a time. They are moved on by Newton steps of their own,
/// with all others held where they are, until most of their force is gone. Each lowers the energy
/// as any Newton step does, so that the equilibria are the same. Which kinds of matrix are definite
/// on one region is taken as a hint for the next.
class RegionRelaxation {
 public:
  explicit RegionRelaxation(const ParticleSystem& system) : system_(system) {}

  /// Moves the region of `force`, the gradient of potential and inertia at x. `tangent` lends its
  /// pattern and room, and is left with a matrix of no use; `order`: elimination order of all
  /// particles. max_move: of a particle in a step [m]. Returns the number of steps; nothing if the
  /// force is not on a few particles: then the energies have not been asked.
  std::optional<int> relax(VectorField& x, const VectorField& force, const InertiaTerm& inertia,
                           double max_move, const std::vector<int>& order, TangentMatrix& tangent);

 private:
  struct Step {
    VectorField dx;    ///< of all particles, zero outside
    double slope = 0;  ///< of the energy along it [J]
    double whole = 1;  ///< share of it that is the Newton step itself
  };
  int relax_active_set(VectorField& x, const InertiaTerm& inertia, double max_move,
                       TangentMatrix& tangent);
  void prepare(std::size_t particles, const std::vector<int>& order);
  void restrict_force(const VectorField& x, const VectorField& g, const InertiaTerm& inertia,
                      VectorField& force) const;
  bool factorise(const VectorField& x, double per_dt2, TangentMatrix& tangent);
  bool find_step(const VectorField& force, double max_move, Step& step);
  bool search(VectorField& x, const Step& step, const InertiaTerm& inertia, double& energy,
              VectorField& g) const;
  double slope_along(const Step& step, const VectorField& x, const VectorField& g,
                     const InertiaTerm& inertia) const;

  const ParticleSystem& system_;
  ResidualRegion region_;
  ActiveSet active_set_;
  RestrictedBlocks blocks_;
  BlockMatrix matrix_;  ///< of the region alone
  std::vector<double> shift_;
  std::vector<char> held_;
  NewtonSystem linear_;
  Backoff try_exact_{8}, try_halved_{8};
  bool exact_ = false;  ///< the last matrix was not projected
};

}  // namespace loosefit
