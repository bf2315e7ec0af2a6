# `cmake --install`: the library with its CMake package, the programs, the data (docs/library.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# One shared library: whoever links it needs none of the libraries inside it, and its headers need
# the standard library only. Modules `base` and `library` are what it shows, so that errors and
# progress are the same types on both sides; the rest stays inside.
add_library(loosefit_shared SHARED
  $<TARGET_OBJECTS:loosefit_base> $<TARGET_OBJECTS:loosefit_library>)
set_target_properties(loosefit_shared PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME loosefit
  EXPORT_NAME loosefit VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_link_libraries(loosefit_shared PRIVATE loosefit_library)
set(inside "")
get_property(modules GLOBAL PROPERTY LOOSEFIT_MODULES)
foreach(module ${modules})
  string(APPEND inside ":lib${module}.a")
endforeach()
target_link_options(loosefit_shared PRIVATE
  LINKER:--exclude-libs,libopenblas.a${inside} LINKER:--no-undefined)
target_include_directories(loosefit_shared INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(loosefit_shared INTERFACE cxx_std_17)
add_library(loosefit::loosefit ALIAS loosefit_shared)

install(TARGETS loosefit_shared EXPORT loosefit COMPONENT library)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/loosefit)
install(FILES src/loosefit/loosefit.h DESTINATION ${headers} COMPONENT library)
foreach(header base/error base/paths base/progress base/version library/outcome library/run)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES src/loosefit/${header}.h DESTINATION ${headers}/${folder} COMPONENT library)
endforeach()
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/loosefit)
install(EXPORT loosefit NAMESPACE loosefit:: FILE loosefitTargets.cmake DESTINATION ${package}
  COMPONENT library)
configure_package_config_file(cmake/loosefitConfig.cmake.in
  ${PROJECT_BINARY_DIR}/loosefitConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/loosefitConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/loosefitConfig.cmake
  ${PROJECT_BINARY_DIR}/loosefitConfigVersion.cmake DESTINATION ${package} COMPONENT library)

set(data ${CMAKE_INSTALL_DATADIR}/loosefit)
install(DIRECTORY data/materials data/scorecards DESTINATION ${data} COMPONENT library)
install(TARGETS loosefit loosefit_bake COMPONENT program)
install(FILES validation/air_gap.csv DESTINATION ${data} COMPONENT program)
install(PROGRAMS tools/fetch_body_data.sh DESTINATION ${data} COMPONENT program)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT program)
install(FILES README.md CHANGELOG.md LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
