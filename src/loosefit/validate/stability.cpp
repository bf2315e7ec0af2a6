#include "loosefit/validate/stability.h"

#include <limits>

#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"

namespace loosefit::validate {

bool is_stable(Bench& bench) {
  const solver::ParticleSystem& system = bench.system();
  system.set_tangent(particles::BendingTangent::plate);
  particles::BlockPattern pattern(system.particles());
  for (const particles::Energy* e : system.energies) e->add_pattern(bench.x, pattern);
  pattern.compress();
  particles::BlockMatrix hessian(pattern);
  for (const particles::Energy* e : system.energies)
    e->add_hessian(bench.x, hessian, particles::HessianKind::exact);
  solver::SparseCholesky<double> cholesky;
  return cholesky.factorise(hessian, std::vector<double>(system.particles(), 0.0), system.held);
}

double critical_factor(const std::function<bool(double)>& stable, double low, double high,
                       double tolerance) {
  if (!stable(low) || stable(high)) return std::numeric_limits<double>::quiet_NaN();
  while (high - low > tolerance * low) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace loosefit::validate
