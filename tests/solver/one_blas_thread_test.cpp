#include "loosefit/solver/one_blas_thread.h"

#include <gtest/gtest.h>

extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int count);
}

namespace loosefit::solver {
namespace {

TEST(OneBlasThread, TheLastOneGivesBackWhatTheFirstOneFound) {
  const int before = openblas_get_num_threads();
  openblas_set_num_threads(2);
  const int allowed = openblas_get_num_threads();  // fewer where there are fewer processors
  {
    const OneBlasThread outer;
    EXPECT_EQ(openblas_get_num_threads(), 1);
    {
      const OneBlasThread inner;
    }
    EXPECT_EQ(openblas_get_num_threads(), 1);
  }
  EXPECT_EQ(openblas_get_num_threads(), allowed);
  openblas_set_num_threads(before);
}

}  // namespace
}  // namespace loosefit::solver
