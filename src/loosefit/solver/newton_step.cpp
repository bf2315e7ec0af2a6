#include "loosefit/solver/newton_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loosefit/base/check.h"
#include "loosefit/particles/vector_sums.h"

namespace loosefit::solver {
namespace {

double longest(const particles::VectorField& dx) {
  double squared = 0;
  for (const Vec3& d : dx) squared = std::max(squared, d.squaredNorm());
  return std::sqrt(squared);
}

/// ∂(Π + inertia)/∂x of the particles that may move [N].
particles::VectorField force_at(const NewtonProblem& problem, const InertiaTerm& inertia,
                                const Iterate& at) {
  particles::VectorField force = at.gradient;
  inertia.add_gradient(at.x, force);
  problem.restrict(force);
  return force;
}

/// The straight line x + t dx.
class StraightLine : public SearchLine {
 public:
  StraightLine(NewtonProblem& problem, const InertiaTerm& inertia, const particles::VectorField& x,
               const particles::VectorField& dx)
      : problem_(problem), inertia_(inertia), x_(x), dx_(dx) {}

  double energy(double t) override {
    trial_.x.resize(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) trial_.x[i] = x_[i] + t * dx_[i];
    trial_.potential = problem_.evaluate(trial_.x, trial_.gradient);
    return trial_.potential + inertia_.energy(trial_.x);
  }
  // A trial that has been kept is still the one to be asked about.
  double slope() override { return particles::dot(force_at(problem_, inertia_, trial_), dx_); }
  double squared_force() override {
    const particles::VectorField force = force_at(problem_, inertia_, trial_);
    return particles::dot(force, force);
  }
  void keep() override { best_ = trial_; }
  Iterate& best() { return best_; }

 private:
  NewtonProblem& problem_;
  const InertiaTerm& inertia_;
  const particles::VectorField& x_;
  const particles::VectorField& dx_;
  Iterate trial_, best_;
};

}  // namespace

StepOutcome NewtonStep::take(NewtonProblem& problem, const InertiaTerm& inertia, Iterate& at,
                             double min_force) {
  LOOSEFIT_ASSERT(at.gradient.size() == at.x.size());
  StepOutcome outcome;
  const particles::VectorField force = force_at(problem, inertia, at);
  outcome.force = std::sqrt(particles::dot(force, force));
  if (!(outcome.force > min_force)) return outcome;

  // Direction: downhill for a definite matrix, but for round-off.
  const auto kind =
      factorise(problem, at.x, inertia.per_dt2(), std::exchange(calm_, false), matrix_);
  if (!kind) return outcome;
  outcome.exact = *kind == MatrixKind::exact;
  particles::VectorField dx;
  problem.solve(force, dx);
  double slope = particles::dot(force, dx);
  if (!(slope < 0)) return outcome;

  // Length: other matrices than the exact one are too stiff along buckling directions, so look
  // farther along their steps; max_move bounds all.
  const double extension =
      std::min(outcome.exact ? 1.0 : extension_, tuning_.max_move / longest(dx));
  for (Vec3& d : dx) d *= extension;
  slope *= extension;
  SearchStart start;
  start.slope = slope;
  start.force = outcome.force;
  start.first = std::min(1.0, 1.0 / extension);  // the Newton step itself
  start.limit = problem.max_step(at.x, dx);
  start.energy = at.potential + inertia.energy(at.x);

  StraightLine line(problem, inertia, at.x, dx);
  const SearchResult found = line_search(line, start, search_);
  if (!found.found) return outcome;
  std::swap(at, line.best());
  outcome.moved = true;
  outcome.share = found.t * extension;
  calm_ = outcome.share >= tuning_.whole;
  outcome.below_round_off = found.below_round_off;
  extension_ = outcome.share > tuning_.whole * extension_
                   ? std::min(tuning_.max_extension, tuning_.extension_growth * extension_)
                   : tuning_.first_extension;
  return outcome;
}

}  // namespace loosefit::solver
