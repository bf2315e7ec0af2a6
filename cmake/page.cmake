# The interactive part of reports (web/), built with npm and Vite and embedded into module `report`.
set(loosefit_page ${PROJECT_BINARY_DIR}/page)
file(GLOB loosefit_page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/*.ts
  ${PROJECT_SOURCE_DIR}/web/src/*.css)
if(LOOSEFIT_TESTS)
  set(loosefit_page_tools tests)
else()
  set(loosefit_page_tools program)
endif()
add_custom_command(OUTPUT ${loosefit_page}/page.js ${loosefit_page}/page.css
  ${loosefit_page}/page_stamp.h
  COMMAND ${PROJECT_SOURCE_DIR}/tools/build_page.sh ${loosefit_page} ${loosefit_page_tools}
  DEPENDS ${loosefit_page_sources} ${PROJECT_SOURCE_DIR}/web/package.json
    ${PROJECT_SOURCE_DIR}/web/package-lock.json ${PROJECT_SOURCE_DIR}/web/vite.config.js
    ${PROJECT_SOURCE_DIR}/web/.npmrc ${PROJECT_SOURCE_DIR}/tools/build_page.sh
  COMMENT "Building the interactive page of reports (web/)" VERBATIM)
# Its assembler text names the two files.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/loosefit/report/page_bundle.cpp PROPERTIES
  OBJECT_DEPENDS "${loosefit_page}/page.js;${loosefit_page}/page.css;${loosefit_page}/page_stamp.h"
  COMPILE_DEFINITIONS "LOOSEFIT_PAGE_DIR=\"${loosefit_page}\";LOOSEFIT_PAGE_STAMP=\"${loosefit_page}/page_stamp.h\""
  SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
