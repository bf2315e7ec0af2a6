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
set_source_files_properties(src/loosefit/base/paths.cpp PROPERTIES COMPILE_DEFINITIONS
  "LOOSEFIT_SOURCE_DIR=\"${PROJECT_SOURCE_DIR}\"")
