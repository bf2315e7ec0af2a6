#include "loosefit/body/bounded_least_squares.h"

#include <vector>

#include "loosefit/geometry/least_squares.h"

namespace loosefit::body {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxSteps = 40;
constexpr int kMaxHalvings = 6;
constexpr double kStopDecrease = 1e-4;

// Step of A·step ≈ -r with x + step inside the box: unknowns that want out are put on their bound
// and the rest is solved again.
VectorXd boxed_step(const MatrixXd& jacobian, const VectorXd& residual, const VectorXd& x,
                    const BoundedProblem& problem) {
  const auto n = x.size();
  VectorXd step = VectorXd::Zero(n);
  std::vector<char> fixed(std::size_t(n), 0);
  for (Eigen::Index round = 0; round <= n; ++round) {
    // What the unknowns on their bounds contribute goes to the right-hand side.
    std::vector<Eigen::Index> free;
    VectorXd right = -residual;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (fixed[std::size_t(i)]) {
        right -= jacobian.col(i) * step[i];
      } else {
        free.push_back(i);
      }
    }
    if (free.empty()) break;
    // Least squares in the free ones by QR.
    MatrixXd columns(residual.size(), Eigen::Index(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
      columns.col(Eigen::Index(k)) = jacobian.col(free[k]);
    const VectorXd solved = geometry::least_squares(columns, right);
    // Those that leave the box are fixed on its bound; done when none does.
    bool inside = true;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto i = free[k];
      step[i] = solved[Eigen::Index(k)];
      const double low = problem.lower[i] - x[i], high = problem.upper[i] - x[i];
      if (step[i] < low || step[i] > high) {
        step[i] = step[i] < low ? low : high;
        fixed[std::size_t(i)] = 1;
        inside = false;
      }
    }
    if (inside) break;
  }
  return step;
}

}  // namespace

BoundedSolution bounded_gauss_newton(const BoundedProblem& problem) {
  BoundedSolution found;
  found.x = problem.start;
  const auto evaluate = [&](const VectorXd& x) {
    ++found.evaluations;
    return problem.residuals(x);
  };
  VectorXd residual = evaluate(found.x);
  found.cost = residual.squaredNorm();

  for (int iteration = 0; iteration < kMaxSteps; ++iteration) {
    // Jacobian by one-sided differences that stay inside the box.
    MatrixXd jacobian(residual.size(), found.x.size());
    for (Eigen::Index i = 0; i < found.x.size(); ++i) {
      double h = found.x[i] < 0 ? -problem.difference : problem.difference;
      if (found.x[i] + h > problem.upper[i] || found.x[i] + h < problem.lower[i]) h = -h;
      VectorXd x = found.x;
      x[i] += h;
      jacobian.col(i) = (evaluate(x) - residual) / h;
    }
    // Line search: halve the step until the cost falls.
    VectorXd step = boxed_step(jacobian, residual, found.x, problem);
    bool better = false;
    double decrease = 0;
    for (int halving = 0; halving <= kMaxHalvings && !better; ++halving, step *= 0.5) {
      const VectorXd x = (found.x + step).cwiseMax(problem.lower).cwiseMin(problem.upper);
      const VectorXd tried = evaluate(x);
      if (tried.squaredNorm() < found.cost) {
        decrease = found.cost - tried.squaredNorm();
        found.x = x;
        residual = tried;
        found.cost = tried.squaredNorm();
        better = true;
      }
    }
    // Done when no step helps, or hardly.
    if (!better || decrease < kStopDecrease * (found.cost + decrease)) break;
  }
  return found;
}

}  // namespace loosefit::body
