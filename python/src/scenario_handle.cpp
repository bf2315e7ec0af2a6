#include "scenario_handle.h"

#include <pybind11/stl/filesystem.h>

#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "table_of_python.h"

namespace loosefit::python {

namespace py = pybind11;

void bind_scenario(py::module_& core) {
  py::class_<scenario::Scenario>(core, "Scenario")
      .def_static(
          "of_mapping",
          [](const py::object& mapping) { return io::scenario_of(table_of_python(mapping), ""); },
          py::arg("mapping"))
      .def_static(
          "of_text", [](const std::string& text) { return io::parse_scenario(text, ""); },
          py::arg("text"))
      .def_static(
          "of_file",
          [](const std::filesystem::path& path) { return io::read_scenario(path.string()); },
          py::arg("path"))
      .def("toml", [](const scenario::Scenario& self) { return io::scenario_toml(self); });
}

}  // namespace loosefit::python
