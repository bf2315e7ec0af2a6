#include "loosefit/fabric/board_energy.h"

#include <gtest/gtest.h>

#include <random>

#include "support/law_checker.h"

namespace loosefit::fabric {
namespace {

/// A board somewhere in space: turned, a little strained, its centre of mass off the cloth.
struct DrawnBoard {
  RigidPlate plate;
  particles::VectorField x;

  explicit DrawnBoard(unsigned seed, double strain) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    plate.leaders = {2, 0, 3};
    plate.rest = {Vec2(0, 0), Vec2(0.04 + 0.01 * u(rng), 0.01 * u(rng)),
                  Vec2(0.01 * u(rng), 0.03 + 0.01 * u(rng))};
    plate.area = 1e-3;
    plate.mass = 0.02 * (1.5 + u(rng));
    plate.offset = 0.008 * u(rng);
    const Mat3 turn =
        Eigen::AngleAxisd(3 * u(rng), Vec3(u(rng), u(rng), u(rng)).normalized()).toRotationMatrix();
    x.assign(4, Vec3(0.1, 0.2, 0.3));
    for (int k = 0; k < 3; ++k)
      x[plate.leaders[k]] += turn * Vec3(plate.rest[k].x(), plate.rest[k].y(), 0) +
                             strain * 0.04 * Vec3(u(rng), u(rng), u(rng));
  }
};

TEST(BoardEnergy, ForcesAndStiffnessAreItsDerivatives) {
  for (unsigned seed = 1; seed < 12; ++seed) {
    const DrawnBoard board(seed, seed % 2 ? 0.02 : 0.2);
    support::expect_derivatives(BoardEnergy({board.plate}, kGravity), board.x, 1e-6, 1e-5);
    // The weight alone, which the stiffness would hide.
    RigidPlate weight = board.plate;
    weight.area = 0;
    support::expect_derivatives(BoardEnergy({weight}, kGravity), board.x, 1e-6, 1e-5);
  }
}

TEST(BoardEnergy, TurnsAndMovesForNothingButItsWeight) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const DrawnBoard board(seed, 0);
    EXPECT_NEAR(BoardEnergy({board.plate}, 0).value(board.x), 0, 1e-15);
    for (const Vec3& f : support::gradient(BoardEnergy({board.plate}, 0), board.x))
      EXPECT_LT(f.norm(), 1e-9);
  }
}

TEST(BoardEnergy, TheMomentIsThatOfTheWeightAtItsLever) {
  for (unsigned seed = 1; seed < 9; ++seed) {
    const DrawnBoard board(seed, 0);
    const auto& [a, b, c] = board.plate.leaders;
    const Vec3 normal = (board.x[b] - board.x[a]).cross(board.x[c] - board.x[a]).normalized();
    const Vec3 weight = board.plate.mass * kGravity * -Vec3::UnitZ();
    const particles::VectorField g =
        support::gradient(BoardEnergy({board.plate}, kGravity), board.x);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < g.size(); ++i) force -= g[i], moment -= board.x[i].cross(g[i]);
    EXPECT_LT(force.norm(), 1e-9) << "the particles bear the weight itself";
    const Vec3 expected = (board.plate.offset * normal).cross(weight);
    EXPECT_LT((moment - expected).norm(), 1e-9 + 1e-9 * expected.norm());
  }
}

}  // namespace
}  // namespace loosefit::fabric
