#include "loosefit/solver/linear/multifrontal/choose_kernels.h"

#include <cstdlib>
#include <mutex>
#include <string>

extern "C" {
// Of OpenBLAS built for several processors: forget the kernels chosen when it was loaded, and
// choose again. Weak: an OpenBLAS for one processor has neither.
void gotoblas_dynamic_quit() __attribute__((weak));
void gotoblas_dynamic_init() __attribute__((weak));
void openblas_set_num_threads(int count) __attribute__((weak));
/// What OpenBLAS does when it is loaded; only once.
void gotoblas_init() __attribute__((weak));
}

namespace loosefit::solver::dense {
namespace {

constexpr char kVariable[] = "OPENBLAS_CORETYPE";  ///< which OpenBLAS reads when it chooses

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

/// OpenBLAS starts its threads when it is loaded, and each maps work memory, again and again where
/// there is none. Our own copy starts here, before it would by itself, and is told of one thread.
[[gnu::constructor(101)]] void start_without_threads() {
  constexpr char kThreads[] = "OPENBLAS_NUM_THREADS";
  if (!gotoblas_init) return;
  const char* const found = std::getenv(kThreads);
  const std::string before = found ? found : "";
  if (setenv(kThreads, "1", 1) != 0) return;
  gotoblas_init();
  found ? setenv(kThreads, before.c_str(), 1) : unsetenv(kThreads);
}

}  // namespace

void choose_kernels() {
  static std::once_flag chosen;
  std::call_once(chosen, [] {
    // Fronts already use all cores, and sums must not depend on how many there are.
    if (openblas_set_num_threads) openblas_set_num_threads(1);
    const char* kernels = fastest_kernels();
    const bool named_by_user = std::getenv(kVariable) != nullptr;
    if (!kernels || named_by_user || !gotoblas_dynamic_quit || !gotoblas_dynamic_init) return;
    // OpenBLAS has no other way to be told.
    if (setenv(kVariable, kernels, 0) != 0) return;  // out of memory: its own choice serves, too
    gotoblas_dynamic_quit();
    gotoblas_dynamic_init();
    unsetenv(kVariable);
  });
}

}  // namespace loosefit::solver::dense
