#pragma once
#include <unistd.h>

#include <cstdlib>

namespace loosefit {

/// OpenBLAS reads its settings while it is loaded: starts the program over with those that the
/// command line program runs with, one thread and wide kernels where the processor has them.
inline void pin_blas(char** arguments) {
  if (std::getenv("LOOSEFIT_BENCH_PINNED")) return;
  setenv("LOOSEFIT_BENCH_PINNED", "1", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    setenv("OPENBLAS_CORETYPE", "SkylakeX", 0);
  execv("/proc/self/exe", arguments);  // returns only when it fails; then go on as we are
}

}  // namespace loosefit
