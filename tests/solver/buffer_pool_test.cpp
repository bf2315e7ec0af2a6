#include "loosefit/solver/linear/multifrontal/buffer_pool.h"

#include <gtest/gtest.h>

namespace loosefit::solver {
namespace {

using Pool = BufferPool<float>;

TEST(BufferPool, LendsWhatCameBackWhereItFits) {
  Pool pool;
  Pool::Buffer buffer = pool.take(100000);
  float* const array = buffer.get();
  buffer.reset();
  EXPECT_EQ(buffer.get(), nullptr);
  EXPECT_EQ(pool.take(90000).get(), array);
  EXPECT_NE(pool.take(200000).get(), array);  // too small
  EXPECT_NE(pool.take(1000).get(), array);    // a waste
  EXPECT_EQ(pool.take(100000).get(), array);  // each of the loans ended with its line
}

TEST(BufferPool, HandsALoanOverAndTakesTheOldOneBack) {
  Pool pool;
  Pool::Buffer a = pool.take(10), b = pool.take(10);
  float *const of_a = a.get(), *const of_b = b.get();
  EXPECT_NE(of_a, of_b);
  a = std::move(b);
  EXPECT_EQ(a.get(), of_b);
  EXPECT_EQ(pool.take(10).get(), of_a);
}

TEST(BufferPool, LoansOutlastARelease) {
  Pool pool;
  Pool::Buffer kept = pool.take(10);
  pool.take(20).reset();
  pool.release();
  kept.get()[9] = 1;
  float* const array = kept.get();
  kept.reset();
  EXPECT_EQ(pool.take(10).get(), array);
}

}  // namespace
}  // namespace loosefit::solver
