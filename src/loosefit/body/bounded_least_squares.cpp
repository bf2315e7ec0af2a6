#include "loosefit/body/bounded_least_squares.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "loosefit/geometry/least_squares.h"

namespace loosefit::body {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxSteps = 40;
constexpr int kMaxHalvings = 6;
constexpr double kStopDecrease = 1e-4;
constexpr double kStill = 1e-9;  ///< slope at a bound that counts as none, of the residuals' norm

/// Least |jacobian · step + residual|² over the box by an active set (Stark and Parker 1995):
/// unknowns that want out stay on their bound, and are released when the others leave them room.
class BoxedStep {
 public:
  BoxedStep(const MatrixXd& jacobian, const VectorXd& residual, VectorXd low, VectorXd high)
      : jacobian_(jacobian),
        residual_(residual),
        low_(std::move(low)),
        high_(std::move(high)),
        step_(VectorXd::Zero(jacobian.cols())),
        held_(std::size_t(jacobian.cols()), 0) {}

  VectorXd solve() {
    // Rounding could release and hold the same one for ever.
    for (Eigen::Index round = 0; round < 4 * step_.size(); ++round) {
      while (!step_to_least()) {
      }
      if (!release_one()) break;
    }
    return step_;
  }

 private:
  /// Moves the free unknowns to their least squares, or as far as the first bound on the way, which
  /// then holds its unknown. True when it arrives.
  bool step_to_least() {
    std::vector<Eigen::Index> free;
    VectorXd right = -residual_;
    for (Eigen::Index i = 0; i < step_.size(); ++i) {
      if (held_[std::size_t(i)])
        right -= jacobian_.col(i) * step_[i];
      else
        free.push_back(i);
    }
    if (free.empty()) return true;
    MatrixXd columns(residual_.size(), Eigen::Index(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
      columns.col(Eigen::Index(k)) = jacobian_.col(free[k]);
    const VectorXd least = geometry::least_squares(columns, right);
    double share = 1;
    Eigen::Index first = -1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto i = free[k];
      const double to = least[Eigen::Index(k)];
      if (to >= low_[i] && to <= high_[i]) continue;
      const double bound = to < low_[i] ? low_[i] : high_[i];
      const double reached = (bound - step_[i]) / (to - step_[i]);
      if (first < 0 || reached < share) share = reached, first = i;
    }
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto i = free[k];
      const double to = least[Eigen::Index(k)];
      if (first < 0)
        step_[i] = to;
      else
        step_[i] = std::clamp(step_[i] + share * (to - step_[i]), low_[i], high_[i]);
      if (i == first) step_[i] = to < low_[i] ? low_[i] : high_[i];
    }
    if (first >= 0) held_[std::size_t(first)] = 1;
    return first < 0;
  }

  /// Releases the held unknown that would lower the sum most by moving inwards.
  bool release_one() {
    const VectorXd slope = jacobian_.transpose() * (jacobian_ * step_ + residual_);
    Eigen::Index best = -1;
    double most = kStill * residual_.norm();
    for (Eigen::Index i = 0; i < step_.size(); ++i) {
      if (!held_[std::size_t(i)] || low_[i] == high_[i]) continue;
      const double inwards = step_[i] == low_[i] ? -slope[i] : slope[i];
      if (inwards > most) most = inwards, best = i;
    }
    if (best < 0) return false;
    held_[std::size_t(best)] = 0;
    return true;
  }

  const MatrixXd& jacobian_;
  const VectorXd& residual_;
  VectorXd low_, high_, step_;
  std::vector<char> held_;
};

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
    VectorXd step =
        BoxedStep(jacobian, residual, problem.lower - found.x, problem.upper - found.x).solve();
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
