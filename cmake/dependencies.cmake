# Why each is here: docs/dependencies.md. Every GPL library sits behind one source file.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)

add_library(loosefit_cgal INTERFACE)
find_path(CGAL_INCLUDE_DIR CGAL/version.h REQUIRED)
target_include_directories(loosefit_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_link_libraries(loosefit_cgal INTERFACE gmp mpfr)

add_library(loosefit_cholmod INTERFACE)
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
target_include_directories(loosefit_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(loosefit_cholmod INTERFACE ${CHOLMOD_LIBRARY} gomp TBB::tbb)

# Kernels are chosen while running (solver/linear/multifrontal/choose_kernels.h). LOOSEFIT_OWN_BLAS
# puts a serial BLAS into each binary, hidden from whatever else the process has loaded; its drapes
# differ in the last bits from those with the system's library (docs/decisions/0014).
option(LOOSEFIT_OWN_BLAS "Link a serial OpenBLAS into each binary" OFF)
if(LOOSEFIT_OWN_BLAS)
  find_library(LOOSEFIT_SERIAL_BLAS NAMES libopenblas.a NO_DEFAULT_PATH REQUIRED
    PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/openblas-serial)
  set(LOOSEFIT_OPENBLAS ${LOOSEFIT_SERIAL_BLAS})
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
target_link_libraries(loosefit_vtk_render INTERFACE ${loosefit_vtk_targets} X11::X11 OpenGL::GLX)
