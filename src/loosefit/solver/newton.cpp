#include "loosefit/solver/newton.h"

#include <cmath>

namespace loosefit {
namespace {

double dot(const VectorField& a, const VectorField& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

Newton::Newton(const ParticleSystem& system, const Options& options)
    : system_(system), options_(options) {}

VectorField Newton::gradient(const VectorField& x, const VectorField& target,
                             double per_dt2) const {
  VectorField g = system_.gradient(x);
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!system_.is_held(static_cast<int>(i)))
        g[i] += system_.mass[i] * per_dt2 * (x[i] - target[i]);
  return g;
}

double Newton::objective(const VectorField& x, const VectorField& target, double per_dt2) const {
  double sum = system_.potential(x);
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += 0.5 * system_.mass[i] * per_dt2 * (x[i] - target[i]).squaredNorm();
  return sum;
}

bool Newton::solve(const VectorField& x, const VectorField& g, double per_dt2, VectorField& dx) {
  BlockPattern pattern(system_.particles());
  for (const Energy* e : system_.energies) e->add_pattern(x, pattern);
  pattern.compress();
  if (!matrix_.same_pattern(pattern)) matrix_ = BlockMatrix(pattern);

  std::vector<double> shift(system_.particles());
  for (int i = 0; i < system_.particles(); ++i) shift[i] = per_dt2 * system_.mass[i];
  const auto attempt = [&](HessianKind kind) {
    matrix_.set_zero();
    for (const Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
    ++counters_.factorisations;
    if (!cholesky_.factorise(matrix_, shift, system_.held)) return false;
    VectorField rhs(g.size());
    for (std::size_t i = 0; i < g.size(); ++i) rhs[i] = -g[i];
    cholesky_.solve(rhs, dx);
    return true;
  };
  if (definite_for_ == 0) {
    if (attempt(HessianKind::exact)) {
      patience_ = 1;
      return true;
    }
    // Each failure in a row doubles the wait before the exact Hessian is tried again.
    definite_for_ = patience_;
    patience_ = std::min(8, 2 * patience_);
  } else {
    --definite_for_;
  }
  // The projected Hessian may be singular (a strip free to slide): add what it takes.
  double extra = 0;
  for (int k = 0; k < 12; ++k) {
    if (attempt(HessianKind::definite)) return true;
    const double previous = extra;
    extra = extra == 0 ? 1e-8 * matrix_.diagonal(0).norm() + 1e-9 : 100 * extra;
    for (double& s : shift) s += extra - previous;
  }
  return false;
}

Newton::Outcome Newton::iterate(VectorField& x, const VectorField& target, double dt) {
  const double per_dt2 = std::isfinite(dt) ? 1 / (dt * dt) : 0;
  Outcome outcome;
  const VectorField g = gradient(x, target, per_dt2);
  outcome.force = std::sqrt(dot(g, g));
  VectorField dx;
  ++counters_.iterations;
  if (!(outcome.force > 0) || !solve(x, g, per_dt2, dx)) return outcome;
  double slope = dot(g, dx);
  if (!(slope < 0)) return outcome;

  double largest = 0;
  for (const Vec3& d : dx) largest = std::max(largest, d.squaredNorm());
  largest = std::sqrt(largest);
  double cut = 1;
  if (largest > options_.max_move) {
    cut = options_.max_move / largest;
    for (Vec3& d : dx) d *= cut;
    slope *= cut;
  }
  const double limit = system_.begin_search(x, dx);
  outcome.blocked = limit < 0.1;
  const double before = objective(x, target, per_dt2);
  VectorField trial(x.size());
  double t = limit;
  for (int k = 0; k < options_.max_backtracks; ++k) {
    for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + t * dx[i];
    const double after = objective(trial, target, per_dt2);
    // Near the end the decrease drowns in round-off: then a smaller gradient decides.
    const bool drowned = std::abs(slope * t) < 1e-13 * (std::abs(before) + 1e-12);
    bool accept = after <= before + 1e-4 * t * slope;
    if (!accept && drowned && std::isfinite(after)) {
      const VectorField gt = gradient(trial, target, per_dt2);
      accept = dot(gt, gt) < outcome.force * outcome.force;
    }
    if (accept) {
      x.swap(trial);
      outcome.moved = true;
      outcome.share = t * cut;
      return outcome;
    }
    t *= 0.5;
  }
  return outcome;
}

}  // namespace loosefit
