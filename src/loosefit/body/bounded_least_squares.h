#pragma once
#include <Eigen/Core>
#include <functional>

namespace loosefit::body {

/// A smooth vector of residuals over a box.
struct BoundedProblem {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residuals;
  Eigen::VectorXd start, lower, upper;
  double difference = 0.02;  ///< step of the finite differences
};

struct BoundedSolution {
  Eigen::VectorXd x;
  double cost = 0;  ///< squared norm of the residuals
  int evaluations = 0;
};

/// Gauss-Newton with an active set for the box and step halving. Stops when a step lowers the cost
/// by less than 1e-4 of it. Differences never step across zero, where our residuals have a kink.
BoundedSolution bounded_gauss_newton(const BoundedProblem& problem);

}  // namespace loosefit::body
