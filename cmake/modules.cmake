# One static library per folder of src/loosefit, its sub-folders included, and one test binary per
# folder of tests.
# COLD: hardly any of a run's time is spent there.
# The arrows between modules are declared here once; tools/check_layers.py compares them with the includes.

function(loosefit_module name)
  cmake_parse_arguments(ARG "COLD" "" "USES;LIBRARIES;TEST_USES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/loosefit/${name}/*.cpp)
  set_property(GLOBAL APPEND PROPERTY LOOSEFIT_MODULES loosefit_${name})
  if(sources)
    add_library(loosefit_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(loosefit_${name} PRIVATE loosefit_warnings)
    if(ARG_COLD)
      loosefit_cold(loosefit_${name})
      loosefit_precompile(loosefit_${name} REUSE_FROM loosefit_io)
    else()
      loosefit_precompile(loosefit_${name} REUSE_FROM loosefit_base)
    endif()
    loosefit_unite(loosefit_${name} ${sources})
  else()
    add_library(loosefit_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(loosefit_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(loosefit_${name} ${scope} Eigen3::Eigen ${ARG_LIBRARIES})
  foreach(used ${ARG_USES})
    target_link_libraries(loosefit_${name} ${scope} loosefit_${used})
  endforeach()

  file(GLOB_RECURSE tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  if(LOOSEFIT_TESTS AND tests)
    add_executable(test_${name} ${tests})
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(test_${name} PRIVATE loosefit_${name} loosefit_warnings GTest::gtest_main)
    foreach(used ${ARG_TEST_USES}) # modules above this one that its tests take examples from
      target_link_libraries(test_${name} PRIVATE loosefit_${used})
    endforeach()
    target_compile_definitions(test_${name} PRIVATE
      LOOSEFIT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" LOOSEFIT_BINARY="${CMAKE_BINARY_DIR}/bin/loosefit")
    loosefit_precompile(test_${name} REUSE_FROM test_base ALSO <gtest/gtest.h>)
    loosefit_cold(test_${name})
    loosefit_unite(test_${name} ${tests})
    gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${name} TIMEOUT 600
      ENVIRONMENT OPENBLAS_NUM_THREADS=1)
  endif()
endfunction()
