#include "loosefit/solver/newton.h"

#include <cmath>

#include "loosefit/solver/stopwatch.h"

namespace loosefit {
namespace {

constexpr double kStretch = 8;      ///< longest extension of a projected Newton step
constexpr double kShortStep = 0.3;  ///< share below which the matrix is taken anew
constexpr double kLostGrip = 0.95;  ///< so is it when the force falls by less than that

double dot(const VectorField& a, const VectorField& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

void add(double factor, const VectorField& a, VectorField& to) {
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += factor * a[i];
}

}  // namespace

Newton::Newton(const ParticleSystem& system, const Options& options)
    : system_(system), options_(options) {}

void Newton::evaluate(const VectorField& x, double& energy, VectorField& g) {
  const Stopwatch watch(counters_.evaluate);
  energy = system_.potential_and_gradient(x, g);
}

const VectorField& Newton::gradient(const VectorField& x) {
  if (!evaluated_ || x != place_) {
    evaluate(x, energy_, gradient_);
    place_ = x;
    evaluated_ = true;
  }
  return gradient_;
}

void Newton::add_inertia(const VectorField& x, const VectorField& target, double per_dt2,
                         VectorField& g) const {
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!system_.is_held(static_cast<int>(i)))
        g[i] += system_.mass[i] * per_dt2 * (x[i] - target[i]);
}

double Newton::inertia(const VectorField& x, const VectorField& target, double per_dt2) const {
  double sum = 0;
  if (per_dt2 > 0)
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += 0.5 * system_.mass[i] * per_dt2 * (x[i] - target[i]).squaredNorm();
  return sum;
}

void Newton::assemble(const VectorField& x, HessianKind kind) {
  const Stopwatch watch(counters_.assemble);
  const std::uint64_t version = system_.pattern_version(x);
  if (matrix_.particles() != system_.particles() || version != pattern_version_) {
    BlockPattern pattern(system_.particles());
    for (const Energy* e : system_.energies) e->add_pattern(x, pattern);
    pattern.compress();
    if (!matrix_.same_pattern(pattern)) matrix_ = BlockMatrix(pattern);
    pattern_version_ = version;
  }
  matrix_.set_zero();
  for (const Energy* e : system_.energies) e->add_hessian(x, matrix_, kind);
}

bool Newton::refresh(const VectorField& x, double per_dt2) {
  std::vector<double> shift(system_.particles());
  const auto attempt = [&](double regularisation) {
    for (int i = 0; i < system_.particles(); ++i)
      shift[i] = (per_dt2 + regularisation) * system_.mass[i];
    ++counters_.factorisations;
    const Stopwatch watch(counters_.factorise);
    return cholesky_.factorise(matrix_, shift, system_.held);
  };
  factor_per_dt2_ = per_dt2;
  reused_ = 0;
  has_factor_ = false;
  exact_ = wait_ == 0;
  if (exact_) {
    assemble(x, HessianKind::exact);
    if (attempt(0)) {
      patience_ = 1;
      return has_factor_ = true;
    }
    exact_ = false;
    wait_ = patience_;  // each failure in a row doubles the wait before the next try
    patience_ = std::min(8, 2 * patience_);
  } else {
    --wait_;
  }
  // The projected one; it may still be singular (cloth free to slide): add what it takes.
  assemble(x, HessianKind::definite);
  double extra = 0;
  for (int k = 0; k < 12; ++k) {
    if (attempt(extra)) return has_factor_ = true;
    extra = std::max(1.0, 100 * extra);
  }
  return false;
}

/// dx = −B g with the two loops of limited-memory BFGS round the factor's solution.
void Newton::direction(const VectorField& g, double per_dt2, VectorField& dx) {
  const Stopwatch watch(counters_.solve);
  VectorField q = g;
  const std::size_t m = corrections_.size();
  std::vector<double> alpha(m), rho(m);
  const auto curvature = [&](const Correction& c, const VectorField& v) {
    double sum = dot(c.y, v);
    if (per_dt2 > 0)
      for (std::size_t i = 0; i < v.size(); ++i)
        sum += system_.mass[i] * per_dt2 * c.s[i].dot(v[i]);
    return sum;
  };
  for (std::size_t k = m; k-- > 0;) {
    const Correction& c = corrections_[k];
    rho[k] = 1 / curvature(c, c.s);
    alpha[k] = rho[k] * dot(c.s, q);
    add(-alpha[k], c.y, q);
    if (per_dt2 > 0)
      for (std::size_t i = 0; i < q.size(); ++i)
        q[i] -= alpha[k] * system_.mass[i] * per_dt2 * c.s[i];
  }
  cholesky_.solve(q, dx);
  for (std::size_t k = 0; k < m; ++k)
    add(alpha[k] - rho[k] * curvature(corrections_[k], dx), corrections_[k].s, dx);
  for (Vec3& d : dx) d = -d;
  if (!system_.held.empty())
    for (std::size_t i = 0; i < dx.size(); ++i)
      if (system_.held[i]) dx[i].setZero();
}

void Newton::remember(const VectorField& dx, double t, const VectorField& g_new) {
  if (options_.memory == 0) return;
  Correction c{dx, g_new};
  for (Vec3& s : c.s) s *= t;
  add(-1, gradient_, c.y);
  // Along a direction of negative curvature the energy tells nothing that a definite matrix could
  // learn.
  if (!(dot(c.s, c.y) > 1e-8 * std::sqrt(dot(c.s, c.s) * dot(c.y, c.y)))) return;
  corrections_.push_back(std::move(c));
  if (static_cast<int>(corrections_.size()) > options_.memory) corrections_.pop_front();
}

Newton::Outcome Newton::iterate(VectorField& x, const VectorField& target, double dt) {
  const double per_dt2 = std::isfinite(dt) ? 1 / (dt * dt) : 0;
  Outcome outcome;
  VectorField g = gradient(x);
  add_inertia(x, target, per_dt2, g);
  outcome.force = std::sqrt(dot(g, g));
  ++counters_.iterations;
  if (!(outcome.force > 0)) return outcome;
  VectorField dx, trial(x.size()), g_trial;
  while (true) {
    const bool stale = !has_factor_ || reused_ >= options_.max_reuse ||
                       per_dt2 > 4.1 * factor_per_dt2_ ;
    if (stale) {
      if (!refresh(x, per_dt2)) return outcome;
      if (exact_) corrections_.clear();
    } else {
      ++reused_;
    }
    outcome.fresh = stale;
    outcome.exact = stale && exact_;
    direction(g, per_dt2, dx);
    double slope = dot(g, dx);
    if (!(slope < 0)) {
      corrections_.clear();
      has_factor_ = false;
      if (stale) return outcome;
      continue;
    }

    double largest = 0;
    for (const Vec3& d : dx) largest = std::max(largest, d.squaredNorm());
    largest = std::sqrt(largest);
    // The projected Hessian is too stiff along buckling directions: look farther along its step.
    const bool extend = stale && !exact_ && corrections_.empty();
    const double stretch = std::min(extend ? kStretch : 1.0, options_.max_move / largest);
    for (Vec3& d : dx) d *= stretch;
    slope *= stretch;
    // The path bends with the sheet: x + t dx + t² bend.
    VectorField bend(x.size(), Vec3::Zero());
    if (options_.curved) {
      const double h = options_.probe;
      VectorField g_plus, g_minus;
      double unused = 0;
      for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + h * dx[i];
      evaluate(trial, unused, g_plus);
      for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] - h * dx[i];
      evaluate(trial, unused, g_minus);
      for (std::size_t i = 0; i < x.size(); ++i)
        g_plus[i] = (g_plus[i] + g_minus[i] - 2 * gradient_[i]) / (h * h);
      VectorField acceleration;
      {
        const Stopwatch watch(counters_.solve);
        cholesky_.solve(g_plus, acceleration);
      }
      const double ratio = std::sqrt(dot(acceleration, acceleration) / dot(dx, dx));
      const double factor = -0.5 * std::min(1.0, options_.most_bend / ratio);
      bent_ = ratio;
      if (std::isfinite(ratio))
        for (std::size_t i = 0; i < x.size(); ++i) bend[i] = factor * acceleration[i];
      if (!system_.held.empty())
        for (std::size_t i = 0; i < x.size(); ++i)
          if (system_.held[i]) bend[i].setZero();
    }
    const double whole = std::min(1.0, 1.0 / stretch);  // the Newton step itself
    const double before = energy_ + inertia(x, target, per_dt2);
    double e_trial = 0;
    VectorField delta(x.size());
    const auto at = [&](double t) {
      for (std::size_t i = 0; i < x.size(); ++i) delta[i] = t * dx[i] + t * t * bend[i];
      double limit = 1;
      {
        const Stopwatch watch(counters_.collide);
        limit = system_.begin_search(x, delta);
      }
      for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + limit * delta[i];
      evaluate(trial, e_trial, g_trial);
      return e_trial + inertia(trial, target, per_dt2);
    };
    double t = whole;
    for (int k = 0; k < options_.max_backtracks; ++k, t *= 0.5) {
      double after = at(t);
      // Near the end the decrease drowns in round-off: then a smaller gradient decides.
      const bool drowned = std::abs(slope * t) < 1e-13 * (std::abs(before) + 1e-12);
      bool accept = after < before + 1e-4 * std::min(0.0, dot(g, delta));
      if (!accept && drowned && std::isfinite(after)) {
        VectorField gt = g_trial;
        add_inertia(trial, target, per_dt2, gt);
        accept = dot(gt, gt) < outcome.force * outcome.force;
      }
      if (!accept) {
        if (!stale && k == 3) break;  // rather a new matrix than tiny steps with an old one
        continue;
      }
      VectorField best = trial, g_best = g_trial;
      double e_best = e_trial;
      if (extend && k == 0 && !drowned)
        while (2 * t <= 1) {
          const double farther = at(2 * t);
          if (!(farther < after)) break;
          after = farther;
          t *= 2;
          best = trial;
          g_best = g_trial;
          e_best = e_trial;
        }
      remember(dx, t, g_best);
      x.swap(best);
      place_ = x;
      gradient_.swap(g_best);
      energy_ = e_best;
      evaluated_ = true;
      outcome.moved = true;
      outcome.share = t * stretch;
      outcome.bent = bent_;
      if (outcome.share < kShortStep) has_factor_ = false;
      return outcome;
    }
    corrections_.clear();
    has_factor_ = false;
    if (stale) return outcome;
  }
}

}  // namespace loosefit
