#include <algorithm>
#include <cmath>

#include "factored_problem.h"
#include "loosefit/solver/inertia_term.h"
#include "loosefit/solver/line_search.h"
#include "loosefit/solver/matrix_choice.h"
#include "loosefit/solver/stopwatch.h"
#include "method.h"
#include "vector_sums.h"

namespace loosefit::bakeoff {
namespace {

constexpr double kShortStep = 0.3;   ///< share below which the matrix is taken anew
constexpr int kStaleBacktracks = 4;  ///< rather a new matrix than tiny steps with an old one
constexpr double kProbe = 0.1;       ///< of the differences along the direction
constexpr double kMostBend = 0.75;   ///< longest second-order part over the first-order one

/// The path x + t dx + t² bend. Collisions limit straight segments, so on a curved path every trial
/// is limited by itself.
class Path : public solver::SearchLine {
 public:
  Path(FactoredProblem& problem, const solver::InertiaTerm& inertia,
       const particles::VectorField& x, const particles::VectorField& dx,
       const particles::VectorField& bend)
      : problem_(problem), inertia_(inertia), x_(x), dx_(dx), bend_(bend) {}

  double energy(double t) override {
    particles::VectorField delta(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) delta[i] = t * dx_[i];
    if (!bend_.empty()) {
      add(t * t, bend_, delta);
      const double limit = problem_.max_step(x_, delta);
      for (Vec3& d : delta) d *= limit;
    }
    trial_.x = x_;
    add(1, delta, trial_.x);
    trial_.potential = problem_.evaluate(trial_.x, trial_.gradient);
    return trial_.potential + inertia_.energy(trial_.x);
  }
  double slope() override { return particles::dot(force(), dx_); }
  double squared_force() override {
    const particles::VectorField f = force();
    return particles::dot(f, f);
  }
  void keep() override { best_ = trial_; }
  solver::Iterate& best() { return best_; }

 private:
  particles::VectorField force() const {
    particles::VectorField f = trial_.gradient;
    inertia_.add_gradient(trial_.x, f);
    return f;
  }
  FactoredProblem& problem_;
  const solver::InertiaTerm& inertia_;
  const particles::VectorField &x_, &dx_, &bend_;
  solver::Iterate trial_, best_;
};

solver::MatrixTuning matrix_tuning(const MatrixUse& use) {
  solver::MatrixTuning tuning;
  tuning.exact = use.kind == MatrixUse::Kind::exact_or_projected;
  tuning.half_compression = false;
  return tuning;
}

class Factored : public solver::DescentMethod {
 public:
  Factored(const solver::ParticleSystem& system, const FactoredOptions& options,
           std::unique_ptr<DirectionRule> rule)
      : system_(system),
        options_(options),
        rule_(std::move(rule)),
        problem_(system, options.matrix),
        matrix_(matrix_tuning(options.matrix)) {}

  void restart(double max_move) override {
    step_.max_move = max_move;
    problem_.work() = {};
    evaluated_ = false;
  }
  const solver::SolverWork& work() const override { return problem_.work(); }
  void begin_step(const particles::VectorField& x, double dt) override {
    const solver::Stopwatch watch(problem_.work().refresh);
    system_.begin_step(x, dt);
    evaluated_ = false;
  }
  const particles::VectorField& gradient(const particles::VectorField& x) override {
    if (!evaluated_ || x != at_.x) {
      at_.potential = problem_.evaluate(x, at_.gradient);
      at_.x = x;
      evaluated_ = true;
    }
    return at_.gradient;
  }

  solver::StepOutcome iterate(particles::VectorField& x, const particles::VectorField& target,
                              double dt) override {
    const solver::InertiaTerm inertia(system_, target, dt);
    solver::StepOutcome outcome;
    particles::VectorField g = gradient(x);
    inertia.add_gradient(x, g);
    outcome.force = norm(g);
    ++problem_.work().iterations;
    if (!(outcome.force > 0)) return outcome;
    while (true) {
      const bool fresh = is_stale(inertia.per_dt2());
      if (fresh && !refresh(x, inertia.per_dt2())) return outcome;
      if (!fresh) {
        ++used_;
        if (rule_->multiplies()) problem_.assemble(x, particles::HessianKind::exact);
      }
      if (advance(inertia, g, fresh, outcome)) {
        x = at_.x;
        return outcome;
      }
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
  bool is_stale(double per_dt2) const {
    if (!has_factor_) return true;
    const double ratio = (per_dt2 + 1) / (factor_per_dt2_ + 1);
    if (options_.matrix.constant) return ratio > 4 || ratio < 0.25;
    return used_ >= options_.matrix.iterations_per_factor || ratio > 4.1;
  }
  bool refresh(const particles::VectorField& x, double per_dt2) {
    factor_per_dt2_ = per_dt2;
    used_ = 1;
    const auto kind = solver::factorise(problem_, x, per_dt2, true, matrix_);
    has_factor_ = kind.has_value();
    exact_ = kind == solver::MatrixKind::exact;
    if (has_factor_ && !exact_ && rule_->multiplies())
      problem_.assemble(x, particles::HessianKind::exact);
    return has_factor_;
  }

  particles::VectorField direction(const solver::InertiaTerm& inertia,
                                   const particles::VectorField& g) {
    const solver::Stopwatch watch(problem_.work().solve);
    const auto solve = [&](const particles::VectorField& r, particles::VectorField& z) {
      problem_.precondition(r, z);
    };
    const auto multiply = [&](const particles::VectorField& v, particles::VectorField& hv) {
      problem_.multiply(v, hv);
    };
    const auto inertial = [&](const particles::VectorField& v) {
      particles::VectorField m(v.size());
      for (std::size_t i = 0; i < v.size(); ++i) m[i] = system_.mass[i] * inertia.per_dt2() * v[i];
      return m;
    };
    return rule_->direction(g, solve, multiply, inertial);
  }
  /// The part of the path x + t dx + t² bend that follows the curved valley.
  particles::VectorField bend_of(const particles::VectorField& dx) {
    particles::VectorField bend(dx.size(), Vec3::Zero()), probe = at_.x, plus, minus;
    add(kProbe, dx, probe);
    problem_.evaluate(probe, plus);
    add(-2 * kProbe, dx, probe);
    problem_.evaluate(probe, minus);
    for (std::size_t i = 0; i < dx.size(); ++i)
      plus[i] = (plus[i] + minus[i] - 2 * at_.gradient[i]) / (kProbe * kProbe);
    problem_.precondition(plus, bend);
    const double ratio = norm(bend) / norm(dx);
    const double factor = std::isfinite(ratio) ? -0.5 * std::min(1.0, kMostBend / ratio) : 0;
    for (Vec3& v : bend) v = std::isfinite(ratio) ? Vec3(factor * v) : Vec3(Vec3::Zero());
    return bend;
  }

  /// Searches along a direction from at_; true when it moved.
  bool advance(const solver::InertiaTerm& inertia, const particles::VectorField& g, bool fresh,
               solver::StepOutcome& outcome) {
    outcome.exact = fresh && exact_;
    particles::VectorField dx = direction(inertia, g);
    if (!(particles::dot(g, dx) < 0)) return false;
    double largest = 0;
    for (const Vec3& d : dx) largest = std::max(largest, d.squaredNorm());
    const bool extend = fresh && !exact_ && !options_.matrix.constant;
    const double extension =
        std::min(extend ? step_.max_extension : 1.0, step_.max_move / std::sqrt(largest));
    for (Vec3& d : dx) d *= extension;
    const particles::VectorField bend = options_.curved ? bend_of(dx) : particles::VectorField{};

    solver::SearchStart start;
    start.slope = particles::dot(g, dx);
    start.force = outcome.force;
    start.first = std::min(1.0, 1.0 / extension);
    start.limit = options_.curved ? 1.0 : problem_.max_step(at_.x, dx);
    start.energy = at_.potential + inertia.energy(at_.x);
    solver::LineSearchTuning search;
    if (!fresh && !options_.matrix.constant) search.max_backtracks = kStaleBacktracks;
    Path path(problem_, inertia, at_.x, dx, bend);
    const solver::SearchResult found = solver::line_search(path, start, search);
    if (!found.found) return false;

    rule_->accepted(difference(path.best().x, at_.x),
                    difference(path.best().gradient, at_.gradient));
    std::swap(at_, path.best());
    outcome.moved = true;
    outcome.share = found.t * extension;
    if (outcome.share < kShortStep && !options_.matrix.constant) has_factor_ = false;
    retried_ = false;
    return true;
  }

  const solver::ParticleSystem& system_;
  FactoredOptions options_;
  std::unique_ptr<DirectionRule> rule_;
  FactoredProblem problem_;
  solver::MatrixTuning matrix_;
  solver::StepTuning step_;
  solver::Iterate at_;
  bool has_factor_ = false, exact_ = false, retried_ = false, evaluated_ = false;
  double factor_per_dt2_ = 0;
  int used_ = 0;  ///< iterations that the factor has served
};

}  // namespace

std::unique_ptr<solver::DescentMethod> make_factored(const solver::ParticleSystem& system,
                                                     const FactoredOptions& options,
                                                     std::unique_ptr<DirectionRule> rule) {
  return std::make_unique<Factored>(system, options, std::move(rule));
}

}  // namespace loosefit::bakeoff
