#include "loosefit/body/bounded_least_squares.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/geometry/least_squares.h"

namespace loosefit::body {
namespace {

/// Least |a x + b|² over the box [−1, 1]ⁿ by trying every way to hold unknowns on their bounds.
double least_of_all(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const auto n = a.cols();
  double least = std::numeric_limits<double>::infinity();
  int ways = 1;
  for (Eigen::Index i = 0; i < n; ++i) ways *= 3;
  for (int way = 0; way < ways; ++way) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0, digits = way; i < n; ++i, digits /= 3)
      digits % 3 == 2 ? free.push_back(i) : void(x[i] = digits % 3 == 0 ? -1.0 : 1.0);
    if (!free.empty()) {
      Eigen::MatrixXd columns(a.rows(), Eigen::Index(free.size()));
      for (std::size_t k = 0; k < free.size(); ++k) columns.col(Eigen::Index(k)) = a.col(free[k]);
      const Eigen::VectorXd solved = geometry::least_squares(columns, -(b + a * x));
      for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] = solved[Eigen::Index(k)];
    }
    if (x.cwiseAbs().maxCoeff() <= 1 + 1e-12) least = std::min(least, (a * x + b).squaredNorm());
  }
  return least;
}

TEST(BoundedLeastSquares, FindsTheLeastOverTheBox) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 40; ++draw) {
    const Eigen::Index n = 2 + draw % 4;
    const auto number = [&] { return normal(random); };
    // Columns that are much alike: what leaves the box first is often not what should stay there.
    const Eigen::VectorXd common = Eigen::VectorXd::NullaryExpr(n + 2, number);
    const Eigen::MatrixXd a =
        0.5 * Eigen::MatrixXd::NullaryExpr(n + 2, n, number) + common * Eigen::RowVectorXd::Ones(n);
    const Eigen::VectorXd b = 4 * Eigen::VectorXd::NullaryExpr(n + 2, number);
    BoundedProblem problem;
    problem.residuals = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(a * x + b); };
    problem.start = Eigen::VectorXd::Zero(n);
    problem.lower = Eigen::VectorXd::Constant(n, -1), problem.upper = -problem.lower;
    EXPECT_NEAR(bounded_gauss_newton(problem).cost, least_of_all(a, b), 1e-6 * b.squaredNorm())
        << draw;
  }
}

}  // namespace
}  // namespace loosefit::body
