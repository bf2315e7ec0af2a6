#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/tangent_matrix.h"
#include "support/block_matrices.h"
#include "support/law_checker.h"

namespace loosefit::solver {
namespace {

/// ½ xᵀ A x − bᵀ x with a drawn matrix.
class Quadratic : public particles::Energy {
 public:
  Quadratic(int n, unsigned seed) : a_(support::random_matrix(n, 30, seed)), b_(n) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    for (Vec3& f : b_) f = Vec3(u(rng), u(rng), u(rng));
  }
  double value(const particles::VectorField& x) const override {
    particles::VectorField ax(x.size(), Vec3::Zero());
    a_.add_product(x, ax);
    return 0.5 * support::flat(ax).dot(support::flat(x)) - support::flat(b_).dot(support::flat(x));
  }
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override {
    a_.add_product(x, g);
    for (std::size_t i = 0; i < x.size(); ++i) g[i] -= b_[i];
  }
  void add_pattern(const particles::VectorField&, particles::BlockPattern& p) const override {
    for (int j = 0; j < a_.particles(); ++j)
      for (int k = a_.column_start()[j]; k < a_.column_start()[j + 1]; ++k) p.add(a_.rows()[k], j);
  }
  void add_hessian(const particles::VectorField&, particles::BlockMatrix& h,
                   particles::HessianKind) const override {
    for (int j = 0; j < a_.particles(); ++j)
      for (int k = a_.column_start()[j]; k < a_.column_start()[j + 1]; ++k)
        h.add(a_.rows()[k], j, a_.blocks()[k]);
  }

 private:
  particles::BlockMatrix a_;
  particles::VectorField b_;
};

/// Two plates among 30 particles, weights drawn.
struct Plated {
  static constexpr int kCount = 30;
  Quadratic energy;
  ParticleSystem system;
  Eigen::MatrixXd places;  ///< all coordinates from those of the unknowns, zero columns elsewhere

  explicit Plated(unsigned seed) : energy(kCount, seed) {
    std::mt19937 rng(seed + 100);
    std::uniform_real_distribution<double> u(-0.5, 1.2);
    system.energies = {&energy};
    system.mass.assign(kCount, 0.01);
    for (int first : {3, 17}) {
      Plate plate;
      plate.leaders = {first + 4, first, first + 6};
      for (int i : {first + 1, first + 2, first + 3, first + 5}) {
        const double a = u(rng), b = u(rng);
        plate.followers.push_back(i);
        plate.weights.emplace_back(a, b, 1 - a - b);
      }
      system.plates.push_back(plate);
    }
    places = Eigen::MatrixXd::Identity(3 * kCount, 3 * kCount);
    for (const Plate& plate : system.plates)
      for (std::size_t f = 0; f < plate.followers.size(); ++f) {
        const int row = 3 * plate.followers[f];
        places.block(row, 0, 3, 3 * kCount).setZero();
        for (int k = 0; k < 3; ++k)
          places.block<3, 3>(row, 3 * plate.leaders[k]) = plate.weights[f][k] * Mat3::Identity();
      }
  }
};

TEST(Plate, GradientAndMatrixAreThoseOfTheUnknowns) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Plated p(seed);
    const particles::VectorField x = support::random_field(Plated::kCount);
    particles::VectorField g(x.size(), Vec3::Zero());
    p.energy.add_gradient(x, g);
    const Eigen::VectorXd expected = p.places.transpose() * support::flat(g);
    EXPECT_LT((support::flat(p.system.gradient(x)) - expected).norm(), 1e-12 * expected.norm());

    TangentMatrix tangent(p.system);
    tangent.assemble(x, particles::HessianKind::exact);
    const Eigen::MatrixXd whole =
        support::dense_hessian(p.energy, x, particles::HessianKind::exact);
    const Eigen::MatrixXd reduced = p.places.transpose() * whole * p.places;
    EXPECT_LT((support::dense(tangent.matrix()) - reduced).norm(), 1e-12 * reduced.norm());
  }
}

TEST(Plate, CarriedMassIsNoLessThanWhatTheUnknownsCarry) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Plated p(seed);
    const Eigen::MatrixXd exact = 0.01 * p.places.transpose() * Eigen::MatrixXd(p.places);
    Eigen::VectorXd carried(3 * Plated::kCount);
    const std::vector<double> mass = p.system.carried_mass();
    for (int i = 0; i < Plated::kCount; ++i) carried.segment<3>(3 * i).setConstant(mass[i]);
    const Eigen::MatrixXd more = Eigen::MatrixXd(carried.asDiagonal()) - exact;
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(more).eigenvalues()[0], -1e-12);
  }
}

TEST(Plate, WhatBentItIsTakenOutByTheNearestAffineImage) {
  Plated p(3);
  particles::VectorField x = support::random_field(Plated::kCount);
  particles::VectorField flat = x;
  p.system.move_followers(flat);  // an affine image to start from
  particles::VectorField same = flat;
  EXPECT_FALSE(p.system.flatten_plates(same));
  EXPECT_EQ(same, flat);
  EXPECT_TRUE(p.system.flatten_plates(x));
  for (const Plate& plate : p.system.plates) {
    double moved = 0, by_leaders = 0;
    for (std::size_t f = 0; f < plate.followers.size(); ++f) {
      Vec3 there = Vec3::Zero();
      for (int k = 0; k < 3; ++k) there += plate.weights[f][k] * x[plate.leaders[k]];
      EXPECT_LT((there - x[plate.followers[f]]).norm(), 1e-12);
      const int i = plate.followers[f];
      moved += (x[i] - support::random_field(Plated::kCount)[i]).squaredNorm();
      by_leaders += (flat[i] - support::random_field(Plated::kCount)[i]).squaredNorm();
    }
    for (int i : plate.leaders)
      moved += (x[i] - support::random_field(Plated::kCount)[i]).squaredNorm();
    EXPECT_LT(moved, by_leaders) << "least squares, not the three leaders";
  }
  EXPECT_EQ(x[0], support::random_field(Plated::kCount)[0]) << "what is on no plate stays";
}

}  // namespace
}  // namespace loosefit::solver
