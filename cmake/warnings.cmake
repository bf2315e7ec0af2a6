add_library(loosefit_warnings INTERFACE)
target_compile_options(loosefit_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
# g++ 12 warns about its own std::string operator+ (GCC bug 105651).
target_compile_options(loosefit_warnings INTERFACE -Wno-restrict)
if(LOOSEFIT_WERROR)
  target_compile_options(loosefit_warnings INTERFACE -Werror)
endif()
