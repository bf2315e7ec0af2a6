# The program is built where it runs: where that processor has AVX2, all of it is compiled for it
# (x86-64-v3), a tenth faster. -DLOOSEFIT_PORTABLE=ON makes one that runs on any x86-64.

include(CheckCXXSourceRuns)
if(CMAKE_CROSSCOMPILING)
  set(LOOSEFIT_HAS_AVX2 OFF)
endif()
check_cxx_source_runs("int main() { return !__builtin_cpu_supports(\"x86-64-v3\"); }"
  LOOSEFIT_HAS_AVX2)
if(LOOSEFIT_HAS_AVX2 AND NOT LOOSEFIT_PORTABLE)
  add_compile_options(-march=x86-64-v3)
endif()
# The same bits from the same build: no contraction that depends on the optimiser's mood.
add_compile_options(-ffp-contract=off -fno-math-errno)
# Results of studies tell by it which build made them (base/build_id.h).
add_link_options(LINKER:--build-id=sha1)
# Functions of a static library are inlined although it could become part of a shared one.
add_compile_options(-fno-semantic-interposition)
