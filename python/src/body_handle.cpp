#include "body_handle.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "beside_python.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/report/write_body.h"

namespace loosefit::python {
namespace {

using Self = const BodyHandle&;

/// enum class Segment as the numbers of body.vtp.
py::array segments(Self self) {
  static_assert(sizeof(body::Segment) == sizeof(int));
  return shown(reinterpret_cast<const int*>(self.body->segment.data()),
               {static_cast<py::ssize_t>(self.body->segment.size())}, self.body);
}

py::array normals(Self self) {
  if (!self.body->normals.empty()) return shown(self.body->normals, self.body);
  return owned(geometry::vertex_normals(self.body->surface.vertices, self.body->surface.triangles));
}

/// Name → (3,) point [m].
py::dict points(const std::map<std::string, Vec3>& named) {
  py::dict result;
  for (const auto& [name, point] : named)
    result[name.c_str()] = owned(std::vector<double>{point.x(), point.y(), point.z()});
  return result;
}

py::list asked(Self self) {
  py::list rows;
  for (const body::MeasureRow& row : self.fit.table) {
    py::dict entry;
    entry["name"] = row.name;
    entry["asked_m"] = row.asked;
    entry["measured_m"] = row.measured;
    rows.append(entry);
  }
  return rows;
}

BodyHandle make_body(const scenario::Scenario& scenario, const py::object& progress,
                     const CancelToken* cancel) {
  BodyHandle made;
  beside_python(progress, cancel, [&](Progress& told) {
    told.stage("body");
    try {
      pipeline::CaseBody of_case = pipeline::make_body(scenario.body, &told);
      made.body = shared_body(of_case.body);
      made.fit.table = std::move(of_case.asked);
      made.fit.warnings = std::move(of_case.warnings);
      made.fit.parameters = std::move(of_case.parameters);
    } catch (const InvalidInput& error) {
      throw io::in_scenario(error, scenario);
    }
  });
  return made;
}

}  // namespace

std::shared_ptr<const body::Body> shared_body(const body::PosedBody& posed) {
  const auto kept = std::make_shared<const body::PosedBody>(posed);
  return {kept, &kept->body()};
}

void bind_body(py::module_& core) {
  py::class_<BodyHandle>(core, "Body")
      .def("vertices", [](Self self) { return shown(self.body->surface.vertices, self.body); })
      .def("triangles", [](Self self) { return shown(self.body->surface.triangles, self.body); })
      .def("normals", normals)
      .def("segment", segments)
      .def("side", [](Self self) { return shown(self.body->side, self.body); })
      .def("measured", [](Self self) { return self.body->measured; })
      .def("landmarks", [](Self self) { return points(self.body->landmarks); })
      .def("joints", [](Self self) { return points(self.body->joints); })
      .def("asked", asked)
      .def("warnings", [](Self self) { return self.fit.warnings; })
      .def(
          "write",
          [](Self self, const std::filesystem::path& folder) {
            const py::gil_scoped_release release;
            report::write_body(folder, *self.body, self.fit);
          },
          py::arg("folder"));
  core.def("make_body", make_body, py::arg("scenario"), py::arg("progress"), py::arg("cancel"));
}

}  // namespace loosefit::python
