#include "loosefit/particles/dead_load.h"

#include <gtest/gtest.h>

namespace loosefit::particles {
namespace {

TEST(DeadLoad, ForcesAreThoseThatWereSetWhereverTheParticlesAre) {
  DeadLoad load;
  const VectorField forces = {Vec3(1, -2, 3), Vec3(0, 0, -5)};
  load.set_forces(forces);
  for (const double far : {0.0, 10.0}) {
    VectorField gradient(2, Vec3::Zero());
    load.add_gradient({Vec3(far, 1, 2), Vec3(3, far, 4)}, gradient);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(gradient[i], -forces[i]);
  }
}

TEST(DeadLoad, EnergyFallsByTheWorkDone) {
  DeadLoad load;
  load.set_forces({Vec3(0, 0, -5)});
  EXPECT_DOUBLE_EQ(load.value({Vec3(7, 8, 1)}) - load.value({Vec3(7, 8, 0.9)}), 5 * 0.1);
}

TEST(DeadLoad, LetGoItIsNothing) {
  DeadLoad load;
  load.set_forces({Vec3(1, 1, 1)});
  load.set_forces({});
  VectorField gradient(1, Vec3::Zero());
  load.add_gradient({Vec3(1, 2, 3)}, gradient);
  EXPECT_EQ(gradient[0], Vec3::Zero());
  EXPECT_EQ(load.value({Vec3(1, 2, 3)}), 0);
}

}  // namespace
}  // namespace loosefit::particles
