#include "loosefit/solver/newton.h"

#include <cmath>

#include "loosefit/particles/vector_sums.h"
#include "loosefit/solver/stopwatch.h"

namespace loosefit {
namespace {

/// How far along a projected Newton step to look: at first, and at most after it paid.
constexpr double kStretch = 2, kMostStretch = 8;
/// Bounds of the shift that makes an exact Hessian definite, times mass [1/s²].
constexpr double kLeastHold = 1, kMostHold = 1e4;

}  // namespace

Newton::Newton(const ParticleSystem& system, const Options& options)
    : system_(system), options_(options), tangent_(system), region_(system), stretch_(kStretch) {}

void Newton::restart(const Options& options) {
  options_ = options;
  work_ = {};
  evaluated_ = false;
}

void Newton::evaluate(const VectorField& x, double& energy, VectorField& g) {
  const Stopwatch watch(work_.evaluate);
  energy = system_.potential_and_gradient(x, g);
}

void Newton::begin_step(const VectorField& x, double dt) {
  const Stopwatch watch(work_.refresh);
  system_.begin_step(x, dt);
  evaluated_ = false;
}

const VectorField& Newton::gradient(const VectorField& x) {
  if (!evaluated_ || x != place_) {
    evaluate(x, energy_, gradient_);
    place_ = x;
    evaluated_ = true;
  }
  return gradient_;
}

void Newton::assemble(const VectorField& x, HessianKind kind) {
  const Stopwatch watch(work_.assemble);
  tangent_.assemble(x, kind);
}

bool Newton::factorise(const VectorField& x, double per_dt2) {
  shift_.resize(system_.particles());
  const auto attempt = [&](double regularisation) {
    for (int i = 0; i < system_.particles(); ++i)
      shift_[i] = (per_dt2 + regularisation) * system_.mass[i];
    ++work_.factorisations;
    const Stopwatch watch(work_.factorise);
    return linear_.factorise(tangent_.matrix(), shift_, system_.held);
  };
  exact_ = try_exact_.ready();
  if (exact_) {
    assemble(x, HessianKind::exact);
    if (attempt(0)) {
      try_exact_.succeeded();
      return true;
    }
    exact_ = false;
    // At rest but for a few slow modes of negative curvature: a little inertia holds just them,
    // where the projected matrix would hold everything and creep.
    if (per_dt2 == 0) {
      if (attempt(hold_)) {
        hold_ = std::max(kLeastHold, hold_ / 4);
        return true;
      }
      hold_ = std::min(kMostHold, 10 * hold_);
    }
    try_exact_.failed();
  }
  // Compressed cloth is about as stiff against buckling as its compression is strong: without the
  // compression it would be far too stiff there, with half of it the matrix is mostly definite.
  if (try_halved_.ready()) {
    assemble(x, HessianKind::half_compression);
    if (attempt(0)) {
      try_halved_.succeeded();
      return true;
    }
    try_halved_.failed();
  }
  // The projected one; it may still be singular (cloth free to slide): add what it takes.
  assemble(x, HessianKind::projected);
  double extra = 0;
  for (int k = 0; k < 12; ++k) {
    if (attempt(extra)) return true;
    extra = std::max(1.0, 100 * extra);
  }
  return false;
}

void Newton::direction(const VectorField& g, VectorField& dx) {
  const Stopwatch watch(work_.solve);
  linear_.solve(g, dx);
}

void Newton::relax_region(VectorField& x, const InertiaTerm& inertia) {
  if (system_.particles() < options_.relax_from) return;
  const Stopwatch watch(work_.region);
  VectorField force = gradient_;
  inertia.add_gradient(x, force);
  const auto steps = region_.relax(x, force, inertia, options_.max_move, linear_.order(), tangent_);
  if (!steps) return;
  work_.regional += *steps;
  evaluated_ = false;  // a search also changes which pairs are in contact
}

Newton::Outcome Newton::iterate(VectorField& x, const VectorField& target, double dt) {
  const InertiaTerm inertia(system_, target, dt);
  Outcome outcome;
  VectorField g = gradient(x);
  inertia.add_gradient(x, g);
  outcome.force = std::sqrt(dot(g, g));
  ++work_.iterations;
  if (!(outcome.force > 0) || !factorise(x, inertia.per_dt2())) return outcome;
  outcome.exact = exact_;
  VectorField dx;
  direction(g, dx);
  double slope = dot(g, dx);
  if (!(slope < 0)) return outcome;

  double largest = 0;
  for (const Vec3& d : dx) largest = std::max(largest, d.squaredNorm());
  largest = std::sqrt(largest);
  // The projected Hessian is too stiff along buckling directions: look farther along its step.
  const double stretch = std::min(exact_ ? 1.0 : stretch_, options_.max_move / largest);
  for (Vec3& d : dx) d *= stretch;
  slope *= stretch;
  double limit = 1;
  {
    const Stopwatch watch(work_.collide);
    limit = system_.max_step(x, dx);
  }
  const double whole = std::min(1.0, 1.0 / stretch);  // the Newton step itself
  const double before = energy_ + inertia.energy(x);
  double e_trial = 0;
  VectorField trial(x.size()), g_trial;
  const auto at = [&](double t) {
    for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + t * dx[i];
    evaluate(trial, e_trial, g_trial);
    return e_trial + inertia.energy(trial);
  };
  double t = std::min(limit, whole);
  for (int k = 0; k < options_.max_backtracks; ++k, t *= 0.5) {
    double after = at(t);
    // Near the end the decrease drowns in round-off: then a smaller gradient decides.
    const bool drowned = std::abs(slope * t) < 1e-13 * (std::abs(before) + 1e-12);
    bool accept = after <= before + 1e-4 * t * slope;
    if (!accept && drowned && std::isfinite(after)) {
      VectorField force = g_trial;
      inertia.add_gradient(trial, force);
      accept = dot(force, force) < outcome.force * outcome.force;
    }
    if (!accept) continue;
    VectorField best = trial, g_best = g_trial;
    double e_best = e_trial;
    if (k == 0 && !drowned)
      while (2 * t <= limit) {
        // A parabola through both slopes tells whether twice as far lies lower: asked where it
        // does.
        VectorField force = g_trial;
        inertia.add_gradient(trial, force);
        if (dot(force, dx) > slope / 3) break;
        const double farther = at(2 * t);
        if (!(farther < after)) break;
        after = farther;
        t *= 2;
        best = trial;
        g_best = g_trial;
        e_best = e_trial;
      }
    x.swap(best);
    place_ = x;
    gradient_.swap(g_best);
    energy_ = e_best;
    evaluated_ = true;
    outcome.moved = true;
    outcome.share = t * stretch;
    if (!drowned) relax_region(x, inertia);
    stretch_ = outcome.share > 0.9 * stretch_ ? std::min(kMostStretch, 2 * stretch_) : kStretch;
    return outcome;
  }
  return outcome;
}

}  // namespace loosefit
