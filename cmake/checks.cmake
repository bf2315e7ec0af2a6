# Tests that are not C++: the checks of architecture and references and the tests of the tools.
add_test(NAME layers COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tools/check_layers.py)
add_test(NAME check_layers_test
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/check_layers_test.py)
add_test(NAME references COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tools/check_references.py)
add_test(NAME check_references_test
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/check_references_test.py)
add_test(NAME tools_bench_suite
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/bench_suite_test.py)
add_test(NAME tools_run_fuzz
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/run_fuzz_test.py)
add_test(NAME tools_validation_summary
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/validation_summary_test.py)
add_test(NAME harms2012_study
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/harms2012_test.py)
add_test(NAME tools_unity_groups
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/unity_groups_test.py)
add_test(NAME tools_paper_claims
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/paper_claims_test.py)
add_test(NAME library_outside_the_tree COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR}
  -DSOURCE=${PROJECT_SOURCE_DIR} -DWORK=${PROJECT_BINARY_DIR}/library_outside_the_tree
  -DBODY=${PROJECT_SOURCE_DIR}/var/body -DCOMPILER=${CMAKE_CXX_COMPILER}
  -P ${PROJECT_SOURCE_DIR}/tests/library/install_test.cmake)

add_test(NAME study_kills
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/study/kill_test.py $<TARGET_FILE:loosefit> --people 1 --kills 3)
set_tests_properties(study_kills PROPERTIES SKIP_RETURN_CODE 77)  # where no full disk can be made
add_test(NAME run_on_a_full_disk
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/cli/full_disk_test.py $<TARGET_FILE:loosefit>)
set_tests_properties(run_on_a_full_disk PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME study_read_only
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/study/read_only_test.py $<TARGET_FILE:loosefit>)
add_test(NAME study_names
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/study/names_test.py $<TARGET_FILE:loosefit>)
add_test(NAME scenario_keys
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tools/scenario_keys.py --binary $<TARGET_FILE:loosefit> --check)
add_test(NAME scenario_schema
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/scenario_schema_test.py $<TARGET_FILE:loosefit>)

# Tests that run the program: its command line, and damaged input.
foreach(name cli fuzz)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  add_executable(test_${name} ${tests})
  add_dependencies(test_${name} loosefit)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE loosefit_pipeline loosefit_warnings GTest::gtest_main)
  target_compile_definitions(test_${name} PRIVATE
    LOOSEFIT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" LOOSEFIT_BINARY="${CMAKE_BINARY_DIR}/bin/loosefit")
  loosefit_precompile(test_${name} REUSE_FROM test_base)
  loosefit_cold(test_${name})
  loosefit_unite(test_${name} ${tests})
  gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${name} TIMEOUT 900
    ENVIRONMENT OPENBLAS_NUM_THREADS=1)
endforeach()

# The report in a browser: one run on a coarse mesh, opened, probed and photographed.
find_program(LOOSEFIT_NODE node)
if(LOOSEFIT_NODE)
  add_test(NAME page_run COMMAND loosefit run ${PROJECT_SOURCE_DIR}/tests/web/page.toml
    -o ${loosefit_page}/run --quiet)
  set_tests_properties(page_run PROPERTIES FIXTURES_SETUP page TIMEOUT 300)
  add_test(NAME page_in_a_browser COMMAND ${LOOSEFIT_NODE} ${PROJECT_SOURCE_DIR}/tests/web/page_test.mjs
    ${loosefit_page}/run ${loosefit_page}/npm ${loosefit_page}/screenshots)
  add_test(NAME page_types COMMAND ${LOOSEFIT_NODE} ${loosefit_page}/npm/node_modules/typescript/bin/tsc
    -p ${loosefit_page}/npm)
  set_tests_properties(page_in_a_browser PROPERTIES FIXTURES_REQUIRED page TIMEOUT 300)
  add_test(NAME report_contradicts_nothing COMMAND ${LOOSEFIT_PYTHON}
    ${PROJECT_SOURCE_DIR}/tools/find_contradictions.py ${loosefit_page}/run)
  set_tests_properties(report_contradicts_nothing PROPERTIES FIXTURES_REQUIRED page)
endif()
