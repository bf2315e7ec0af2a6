#include "pattern_handle.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "beside_python.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/kinds/girths_along.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_pattern.h"
#include "loosefit/report/write_pattern.h"

namespace loosefit::python {
namespace {

using Self = const PatternHandle&;

/// Pieces of an edge's arc between two points of an array.
constexpr int kPieces = 64;

/// Points along an edge, even in arc length, ends included; backwards when asked.
std::vector<Vec2> along(const pattern::Panel& panel, int edge, bool backwards = false) {
  const pattern::EdgePath path(panel, edge);
  std::vector<Vec2> points;
  for (int i = 0; i <= kPieces; ++i)
    points.push_back(path.at(static_cast<double>(backwards ? kPieces - i : i) / kPieces));
  return points;
}

py::array matrix(const Mat3& m) {
  std::vector<double> rows;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) rows.push_back(m(r, c));
  return owned(std::move(rows)).reshape({3, 3});
}

py::list panels(Self self) {
  py::list result;
  for (const pattern::Panel& panel : self.pattern->panels) {
    const std::vector<Vec2> outline = pattern::outline_polygon(panel);
    py::dict edges;
    for (std::size_t e = 0; e < panel.edges.size(); ++e)
      edges[panel.edges[e].name.c_str()] = owned(along(panel, static_cast<int>(e)));
    py::dict entry;
    entry["name"] = panel.name;
    entry["part"] = panel.part;
    py::dict holes;
    for (const pattern::PanelHole& hole : panel.holes)
      holes[hole.name.c_str()] = owned(hole.points);
    entry["area_m2"] = pattern::cloth_area(panel);
    entry["outline"] = owned(outline);
    entry["holes"] = holes;
    entry["edges"] = edges;
    entry["translation"] = owned(std::vector<double>(
        panel.translation.data(), panel.translation.data() + panel.translation.size()));
    entry["rotation"] = matrix(panel.rotation);
    result.append(entry);
  }
  return result;
}

py::list seams(Self self) {
  py::list result;
  for (const pattern::Stitch& stitch : self.pattern->stitches) {
    const pattern::Panel& first = self.pattern->panels[stitch.first.panel];
    const pattern::Panel& second = self.pattern->panels[stitch.second.panel];
    py::dict entry;
    entry["name"] = stitch.name;
    entry["first_panel"] = first.name;
    entry["first_edge"] = first.edges[stitch.first.edge].name;
    entry["second_panel"] = second.name;
    entry["second_edge"] = second.edges[stitch.second.edge].name;
    entry["first"] = owned(along(first, stitch.first.edge));
    // Right to right, the end of one edge meets the start of the other.
    entry["second"] = owned(along(second, stitch.second.edge, !stitch.right_wrong));
    entry["first_length_m"] = pattern::EdgePath(first, stitch.first.edge).length();
    entry["second_length_m"] = pattern::EdgePath(second, stitch.second.edge).length();
    result.append(entry);
  }
  return result;
}

py::list fit(Self self) {
  py::list rows;
  for (const kinds::FitLevel& level : self.levels) {
    py::dict entry;
    entry["level"] = level.name;
    entry["garment_m"] = level.garment;
    entry["body_m"] = level.body;
    entry["mobility"] = level.body && *level.body > 0
                            ? std::optional(level.garment / *level.body - 1)
                            : std::nullopt;
    rows.append(entry);
  }
  return rows;
}

PatternHandle make_pattern(const scenario::Scenario& scenario, const py::object& progress,
                           const CancelToken* cancel) {
  PatternHandle made;
  beside_python(progress, cancel, [&](Progress& told) {
    try {
      told.stage("body");
      const pipeline::CaseBody body = pipeline::make_body(scenario.body, &told);
      told.check_cancelled();
      told.stage("pattern");
      pipeline::CasePattern of_case = pipeline::make_pattern(
          scenario.studied().spec, body.body, kinds::girths_along(body.path(0).body()));
      made.pattern = std::make_shared<const pattern::Pattern>(std::move(of_case.pattern));
      made.levels = std::move(of_case.levels);
      made.warnings = std::move(of_case.warnings);
    } catch (const InvalidInput& error) {
      throw io::in_scenario(error, scenario);
    }
  });
  return made;
}

}  // namespace

void bind_pattern(py::module_& core) {
  py::class_<PatternHandle>(core, "Pattern")
      .def("name", [](Self self) { return self.pattern->name; })
      .def("kind", [](Self self) { return self.pattern->kind; })
      .def("panels", panels)
      .def("seams", seams)
      .def("fit", fit)
      .def("warnings", [](Self self) { return self.warnings; })
      .def(
          "write",
          [](Self self, const std::filesystem::path& folder) {
            const py::gil_scoped_release release;
            report::write_pattern(folder, *self.pattern);
          },
          py::arg("folder"));
  core.def("make_pattern", make_pattern, py::arg("scenario"), py::arg("progress"),
           py::arg("cancel"));
}

}  // namespace loosefit::python
