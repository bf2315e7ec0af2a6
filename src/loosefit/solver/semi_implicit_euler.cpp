#include "loosefit/solver/semi_implicit_euler.h"

#include <cmath>

#include "loosefit/particles/vector_sums.h"

namespace loosefit::solver {

void semi_implicit_euler_step(const ParticleSystem& system, particles::VectorField& x,
                              particles::VectorField& v, double dt) {
  // Strain rates and friction are measured over the step that led here: start at x − v dt.
  particles::VectorField before(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) before[i] = x[i] - dt * v[i];
  system.begin_step(before, dt);
  const particles::VectorField g = system.gradient(x);
  particles::VectorField dx(x.size(), Vec3::Zero());
  const std::vector<double> mass = system.carried_mass();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (system.is_held(static_cast<int>(i)))
      v[i].setZero();
    else
      v[i] -= dt / mass[i] * g[i];
  }
  system.move_followers(v);
  for (std::size_t i = 0; i < x.size(); ++i) dx[i] = dt * v[i];
  // Collisions limit the step; the velocity that it cuts off is lost, a perfectly inelastic impact.
  const double share = system.max_step(x, dx);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * dx[i];
  if (share < 1)
    for (Vec3& velocity : v) velocity *= share;
}

namespace {

/// Largest eigenvalue of M⁻¹H by power iteration [1/s²].
double largest_frequency2(const ParticleSystem& system, const particles::VectorField& x,
                          int iterations) {
  particles::BlockPattern pattern(system.particles());
  for (const particles::Energy* e : system.energies) e->add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  for (const particles::Energy* e : system.energies)
    e->add_hessian(x, h, particles::HessianKind::projected);
  // Any start that is not orthogonal to the mode of the largest eigenvalue will do.
  particles::VectorField u(system.particles()), hu;
  for (int i = 0; i < system.particles(); ++i)
    for (int c = 0; c < 3; ++c) u[i][c] = std::sin(1.0 + 7.3 * (3 * i + c));
  double value = std::sqrt(particles::dot(u, u));
  for (int k = 0; k < iterations; ++k) {
    for (Vec3& v : u) v /= value;
    hu.assign(u.size(), Vec3::Zero());
    h.add_product(u, hu);
    for (int i = 0; i < system.particles(); ++i)
      hu[i] = system.is_held(i) ? Vec3::Zero() : Vec3(hu[i] / system.mass[i]);
    value = std::sqrt(particles::dot(hu, hu));
    if (!(value > 0)) break;
    u.swap(hu);
  }
  return value;
}

class SemiImplicitEuler : public Integrator {
 public:
  SemiImplicitEuler(const ParticleSystem& system, const SemiImplicitTuning& tuning)
      : system_(system), tuning_(tuning) {}

  SettleOutcome settle(particles::VectorField& x, const SettleOptions& options) override {
    SettleOutcome outcome;
    system_.flatten_plates(x);
    particles::VectorField v(x.size(), Vec3::Zero());
    double dt = 0, kinetic_before = 0;
    for (int step = 0;; ++step) {
      if (step % tuning_.refresh_interval == 0) {
        outcome.work.iterations = step;
        if (check_convergence_at(system_, x, options.goal(), outcome)) return outcome;
        if (step >= options.max_iterations) {
          outcome.reason = SettleOutcome::Reason::iteration_limit;
          return outcome;
        }
        const double omega2 = largest_frequency2(system_, x, tuning_.power_iterations);
        // Without any stiffness (free fall) the caller's step is as good as any.
        dt = omega2 > 0 ? tuning_.stability_share * 2 / std::sqrt(omega2) : options.first_dt;
      }
      if (options.watch && step % tuning_.watch_interval == 0 &&
          options.watch(step, outcome.residual)) {
        outcome.reason = SettleOutcome::Reason::stopped;
        return outcome;
      }
      semi_implicit_euler_step(system_, x, v, dt);
      // Kinetic damping: past a peak of the kinetic energy start again from rest.
      double kinetic = 0;
      for (std::size_t i = 0; i < v.size(); ++i)
        kinetic += 0.5 * system_.mass[i] * v[i].squaredNorm();
      if (kinetic < kinetic_before) {
        for (Vec3& velocity : v) velocity.setZero();
        kinetic = 0;
      }
      kinetic_before = kinetic;
    }
  }

 private:
  const ParticleSystem& system_;
  SemiImplicitTuning tuning_;
};

}  // namespace

std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleSystem& system,
                                                     const SolverTuning& tuning) {
  tuning.validate();
  return std::make_unique<SemiImplicitEuler>(system, tuning.semi_implicit);
}

}  // namespace loosefit::solver
