# The version has one home, project() in CMakeLists.txt; what is cited and the change log follow it.
foreach(file CITATION.cff CHANGELOG.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
endforeach()
file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff loosefit_cited REGEX "^version: ")
if(NOT loosefit_cited STREQUAL "version: ${PROJECT_VERSION}")
  message(FATAL_ERROR "CITATION.cff: found \"${loosefit_cited}\", expected \"version: ${PROJECT_VERSION}\"")
endif()
file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md loosefit_changes REGEX "^## \\[[0-9]" LIMIT_COUNT 1)
if(NOT loosefit_changes MATCHES "^## \\[${PROJECT_VERSION}\\]")
  message(FATAL_ERROR "CHANGELOG.md: found \"${loosefit_changes}\" as latest, expected ${PROJECT_VERSION}")
endif()

# What `loosefit version` and summary.json report, read where each library states it.
file(STRINGS ${CGAL_INCLUDE_DIR}/CGAL/version.h cgal_line REGEX "define CGAL_VERSION [0-9]")
string(REGEX REPLACE ".*CGAL_VERSION ([0-9.]+).*" "\\1" loosefit_cgal_version "${cgal_line}")

set(cholmod_header ${CHOLMOD_INCLUDE_DIR}/cholmod.h)
if(EXISTS ${CHOLMOD_INCLUDE_DIR}/cholmod_core.h) # SuiteSparse before 6
  set(cholmod_header ${CHOLMOD_INCLUDE_DIR}/cholmod_core.h)
endif()
set(loosefit_cholmod_version "")
foreach(part MAIN SUB SUBSUB)
  file(STRINGS ${cholmod_header} cholmod_line REGEX "define CHOLMOD_${part}_VERSION [0-9]")
  string(REGEX REPLACE ".*VERSION ([0-9]+).*" "\\1" number "${cholmod_line}")
  string(APPEND loosefit_cholmod_version ".${number}")
endforeach()
string(SUBSTRING "${loosefit_cholmod_version}" 1 -1 loosefit_cholmod_version)

set_source_files_properties(src/loosefit/base/version.cpp PROPERTIES COMPILE_DEFINITIONS
  "LOOSEFIT_VERSION=\"${PROJECT_VERSION}\";LOOSEFIT_CGAL_VERSION=\"${loosefit_cgal_version}\";LOOSEFIT_CHOLMOD_VERSION=\"${loosefit_cholmod_version}\";LOOSEFIT_VTK_VERSION=\"${VTK_VERSION}\";LOOSEFIT_TBB_VERSION=\"${TBB_VERSION}\"")
# Programs of the build folder find the data of the source tree; a package names no folder of the
# machine that made it.
if(LOOSEFIT_PACKAGE)
  set(loosefit_told_source "${CMAKE_INSTALL_PREFIX}/share/loosefit")
else()
  set(loosefit_told_source "${PROJECT_SOURCE_DIR}")
endif()
set_source_files_properties(src/loosefit/base/paths.cpp PROPERTIES COMPILE_DEFINITIONS
  "LOOSEFIT_SOURCE_DIR=\"${loosefit_told_source}\";LOOSEFIT_INSTALL_PREFIX=\"${CMAKE_INSTALL_PREFIX}\"")
