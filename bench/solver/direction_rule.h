#pragma once
#include <functional>
#include <memory>

#include "loosefit/particles/energy.h"

namespace loosefit::bakeoff {

/// r ↦ P⁻¹ r, the last factor's solution.
using Preconditioner =
    std::function<void(const particles::VectorField& r, particles::VectorField& z)>;
/// v ↦ H v with the present matrix.
using Product = std::function<void(const particles::VectorField& v, particles::VectorField& hv)>;
/// v ↦ (M/dt²) v, the inertia of the present pseudo-step.
using Inertia = std::function<particles::VectorField(const particles::VectorField& v)>;

/// How a search direction comes from the gradient g of the step's function, a factor, and the past.
class DirectionRule {
 public:
  virtual ~DirectionRule() = default;
  virtual particles::VectorField direction(const particles::VectorField& g,
                                           const Preconditioner& solve, const Product& multiply,
                                           const Inertia& inertia) = 0;
  /// A step s was taken; y is the change of ∂Π/∂x (without inertia).
  virtual void accepted(const particles::VectorField& /*s*/, const particles::VectorField& /*y*/) {}
  /// The past misleads: start anew.
  virtual void forget() {}
  /// Needs the present matrix at every iteration, factorised or not.
  virtual bool multiplies() const { return false; }
};

/// −P⁻¹ g.
std::unique_ptr<DirectionRule> make_plain();
/// Limited-memory BFGS with the factor as first matrix (Nocedal 1980; Liu, Bouaziz and Kavan 2017).
std::unique_ptr<DirectionRule> make_lbfgs(int memory);
/// Truncated conjugate gradients on the present matrix, preconditioned by the factor, until the
/// residual has fallen to `forcing` or the matrix curves downwards (Steihaug 1983; inexact Newton:
/// Dembo, Eisenstat and Steihaug 1982).
std::unique_ptr<DirectionRule> make_inexact(double forcing, int most_products);
/// Preconditioned nonlinear conjugate gradients, Polak and Ribière with restart at β < 0.
std::unique_ptr<DirectionRule> make_conjugate();
/// Anderson acceleration of the iteration x ← x − P⁻¹ g(x), which for a constant P is the
/// local-global alternation of projective dynamics (Anderson 1965; Peng et al. 2018).
std::unique_ptr<DirectionRule> make_anderson(int memory);

}  // namespace loosefit::bakeoff
