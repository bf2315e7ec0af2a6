#include "loosefit/solver/pin_blas.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace loosefit::solver {
namespace {

/// Null: let OpenBLAS choose, as it is for other processors. Debian 12's does not use the AVX-512
/// of newer Intel processors unless it is named; on AMD's a factor at 14 mm takes 15.5 ms with its
/// AVX-512 kernels and 12.5 ms with those for AVX2 (EPYC of 2023).
const char* fastest_kernels() {
#if defined(__x86_64__)
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  if (avx512 && __builtin_cpu_is("intel")) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

}  // namespace

void pin_blas(char** arguments) {
  const char* threads = std::getenv("OPENBLAS_NUM_THREADS");
  const char* kernels = std::getenv("OPENBLAS_CORETYPE") ? nullptr : fastest_kernels();
  if (threads && std::strcmp(threads, "1") == 0 && !kernels) return;
  if (setenv("OPENBLAS_NUM_THREADS", "1", 1) != 0 ||
      (kernels && setenv("OPENBLAS_CORETYPE", kernels, 0) != 0))
    return;                            // out of memory, and starting over would not end
  execv("/proc/self/exe", arguments);  // returns only when it fails; then go on as we are
}

}  // namespace loosefit::solver
