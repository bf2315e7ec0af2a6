#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/solver/stopwatch.h"
#include "method.h"
#include "vector_sums.h"

namespace loosefit::bakeoff {
namespace {

constexpr double kStretch = 8;      ///< longest extension of a fresh projected Newton step
constexpr double kShortStep = 0.3;  ///< share below which the matrix is taken anew
constexpr int kBacktracks = 25;
constexpr int kStaleBacktracks = 3;  ///< rather a new matrix than tiny steps with an old one
constexpr double kProbe = 0.1;       ///< of the differences along the direction
constexpr double kMostBend = 0.75;   ///< longest second-order part over the first-order one

class Factored : public Method {
 public:
  Factored(const ParticleSystem& system, const FactoredOptions& options,
           std::unique_ptr<DirectionRule> rule)
      : system_(system), options_(options), rule_(std::move(rule)) {}

  const SolverWork& work() const override { return work_; }
  void begin_step(const VectorField& x, double dt) override {
    const Stopwatch watch(work_.refresh);
    system_.begin_step(x, dt);
    evaluated_ = false;
  }
  const VectorField& gradient(const VectorField& x) override {
    if (!evaluated_ || x != place_) {
      evaluate(x, energy_, gradient_);
      place_ = x;
      evaluated_ = true;
    }
    return gradient_;
  }

  Newton::Outcome iterate(VectorField& x, const VectorField& target, double dt) override {
    per_dt2_ = std::isfinite(dt) ? 1 / (dt * dt) : 0;
    Newton::Outcome outcome;
    VectorField g = gradient(x);
    add_inertia(x, target, g);
    outcome.force = norm(g);
    ++work_.iterations;
    if (!(outcome.force > 0)) return outcome;
    while (true) {
      const bool fresh = is_stale();
      if (fresh && !refresh(x)) return outcome;
      if (!fresh) {
        ++used_;
        if (rule_->multiplies()) assemble(x, HessianKind::exact);
      }
      if (advance(x, target, g, fresh, outcome)) return outcome;
      rule_->forget();
      if (!options_.matrix.constant) has_factor_ = false;
      // The rule's past is gone: try once more, without it or with a new matrix.
      if (fresh || retried_) {
        retried_ = false;
        return outcome;
      }
      retried_ = true;
    }
  }

 private:
  void evaluate(const VectorField& x, double& energy, VectorField& g) {
    const Stopwatch watch(work_.evaluate);
    energy = system_.potential_and_gradient(x, g);
  }
  void add_inertia(const VectorField& x, const VectorField& target, VectorField& g) const {
    if (per_dt2_ > 0)
      for (std::size_t i = 0; i < x.size(); ++i)
        if (!system_.is_held(static_cast<int>(i)))
          g[i] += system_.mass[i] * per_dt2_ * (x[i] - target[i]);
  }
  double inertia(const VectorField& x, const VectorField& target) const {
    double sum = 0;
    if (per_dt2_ > 0)
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += 0.5 * system_.mass[i] * per_dt2_ * (x[i] - target[i]).squaredNorm();
    return sum;
  }
  void free_only(VectorField& v) const {
    if (!system_.held.empty())
      for (std::size_t i = 0; i < v.size(); ++i)
        if (system_.held[i]) v[i].setZero();
  }

  bool is_stale() const {
    if (!has_factor_) return true;
    const double ratio = (per_dt2_ + 1) / (factor_per_dt2_ + 1);
    if (options_.matrix.constant) return ratio > 4 || ratio < 0.25;
    return used_ >= options_.matrix.iterations_per_factor || ratio > 4.1;
  }
  void assemble(const VectorField& x, HessianKind kind) {
    const Stopwatch watch(work_.assemble);
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
  bool attempt(double extra) {
    std::vector<double> shift(system_.particles());
    for (int i = 0; i < system_.particles(); ++i) shift[i] = (per_dt2_ + extra) * system_.mass[i];
    ++work_.factorisations;
    const Stopwatch watch(work_.factorise);
    return has_factor_ = cholesky_.factorise(matrix_, shift, system_.held);
  }
  bool refresh(const VectorField& x) {
    const bool exact_wanted = options_.matrix.kind == MatrixUse::Kind::exact_or_projected;
    factor_per_dt2_ = per_dt2_;
    used_ = 1;
    exact_ = exact_wanted && wait_ == 0;
    if (exact_) {
      assemble(x, HessianKind::exact);
      if (attempt(0)) {
        patience_ = 1;
        return true;
      }
      exact_ = false;
      wait_ = patience_;  // each failure in a row doubles the wait before the next try
      patience_ = std::min(8, 2 * patience_);
    } else if (exact_wanted) {
      --wait_;
    }
    if (!options_.matrix.constant || matrix_.particles() == 0) assemble(x, HessianKind::projected);
    for (double extra = 0; extra < 1e24; extra = std::max(1.0, 100 * extra))
      if (attempt(extra)) {
        if (rule_->multiplies() && exact_wanted) assemble(x, HessianKind::exact);
        return true;
      }
    return false;
  }

  VectorField direction(const VectorField& g) {
    const Stopwatch watch(work_.solve);
    const auto solve = [&](const VectorField& r, VectorField& z) {
      cholesky_.solve(r, z);
      free_only(z);
    };
    const auto multiply = [&](const VectorField& v, VectorField& hv) {
      hv.assign(v.size(), Vec3::Zero());
      matrix_.add_product(v, hv);
      free_only(hv);
    };
    const auto inertial = [&](const VectorField& v) {
      VectorField m(v.size());
      for (std::size_t i = 0; i < v.size(); ++i) m[i] = system_.mass[i] * per_dt2_ * v[i];
      return m;
    };
    return rule_->direction(g, solve, multiply, inertial);
  }
  /// The part of the path x + t dx + t² bend that follows the curved valley.
  VectorField bend_of(const VectorField& x, const VectorField& dx) {
    VectorField bend(x.size(), Vec3::Zero()), probe = x, plus, minus;
    double unused = 0;
    add(kProbe, dx, probe);
    evaluate(probe, unused, plus);
    add(-2 * kProbe, dx, probe);
    evaluate(probe, unused, minus);
    for (std::size_t i = 0; i < x.size(); ++i)
      plus[i] = (plus[i] + minus[i] - 2 * gradient_[i]) / (kProbe * kProbe);
    {
      const Stopwatch watch(work_.solve);
      cholesky_.solve(plus, bend);
    }
    free_only(bend);
    const double ratio = norm(bend) / norm(dx);
    const double factor = std::isfinite(ratio) ? -0.5 * std::min(1.0, kMostBend / ratio) : 0;
    for (Vec3& v : bend) v = std::isfinite(ratio) ? Vec3(factor * v) : Vec3(Vec3::Zero());
    return bend;
  }

  /// Searches along a direction; true when x moved. For a curved path every trial is a search of
  /// its own, since contact limits straight segments.
  bool advance(VectorField& x, const VectorField& target, const VectorField& g, bool fresh,
               Newton::Outcome& outcome) {
    outcome.exact = fresh && exact_;
    VectorField dx = direction(g);
    if (!(dot(g, dx) < 0)) return false;
    double largest = 0;
    for (const Vec3& d : dx) largest = std::max(largest, d.squaredNorm());
    largest = std::sqrt(largest);
    const bool extend = fresh && !exact_ && !options_.matrix.constant;
    const double stretch = std::min(extend ? kStretch : 1.0, options_.max_move / largest);
    for (Vec3& d : dx) d *= stretch;
    const double slope = dot(g, dx), whole = std::min(1.0, 1.0 / stretch);
    const VectorField bend = options_.curved ? bend_of(x, dx) : VectorField{};
    double straight_limit = 1;
    if (!options_.curved) {
      const Stopwatch watch(work_.collide);
      straight_limit = system_.max_step(x, dx);
    }
    const double before = energy_ + inertia(x, target);
    VectorField trial(x.size()), g_trial, delta(x.size());
    double e_trial = 0;
    const auto at = [&](double t) {
      for (std::size_t i = 0; i < x.size(); ++i) delta[i] = t * dx[i];
      if (options_.curved) {
        add(t * t, bend, delta);
        const Stopwatch watch(work_.collide);
        const double limit = system_.max_step(x, delta);
        for (Vec3& d : delta) d *= limit;
      }
      trial = x;
      add(1, delta, trial);
      evaluate(trial, e_trial, g_trial);
      return e_trial + inertia(trial, target);
    };
    double t = std::min(straight_limit, whole);
    for (int k = 0; k < kBacktracks; ++k, t *= 0.5) {
      if (!fresh && !options_.matrix.constant && k > kStaleBacktracks) return false;
      double after = at(t);
      const bool drowned = std::abs(slope * t) < 1e-13 * (std::abs(before) + 1e-12);
      const double wanted = options_.curved ? std::min(0.0, dot(g, delta)) : t * slope;
      bool accept = after <= before + 1e-4 * wanted;
      if (!accept && drowned && std::isfinite(after)) {
        VectorField force = g_trial;
        add_inertia(trial, target, force);
        accept = norm(force) < outcome.force;
      }
      if (!accept) continue;
      VectorField best = trial, g_best = g_trial;
      double e_best = e_trial;
      if (extend && k == 0 && !drowned)
        while (2 * t <= straight_limit) {
          const double farther = at(2 * t);
          if (!(farther < after)) break;
          after = farther;
          t *= 2;
          best = trial;
          g_best = g_trial;
          e_best = e_trial;
        }
      rule_->accepted(difference(best, x), difference(g_best, gradient_));
      x.swap(best);
      place_ = x;
      gradient_.swap(g_best);
      energy_ = e_best;
      evaluated_ = outcome.moved = true;
      outcome.share = t * stretch;
      if (outcome.share < kShortStep && !options_.matrix.constant) has_factor_ = false;
      retried_ = false;
      return true;
    }
    return false;
  }

  const ParticleSystem& system_;
  FactoredOptions options_;
  std::unique_ptr<DirectionRule> rule_;
  SolverWork work_;
  SparseCholesky<double> cholesky_;
  BlockMatrix matrix_;
  std::uint64_t pattern_version_ = 0;
  bool has_factor_ = false, exact_ = false, retried_ = false, evaluated_ = false;
  double per_dt2_ = 0, factor_per_dt2_ = 0, energy_ = 0;
  int used_ = 0, wait_ = 0, patience_ = 1;
  VectorField place_, gradient_;
};

}  // namespace

std::unique_ptr<Method> make_factored(const ParticleSystem& system, const FactoredOptions& options,
                                      std::unique_ptr<DirectionRule> rule) {
  return std::make_unique<Factored>(system, options, std::move(rule));
}

}  // namespace loosefit::bakeoff
