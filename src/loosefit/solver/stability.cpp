#include "loosefit/solver/stability.h"

#include <algorithm>
#include <cmath>

#include "loosefit/particles/vector_sums.h"
#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"
#include "loosefit/solver/tangent_matrix.h"

namespace loosefit::solver {
namespace {

/// The exact Hessian at one place, and its factor with inertia added.
class ShiftedHessian {
 public:
  ShiftedHessian(const ParticleSystem& system, const particles::VectorField& x)
      : system_(system),
        tangent_(system),
        mass_(system.carried_mass()),
        no_unknown_(system.no_unknown()) {
    system.set_tangent(particles::BendingTangent::plate);
    tangent_.assemble(x, particles::HessianKind::exact);
  }

  /// Whether H + shift M is positive definite, shift [1/s²].
  bool factorise(double shift) {
    std::vector<double> inertia(mass_);
    for (double& m : inertia) m *= shift;
    return cholesky_.factorise(tangent_.matrix(), inertia, no_unknown_);
  }
  /// (H + shift M)⁻¹ M v of the last factor. \pre factorise returned true
  particles::VectorField inverse(const particles::VectorField& v) const {
    particles::VectorField right = by_mass(v), y;
    cholesky_.solve(right, y);
    clear_held(y);
    return y;
  }
  /// v·Hv / v·Mv [1/s²].
  double curvature(const particles::VectorField& v) const {
    particles::VectorField product(v.size(), Vec3::Zero());
    tangent_.matrix().add_product(v, product);
    return particles::dot(v, product) / particles::dot(v, by_mass(v));
  }
  /// Leaves the unknowns alone.
  void clear_held(particles::VectorField& v) const {
    for (std::size_t i = 0; i < no_unknown_.size(); ++i)
      if (no_unknown_[i]) v[i].setZero();
  }

 private:
  particles::VectorField by_mass(particles::VectorField v) const {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] *= mass_[i];
    return v;
  }

  const ParticleSystem& system_;
  TangentMatrix tangent_;
  std::vector<double> mass_;
  std::vector<char> no_unknown_;
  SparseCholesky<double> cholesky_;
};

void make_largest_one(particles::VectorField& v) {
  double largest = 0;
  for (const Vec3& p : v) largest = std::max(largest, p.squaredNorm());
  if (!(largest > 0)) return;
  for (Vec3& p : v) p /= std::sqrt(largest);
}

/// A start that is orthogonal to no mode: multiples of an irrational number, wrapped.
particles::VectorField scattered(int particles) {
  constexpr double kGolden = 0.61803398874989485;
  particles::VectorField v(particles);
  double value = 0;
  for (Vec3& p : v)
    for (int k = 0; k < 3; ++k) {
      value = std::fmod(value + kGolden, 1.0);
      p[k] = value - 0.5;
    }
  return v;
}

/// Factorises with a shift that holds all unstable modes, and little more; false if none does.
bool hold_barely(ShiftedHessian& hessian, const StabilityTuning& tuning) {
  double low = tuning.neutral, high = tuning.first_hold;
  while (!hessian.factorise(high)) {
    low = high;
    high *= tuning.hold_growth;
    if (high > tuning.largest_hold) return false;
  }
  for (int k = 0; k < tuning.halvings; ++k) {
    const double middle = std::sqrt(low * high);
    (hessian.factorise(middle) ? high : low) = middle;
  }
  return hessian.factorise(high);
}

}  // namespace

bool is_stable(const ParticleSystem& system, const particles::VectorField& x,
               const StabilityTuning& tuning) {
  return ShiftedHessian(system, x).factorise(tuning.neutral);
}

std::optional<UnstableMode> lowest_unstable_mode(const ParticleSystem& system,
                                                 const particles::VectorField& x,
                                                 const StabilityTuning& tuning) {
  ShiftedHessian hessian(system, x);
  if (hessian.factorise(tuning.neutral) || !hold_barely(hessian, tuning)) return std::nullopt;
  UnstableMode mode{scattered(system.particles()), 0};
  hessian.clear_held(mode.direction);
  for (int k = 0; k < tuning.max_iterations; ++k) {
    mode.direction = hessian.inverse(mode.direction);
    make_largest_one(mode.direction);
    const double before = mode.curvature;
    mode.curvature = hessian.curvature(mode.direction);
    if (mode.curvature < 0 &&
        std::abs(mode.curvature - before) < tuning.accuracy * std::abs(mode.curvature))
      break;
  }
  if (!(mode.curvature < 0)) return std::nullopt;
  system.move_followers(mode.direction);
  return mode;
}

}  // namespace loosefit::solver
