#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "beside_python.h"
#include "body_handle.h"
#include "case_handle.h"
#include "errors.h"
#include "loosefit/base/version.h"
#include "pattern_handle.h"
#include "ranking_handle.h"
#include "scenario_handle.h"
#include "worn_handle.h"

// What the package loosefit is made of. Users see its Python classes, which say what everything is.
PYBIND11_MODULE(_core, core) {
  using namespace loosefit::python;
  namespace py = pybind11;
  register_errors();
  py::class_<CancelToken>(core, "CancelToken", "Asks work to stop, from any thread.")
      .def(py::init<>())
      .def("cancel", &CancelToken::cancel, "The work ends with Cancelled, mostly within a second.")
      .def_property_readonly("cancelled", &CancelToken::cancelled, "Whether cancel() was called.");
  bind_scenario(core);
  bind_body(core);
  bind_pattern(core);
  bind_worn(core);
  bind_case(core);
  bind_ranking(core);
  core.def("version", &loosefit::version);
  core.def("versions", &loosefit::versions,
           "Loosefit, the compiler and the libraries it was built with: name to version.");
}
