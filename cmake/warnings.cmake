add_library(loosefit_warnings INTERFACE)
target_compile_options(loosefit_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
# g++ 12 warns about its own std::string (GCC bugs 105651 and 105329), and from precompiled headers
# even though they are a system's.
target_compile_options(loosefit_warnings INTERFACE -Wno-restrict)
if(LOOSEFIT_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(loosefit_warnings INTERFACE -Winvalid-pch
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized)
endif()
if(LOOSEFIT_WERROR)
  target_compile_options(loosefit_warnings INTERFACE -Werror)
endif()
