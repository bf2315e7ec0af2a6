#include "loosefit/particles/block_matrix.h"

#include <gtest/gtest.h>

#include "loosefit/base/check.h"

namespace loosefit::particles {
namespace {

BlockPattern triangle_of_four() {
  BlockPattern pattern(4);
  pattern.add(0, 2);
  pattern.add(1, 0);
  pattern.add(2, 1);
  return pattern;
}

TEST(BlockMatrix, HoldsTheLowerTriangleAndActsAsBoth) {
  BlockPattern pattern = triangle_of_four();
  pattern.compress();
  BlockMatrix m(pattern);
  EXPECT_EQ(m.blocks().size(), 7u);
  Mat3 block;
  block << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  m.add(0, 2, block);
  EXPECT_EQ(m.blocks()[m.slot(2, 0)], Mat3(block.transpose()));
  std::vector<Vec3> y(4, Vec3::Zero());
  m.add_product({Vec3::Zero(), Vec3::Zero(), Vec3(1, 0, 0), Vec3::Zero()}, y);
  EXPECT_EQ(y[0], Vec3(block.col(0)));
  m.add_product({Vec3(1, 0, 0), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, y);
  EXPECT_EQ(y[2], Vec3(block.row(0).transpose()));
}

TEST(BlockMatrix, TellsPatternsApart) {
  BlockPattern pattern = triangle_of_four(), other = triangle_of_four();
  pattern.compress();
  other.add(3, 0);
  other.compress();
  const BlockMatrix m(pattern);
  EXPECT_TRUE(m.same_pattern(pattern));
  EXPECT_FALSE(m.same_pattern(other));
  EXPECT_NE(BlockMatrix(pattern).pattern_id(), m.pattern_id());
}

#if LOOSEFIT_CHECKED
TEST(BlockMatrixDeathTest, RefusesABlockOutsideItsPatternAndAPatternThatIsNotCompressed) {
  BlockPattern pattern = triangle_of_four();
  EXPECT_DEATH(BlockMatrix{pattern}, "block_matrix.cpp:.*assertion failed");
  pattern.compress();
  BlockMatrix m(pattern);
  EXPECT_DEATH(m.add(3, 0, Mat3::Identity()), "block_matrix.h:.*assertion failed");
  EXPECT_DEATH(m.slot(3, 1), "block_matrix.h:.*assertion failed");
}
#endif

}  // namespace
}  // namespace loosefit::particles
