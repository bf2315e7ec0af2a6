# What makes a build from nothing short (docs/architecture.md, "Building"). Most of the time would
# otherwise go into reading the same external headers hundreds of times.

# Debian's own Python (3.11 has tomllib), not another one that comes first on PATH.
find_program(LOOSEFIT_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT LOOSEFIT_PYTHON)
  find_program(LOOSEFIT_PYTHON NAMES python3 REQUIRED)
endif()

option(LOOSEFIT_PRECOMPILE "Read the external headers once (precompiled headers)" ON)

option(LOOSEFIT_UNITY "Compile several files of a module as one" OFF)

# The external headers that most files read. They change with the machine, never with the sources,
# so that no edit of ours makes them be compiled again.
set(LOOSEFIT_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional>
  <limits> <map> <memory> <numeric> <optional> <set> <string> <utility> <vector>
  <Eigen/Geometry> <fmt/format.h>)

# Each file still names what it uses: presets debug and asan compile without.
function(loosefit_precompile target)
  cmake_parse_arguments(ARG "" "REUSE_FROM" "ALSO" ${ARGN})
  if(NOT LOOSEFIT_PRECOMPILE)
    return()
  endif()
  if(ARG_REUSE_FROM AND NOT ARG_REUSE_FROM STREQUAL target)
    target_precompile_headers(${target} REUSE_FROM ${ARG_REUSE_FROM})
  else()
    target_precompile_headers(${target} PRIVATE ${LOOSEFIT_COMMON_HEADERS} ${ARG_ALSO})
  endif()
endfunction()

# Compiles what takes no time when it runs with fewer optimisations: a third less work for the
# compiler. Results do not change, for arithmetic may not be reordered or contracted in any case.
function(loosefit_cold target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# Compiles the sources of a target in groups; tools/unity_groups.py chooses them when CMake runs.
function(loosefit_unite target)
  if(NOT LOOSEFIT_UNITY)
    return()
  endif()
  execute_process(COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tools/unity_groups.py
    ${CMAKE_CURRENT_SOURCE_DIR} ${ARGN} OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[0-9]+ [^\n]+" groups "${groups}")
  foreach(line ${groups})
    string(REGEX MATCH "^([0-9]+) (.+)$" line "${line}")
    set_source_files_properties(${CMAKE_MATCH_2} PROPERTIES UNITY_GROUP ${target}_${CMAKE_MATCH_1})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Headers take 150 MB in the compiler; collecting garbage among them is a tenth of its time.
  add_compile_options(--param=ggc-min-expand=1000 --param=ggc-min-heapsize=600000)
endif()

# A cache serves every checkout (base_dir), asks the compiler for what a file depended on instead
# of preprocessing it once more (depend), and can follow precompiled headers (sloppiness).
find_program(CCACHE ccache)
find_program(LOOSEFIT_ENV env)
if(CCACHE AND LOOSEFIT_ENV AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${LOOSEFIT_ENV} CCACHE_DEPEND=1 CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
  if(LOOSEFIT_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()
