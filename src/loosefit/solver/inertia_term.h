#pragma once
#include "loosefit/solver/particle_system.h"

namespace loosefit::solver {

/// What an implicit time step adds to the potential: Σ m_i/(2 dt²) |x_i − x̂_i|² [J] over free
/// particles, x̂ where they would fly without forces. Nothing where dt = ∞.
class InertiaTerm {
 public:
  /// dt [s]. Keeps references to both.
  InertiaTerm(const ParticleSystem& system, const particles::VectorField& target, double dt);

  /// 1/dt² [1/s²].
  double per_dt2() const { return per_dt2_; }
  double energy(const particles::VectorField& x) const;
  /// g += its gradient [N], that of followers at their leaders.
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const;
  /// Its gradient at one particle by itself [N].
  Vec3 gradient(int i, const particles::VectorField& x) const {
    if (per_dt2_ == 0 || system_.is_held(i)) return Vec3::Zero();
    return system_.mass[i] * per_dt2_ * (x[i] - target_[i]);
  }

 private:
  const ParticleSystem& system_;
  const particles::VectorField& target_;
  double per_dt2_;
};

}  // namespace loosefit::solver
