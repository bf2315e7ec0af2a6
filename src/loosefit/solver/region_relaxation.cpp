#include "loosefit/solver/region_relaxation.h"

#include <cmath>

#include "loosefit/particles/vector_sums.h"

namespace loosefit {
namespace {

/// Steps on one region, and the share of its force at which it is good enough: the border that is
/// held makes more of it pointless.
constexpr int kMostSteps = 5;
constexpr double kRelaxed = 0.1;
constexpr int kMostBacktracks = 8;
/// How far to look along a step whose matrix was projected, and thus too stiff.
constexpr double kStretch = 2;

}  // namespace

std::optional<int> RegionRelaxation::relax(VectorField& x, const VectorField& force,
                                           const InertiaTerm& inertia, double max_move,
                                           const std::vector<int>& order, TangentMatrix& tangent) {
  region_ = residual_region(tangent.matrix(), force, ResidualRegion::Bounds{});
  if (region_.empty()) return std::nullopt;
  prepare(x.size(), order);
  int steps = 0;
  try {
    system_.set_active_set(&active_set_);
    steps = relax_active_set(x, inertia, max_move, tangent);
  } catch (...) {
    system_.set_active_set(nullptr);
    throw;
  }
  system_.set_active_set(nullptr);
  return steps;
}

int RegionRelaxation::relax_active_set(VectorField& x, const InertiaTerm& inertia, double max_move,
                                       TangentMatrix& tangent) {
  VectorField g, on_region;
  double energy = system_.potential_and_gradient(x, g), enough = 0;
  Step step{VectorField(x.size(), Vec3::Zero())};
  for (int steps = 0;; ++steps) {
    restrict_force(x, g, inertia, on_region);
    const double norm = std::sqrt(dot(on_region, on_region));
    if (steps == 0) enough = kRelaxed * norm;
    if (steps == kMostSteps || !(norm > enough) || !factorise(x, inertia.per_dt2(), tangent) ||
        !find_step(on_region, max_move, step) || !search(x, step, inertia, energy, g))
      return steps;
  }
}

/// Everything that depends on the region alone.
void RegionRelaxation::prepare(std::size_t particles, const std::vector<int>& order) {
  active_set_.particles = region_.particles;
  active_set_.inside.assign(particles, 0);
  for (int i : region_.particles) active_set_.inside[i] = 1;
  held_.clear();
  if (!system_.held.empty())
    for (int i : region_.particles) held_.push_back(system_.held[i]);
  blocks_.of_pattern = 0;
  // An order that leaves little fill for all particles does so for some of them.
  std::vector<int> part;
  for (int i : order)
    if (region_.place[i] >= 0) part.push_back(region_.place[i]);
  linear_.set_order(part);
}

void RegionRelaxation::restrict_force(const VectorField& x, const VectorField& g,
                                      const InertiaTerm& inertia, VectorField& force) const {
  force.clear();
  for (int i : region_.particles) force.push_back(g[i] + inertia.gradient(i, x));
}

bool RegionRelaxation::factorise(const VectorField& x, double per_dt2, TangentMatrix& tangent) {
  shift_.clear();
  for (int i : region_.particles) shift_.push_back(per_dt2 * system_.mass[i]);
  const auto attempt = [&](HessianKind kind) {
    tangent.assemble(x, kind, active_set_);
    restrict_to(region_, tangent.matrix(), matrix_, blocks_);
    return linear_.factorise(matrix_, shift_, held_);
  };
  exact_ = false;
  if (try_exact_.ready()) {
    exact_ = attempt(HessianKind::exact);
    exact_ ? try_exact_.succeeded() : try_exact_.failed();
    if (exact_) return true;
  }
  if (try_halved_.ready()) {
    const bool definite = attempt(HessianKind::half_compression);
    definite ? try_halved_.succeeded() : try_halved_.failed();
    if (definite) return true;
  }
  return attempt(HessianKind::projected);
}

bool RegionRelaxation::find_step(const VectorField& force, double max_move, Step& step) {
  VectorField dx;
  linear_.solve(force, dx);
  double largest = 0;
  for (const Vec3& d : dx) largest = std::max(largest, d.norm());
  const double stretch = std::min(exact_ ? 1.0 : kStretch, max_move / largest);
  for (std::size_t k = 0; k < dx.size(); ++k) step.dx[region_.particles[k]] = stretch * dx[k];
  step.slope = stretch * dot(force, dx);
  step.whole = std::min(1.0, 1 / stretch);
  return step.slope < 0;
}

bool RegionRelaxation::search(VectorField& x, const Step& step, const InertiaTerm& inertia,
                              double& energy, VectorField& g) const {
  const double before = energy + inertia.energy(x);
  const double limit = std::min(1.0, system_.max_step(x, step.dx));
  if (!(limit > 0)) return false;
  VectorField trial = x, g_trial;
  double e_trial = 0;
  const auto at = [&](double t) {
    for (int i : region_.particles) trial[i] = x[i] + t * step.dx[i];
    e_trial = system_.potential_and_gradient(trial, g_trial);
    return e_trial + inertia.energy(trial);
  };
  double t = std::min(limit, step.whole);
  for (int k = 0; k < kMostBacktracks; ++k, t *= 0.5) {
    const double after = at(t);
    if (!(after <= before + 1e-4 * t * step.slope)) continue;
    VectorField best = trial, g_best = g_trial;
    double e_best = e_trial;
    // A parabola through both slopes tells whether twice as far lies lower: asked where it does.
    if (k == 0 && 2 * t <= limit && slope_along(step, trial, g_trial, inertia) <= step.slope / 3 &&
        at(2 * t) < after) {
      best.swap(trial);
      g_best.swap(g_trial);
      e_best = e_trial;
    }
    x.swap(best);
    g.swap(g_best);
    energy = e_best;
    return true;
  }
  return false;
}

/// Of the energy at x [J].
double RegionRelaxation::slope_along(const Step& step, const VectorField& x, const VectorField& g,
                                     const InertiaTerm& inertia) const {
  double slope = 0;
  for (int i : region_.particles) slope += step.dx[i].dot(g[i] + inertia.gradient(i, x));
  return slope;
}

}  // namespace loosefit
