#include "loosefit/base/version.h"

#include <fmt/format.h>

#include <Eigen/Core>

#include "loosefit/base/build_id.h"

namespace loosefit {

std::string version() { return LOOSEFIT_VERSION; }

std::map<std::string, std::string> versions() {
  return {{"loosefit", LOOSEFIT_VERSION},
          {"build", build_id()},
          {"compiler", "g++ " __VERSION__},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"cholmod", LOOSEFIT_CHOLMOD_VERSION},
          {"cgal", LOOSEFIT_CGAL_VERSION},
          {"vtk", LOOSEFIT_VTK_VERSION},
          {"tbb", LOOSEFIT_TBB_VERSION}};
}

}  // namespace loosefit
