#pragma once
#include "loosefit/contact/contact_features.h"
#include "loosefit/particles/energy.h"

namespace loosefit::contact {

/// The barrier between two features, d their distance and d̂ their activation distance:
///
///   Π = e · p₀ A d̂ · b(d/d̂),   b(s) = −(s − 1)² ln s for 0 < s < 1, 0 beyond             [J]
///
/// e is 1 for point and triangle. For edges it is the mollifier r (2 − r), r = |e₁ × e₂|²/threshold
/// below 1, which lets the force die out where edges become parallel and their nearest points jump
/// (Li et al. 2020, section 4.2).
struct BarrierPair : FeaturePair {
  double scale = 0;               ///< p₀ A [N/m]
  double parallel_threshold = 0;  ///< of |e₁ × e₂|² [m⁴]; not used for point and triangle
};

/// What the barrier says at one place.
struct Barrier {
  bool active = false;  ///< nearer than the reach
  PairDistance d;
  double energy = 0;     ///< [J]; +∞ when they touch
  double slope = 0;      ///< e ∂(Π/e)/∂d ≤ 0 [N]: less the normal force
  double curvature = 0;  ///< e ∂²(Π/e)/∂d² ≥ 0 [N/m]
};
Barrier evaluate_barrier(const BarrierPair& pair, const PairPoints& x);

/// ∂Π/∂x of the four points [N]. \pre b = evaluate_barrier(pair, x), b.active
PairPoints barrier_gradient(const BarrierPair& pair, const PairPoints& x, const Barrier& b);

/// ∂²Π/∂x² [N/m]; unless exact, the part along the normal at fixed nearest points and fixed
/// mollifier or, of features pressed hard onto each other, all but its negative eigenvalues. \pre b
/// = evaluate_barrier(pair, x), b.active
PairMatrix barrier_hessian(const BarrierPair& pair, const PairPoints& x, const Barrier& b,
                           particles::HessianKind kind);

}  // namespace loosefit::contact
