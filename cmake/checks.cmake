# Tests that are not C++: the architecture check and the tests of the tools.
# Debian's own Python (3.11 has tomllib), not another one that comes first on PATH.
find_program(LOOSEFIT_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT LOOSEFIT_PYTHON)
  find_program(LOOSEFIT_PYTHON NAMES python3 REQUIRED)
endif()
add_test(NAME layers COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tools/check_layers.py)
add_test(NAME check_layers_test
  COMMAND ${LOOSEFIT_PYTHON} ${PROJECT_SOURCE_DIR}/tests/tools/check_layers_test.py)
