# Why each is here: docs/dependencies.md. Every GPL library sits behind one source file.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)
find_package(EXPAT REQUIRED)
find_package(SQLite3 REQUIRED)

add_library(loosefit_cgal INTERFACE)
find_path(CGAL_INCLUDE_DIR CGAL/version.h REQUIRED)
target_include_directories(loosefit_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_link_libraries(loosefit_cgal INTERFACE gmp mpfr)

add_library(loosefit_cholmod INTERFACE)
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
target_include_directories(loosefit_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(loosefit_cholmod INTERFACE ${CHOLMOD_LIBRARY} gomp TBB::tbb)

# A copy of OpenBLAS in each binary, hidden from whatever else the process has loaded (a NumPy, say),
# so that its one thread and its kernels, which are chosen while running, are nobody else's
# (solver/linear/multifrontal/choose_kernels.h, docs/decisions/0014).
option(LOOSEFIT_OWN_BLAS "Link OpenBLAS into each binary" ON)
find_library(LOOSEFIT_BLAS_ARCHIVE NAMES libopenblas.a
  PATH_SUFFIXES openblas-pthread)
if(LOOSEFIT_OWN_BLAS AND LOOSEFIT_BLAS_ARCHIVE)
  set(LOOSEFIT_OPENBLAS ${LOOSEFIT_BLAS_ARCHIVE})
else()
  find_library(OPENBLAS_LIBRARY openblas REQUIRED)
  set(LOOSEFIT_OPENBLAS ${OPENBLAS_LIBRARY})
endif()
target_link_libraries(loosefit_cholmod INTERFACE ${LOOSEFIT_OPENBLAS})
target_link_options(loosefit_cholmod INTERFACE LINKER:--exclude-libs,libopenblas.a)

set(LOOSEFIT_VTK_IO_MODULES CommonCore CommonDataModel CommonExecutionModel IOXML)
set(LOOSEFIT_VTK_RENDER_MODULES ${LOOSEFIT_VTK_IO_MODULES} FiltersCore FiltersModeling IOImage
  RenderingCore RenderingOpenGL2 RenderingAnnotation RenderingFreeType InteractionStyle)
find_package(VTK 9.1 REQUIRED COMPONENTS ${LOOSEFIT_VTK_RENDER_MODULES})
add_library(loosefit_vtk_io INTERFACE)
target_link_libraries(loosefit_vtk_io INTERFACE VTK::CommonCore VTK::CommonDataModel VTK::IOXML)
add_library(loosefit_vtk_render INTERFACE)
list(TRANSFORM LOOSEFIT_VTK_RENDER_MODULES PREPEND VTK:: OUTPUT_VARIABLE loosefit_vtk_targets)
find_package(X11 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL GLX)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo cairo-pdf cairo-svg)
target_link_libraries(loosefit_vtk_render INTERFACE ${loosefit_vtk_targets} X11::X11 OpenGL::GLX
  PkgConfig::CAIRO ZLIB::ZLIB)
