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

# Compiles the sources of a target in groups. tools/unity_groups.py chooses them when CMake runs, and
# writes the file of a group anew when a source of it has changed.
function(loosefit_unite target)
  if(NOT LOOSEFIT_UNITY)
    return()
  endif()
  set(script ${PROJECT_SOURCE_DIR}/tools/unity_groups.py)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  set(sources "")
  foreach(source ${ARGN})
    get_source_file_property(own_definitions ${source} COMPILE_DEFINITIONS)
    if(NOT own_definitions)
      get_filename_component(source ${source} ABSOLUTE)
      list(APPEND sources ${source})
    endif()
  endforeach()
  execute_process(COMMAND ${LOOSEFIT_PYTHON} ${script} group ${sources}
    OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[0-9]+ [^\n]+" lines "${lines}")
  foreach(line ${lines})
    string(REGEX MATCH "^([0-9]+) (.+)$" line "${line}")
    list(APPEND groups ${CMAKE_MATCH_1})
    list(APPEND group_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endforeach()
  list(REMOVE_DUPLICATES groups)
  foreach(group ${groups})
    list(LENGTH group_${group} length)
    if(length EQUAL 1)
      continue()
    endif()
    set(united ${CMAKE_CURRENT_BINARY_DIR}/united/${target}_${group}.cpp)
    add_custom_command(OUTPUT ${united} DEPENDS ${group_${group}} ${script} VERBATIM
      COMMAND ${LOOSEFIT_PYTHON} ${script} write ${united} ${group_${group}}
      COMMENT "Uniting ${length} files of ${target}")
    target_sources(${target} PRIVATE ${united})
    set_source_files_properties(${group_${group}} PROPERTIES HEADER_FILE_ONLY ON)
  endforeach()
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
