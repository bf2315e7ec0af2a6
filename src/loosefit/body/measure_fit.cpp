#include "loosefit/body/measure_fit.h"

#include <cmath>

#include "loosefit/body/body_tape.h"
#include "loosefit/body/bounded_least_squares.h"

namespace loosefit::body {
namespace {

// What a wish that yields counts, and the pulls towards the average beside it.
constexpr double kYieldingShare = 0.1, kYieldingPull = 0.02;

BodyParameters parameters_at(const BodyParameters& fixed, const std::vector<Unknown>& unknowns,
                             const Eigen::VectorXd& x) {
  BodyParameters p = fixed;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const double value = x[Eigen::Index(i)];
    if (unknowns[i].key == "height")
      p.height = value;
    else if (unknowns[i].key == "weight")
      p.weight = value;
    else
      p.details[unknowns[i].key] = value;
  }
  return p;
}

void measure(const BodyModel& model, BodyDetail detail, const BodyParameters& parameters,
             std::vector<MeasureRow>& table) {
  const RestBody rest = model.rest(parameters, detail);
  const BodyTape tape(model.data(), rest);
  for (MeasureRow& row : table) row.measured = tape.measure(row.name);
}

double unit_of(const MeasureRow& row) {
  return row.name == "height" ? kStatureMissUnit : kMissUnit;
}

}  // namespace

double miss(const MeasureRow& row) { return std::abs(row.measured - row.asked) / row.asked; }

FoundPerson nearest_person(const BodyModel& model, BodyDetail detail, const BodyParameters& fixed,
                           const std::vector<MeasureRow>& asked,
                           const std::vector<Unknown>& unknowns, const Progress* progress,
                           const std::string& yielding) {
  FoundPerson found;
  found.table = asked;
  const double pull = yielding.empty() ? 1 : kYieldingPull;
  BoundedProblem problem;
  const auto n = Eigen::Index(unknowns.size());
  problem.start = problem.lower = problem.upper = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Unknown& unknown = unknowns[std::size_t(i)];
    problem.start[i] = unknown.start;
    problem.lower[i] = unknown.low;
    problem.upper[i] = unknown.high;
  }
  problem.residuals = [&](const Eigen::VectorXd& x) {
    if (progress) progress->check_cancelled();
    measure(model, detail, parameters_at(fixed, unknowns, x), found.table);
    Eigen::VectorXd values(Eigen::Index(asked.size()) + n);
    Eigen::Index k = 0;
    for (const MeasureRow& row : found.table)
      values[k++] = (row.measured / row.asked - 1) / unit_of(row) *
                    (row.name == yielding ? kYieldingShare : 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Unknown& unknown = unknowns[std::size_t(i)];
      values[k++] = pull * unknown.stiffness * (x[i] - unknown.usual);
    }
    return values;
  };
  const BoundedSolution solution = bounded_gauss_newton(problem);
  found.evaluations = solution.evaluations;
  found.parameters = parameters_at(fixed, unknowns, solution.x);
  measure(model, detail, found.parameters, found.table);
  for (const MeasureRow& row : found.table) found.misfit += std::pow(miss(row) / unit_of(row), 2);
  return found;
}

}  // namespace loosefit::body
