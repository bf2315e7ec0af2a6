#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <random>

#include "loosefit/particles/block_gather.h"
#include "loosefit/particles/particle_gather.h"

namespace loosefit::particles {
namespace {

constexpr int kParticles = 700;

/// Random element blocks, some of them missing, and what they are.
struct Blocks {
  std::vector<std::array<int, 2>> pairs;
  std::vector<Mat3> blocks;
};

Blocks random_blocks() {
  std::mt19937 rng(3);
  std::uniform_int_distribution<int> particle(0, kParticles - 1), near(-9, 9);
  std::uniform_real_distribution<double> u(-1, 1);
  Blocks b;
  for (int k = 0; k < 20000; ++k) {
    const int i = particle(rng), j = std::clamp(i + near(rng), 0, kParticles - 1);
    b.pairs.push_back(k % 50 ? std::array{i, j} : std::array{-1, -1});
    Mat3 m;
    for (double& entry : m.reshaped()) entry = u(rng);
    b.blocks.push_back(i == j ? Mat3(m + m.transpose()) : m);
  }
  return b;
}

BlockMatrix matrix_for(const BlockGather& gather, bool wider) {
  BlockPattern pattern(kParticles + 3);
  gather.add_pattern(pattern);
  if (wider)
    for (int i = 0; i + 30 < kParticles; ++i) pattern.add(i, i + 30);
  pattern.compress();
  return BlockMatrix(pattern);
}

TEST(BlockGather, AddsWhatBlockMatrixAdds) {
  const Blocks b = random_blocks();
  const BlockGather gather(b.pairs);
  for (bool wider : {false, true, false}) {  // another pattern, another place for each block
    BlockMatrix fast = matrix_for(gather, wider), slow = fast;
    gather.add(b.blocks, fast);
    gather.add(b.blocks, fast);
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t k = 0; k < b.pairs.size(); ++k)
        if (b.pairs[k][0] >= 0) slow.add(b.pairs[k][0], b.pairs[k][1], b.blocks[k]);
    for (std::size_t k = 0; k < slow.blocks().size(); ++k)
      EXPECT_LT((fast.blocks()[k] - slow.blocks()[k]).norm(), 1e-12);
  }
}

TEST(ParticleGather, AddsTheForcesOfEachParticleInOrder) {
  std::mt19937 rng(5);
  std::uniform_int_distribution<int> particle(-1, kParticles - 1);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<int> of;
  std::vector<Vec3> force;
  for (int k = 0; k < 9000; ++k) {
    of.push_back(particle(rng));
    force.emplace_back(u(rng), u(rng), u(rng));
  }
  VectorField fast(kParticles + 5, Vec3::Zero()), slow = fast;
  ParticleGather(of).add(force, fast);
  for (std::size_t k = 0; k < of.size(); ++k)
    if (of[k] >= 0) slow[of[k]] += force[k];
  for (std::size_t i = 0; i < slow.size(); ++i) EXPECT_EQ(fast[i], slow[i]) << i;
}

TEST(Gather, GivesTheSameBitsWithOneThread) {
  const Blocks b = random_blocks();
  const BlockGather gather(b.pairs);
  BlockMatrix many = matrix_for(gather, false), one = many;
  gather.add(b.blocks, many);
  {
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    gather.add(b.blocks, one);
  }
  for (std::size_t k = 0; k < one.blocks().size(); ++k)
    EXPECT_EQ(many.blocks()[k], one.blocks()[k]);
}

}  // namespace
}  // namespace loosefit::particles
