#include "loosefit/solver/newton.h"

#include <cmath>

#include "loosefit/solver/stopwatch.h"

namespace loosefit {
namespace {

constexpr double kStretch = 8;  ///< longest extension of a projected Newton step

double dot(const VectorField& a, const VectorField& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

Newton::Newton(const ParticleSystem& system, const Options& options)
    : system_(system), options_(options) {}

VectorField Newton::gradient(const VectorField& x, const VectorField& target,
                             double per_dt2) {
  const Stopwatch watch(counters_.evaluate);
  VectorField g = system_.gradient(x);
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!system_.is_held(static_cast<int>(i)))
        g[i] += system_.mass[i] * per_dt2 * (x[i] - target[i]);
  return g;
}

double Newton::objective(const VectorField& x, const VectorField& target, double per_dt2) {
  const Stopwatch watch(counters_.evaluate);
  double sum = system_.potential(x);
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += 0.5 * system_.mass[i] * per_dt2 * (x[i] - target[i]).squaredNorm();
  return sum;
}

bool Newton::solve(const VectorField& x, const VectorField& g, double per_dt2, VectorField& dx) {
  {
    const Stopwatch watch(counters_.assemble);
    BlockPattern pattern(system_.particles());
    for (const Energy* e : system_.energies) e->add_pattern(x, pattern);
    pattern.compress();
    if (!matrix_.same_pattern(pattern)) matrix_ = BlockMatrix(pattern);
  }

  VectorField rhs(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) rhs[i] = -g[i];
  std::vector<double> shift(system_.particles());
  const auto assemble = [&](HessianKind kind) {
    const Stopwatch watch(counters_.assemble);
    matrix_.set_zero();
    for (const Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
  };
  const auto attempt = [&](double regularisation) {
    for (int i = 0; i < system_.particles(); ++i)
      shift[i] = (per_dt2 + regularisation) * system_.mass[i];
    ++counters_.factorisations;
    {
      const Stopwatch watch(counters_.factorise);
      if (!cholesky_.factorise(matrix_, shift, system_.held)) return false;
    }
    const Stopwatch watch(counters_.solve);
    cholesky_.solve(rhs, dx);
    return true;
  };
  exact_ = wait_ == 0;
  if (exact_) {
    assemble(HessianKind::exact);
    if (attempt(0)) {
      patience_ = 1;
      return true;
    }
    exact_ = false;
    wait_ = patience_;  // each failure in a row doubles the wait before the next try
    patience_ = std::min(8, 2 * patience_);
  } else {
    --wait_;
  }
  // The projected one; it may still be singular (cloth free to slide): add what it takes.
  assemble(HessianKind::definite);
  double extra = 0;
  for (int k = 0; k < 12; ++k) {
    if (attempt(extra)) return true;
    extra = std::max(1.0, 100 * extra);
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
  // The projected Hessian is too stiff along buckling directions: look farther along its step.
  const double stretch = std::min(exact_ ? 1.0 : kStretch, options_.max_move / largest);
  for (Vec3& d : dx) d *= stretch;
  slope *= stretch;
  double limit = 1;
  {
    const Stopwatch watch(counters_.collide);
    limit = system_.begin_search(x, dx);
  }
  const double whole = std::min(1.0, 1.0 / stretch);  // the Newton step itself
  const double before = objective(x, target, per_dt2);
  VectorField trial(x.size());
  const auto at = [&](double t) {
    for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + t * dx[i];
    return objective(trial, target, per_dt2);
  };
  double t = std::min(limit, whole);
  for (int k = 0; k < options_.max_backtracks; ++k, t *= 0.5) {
    double after = at(t);
    // Near the end the decrease drowns in round-off: then a smaller gradient decides.
    const bool drowned = std::abs(slope * t) < 1e-13 * (std::abs(before) + 1e-12);
    bool accept = after <= before + 1e-4 * t * slope;
    if (!accept && drowned && std::isfinite(after)) {
      const VectorField gt = gradient(trial, target, per_dt2);
      accept = dot(gt, gt) < outcome.force * outcome.force;
    }
    if (!accept) continue;
    VectorField best = trial;
    if (k == 0 && !drowned)
      while (2 * t <= limit) {
        const double farther = at(2 * t);
        if (!(farther < after)) break;
        after = farther;
        t *= 2;
        best = trial;
      }
    x.swap(best);
    outcome.moved = true;
    outcome.share = t * stretch;
    return outcome;
  }
  return outcome;
}

}  // namespace loosefit
