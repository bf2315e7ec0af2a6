#include "worn_handle.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "loosefit/base/error.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/maps/catalogue.h"
#include "pattern_handle.h"

namespace loosefit::python {
namespace {

using Self = const WornHandle&;

int checked_index(int index, std::size_t count) {
  const int size = static_cast<int>(count);
  if (index < -size || index >= size) throw py::index_error("no such garment");
  return index < 0 ? index + size : index;
}

/// (m, 3, 2) pattern coordinates of the corners of triangles.
py::array corner_uv(Self self) {
  const auto& corners = self.garment->mesh().triangle_uv;
  static_assert(sizeof(corners[0]) == 6 * sizeof(double));
  return shown(reinterpret_cast<const double*>(corners.data()),
               {static_cast<py::ssize_t>(corners.size()), 3, 2}, self.result);
}

py::list maps(Self self) {
  py::list result;
  if (!self.maps) return result;
  for (const pipeline::CaseMap& entry : *self.maps) {
    const maps::PerformanceMap& map = entry.map;
    const maps::MapArray* known = maps::find_map_array(map.array);
    py::dict row;
    row["name"] = map.array;
    row["title"] = map.title;
    row["unit"] = map.unit;
    row["range"] = py::make_tuple(map.range_low, map.range_high);
    row["diverging"] = map.diverging;
    row["meaning"] = known ? known->meaning : "";
    row["formula"] = known ? known->formula : "";
    row["values"] = shown(map.values, self.result);
    result.append(row);
  }
  return result;
}

PatternHandle pattern_of(Self self) {
  const pipeline::CasePattern& pattern = self.garment->pattern;
  return {{self.result, &pattern.pattern}, pattern.levels, pattern.warnings};
}

}  // namespace

WornHandle worn_in_reference(std::shared_ptr<const pipeline::CaseResult> result, int garment) {
  const pipeline::CaseGarment& of =
      result->garments[checked_index(garment, result->garments.size())];
  return {std::move(result), &of, &of.drape, &of.maps.maps};
}

WornHandle worn_in_state(std::shared_ptr<const pipeline::CaseResult> result, int state,
                         int garment) {
  const pipeline::CaseState& of = result->wear.states.at(state);
  if (!of.draped()) throw Error("there is no drape of this state: " + of.left_out);
  const int g = checked_index(garment, result->garments.size());
  const pipeline::CaseGarment& cut = result->garments[g];
  const bool studied = &cut == &result->studied();
  return {std::move(result), &cut, &of.drapes[g], studied ? &of.maps.maps : nullptr};
}

void bind_worn(py::module_& core) {
  py::class_<WornHandle>(core, "Worn")
      .def("vertices", [](Self self) { return shown(self.drape->positions, self.result); })
      .def("triangles",
           [](Self self) { return shown(self.garment->mesh().triangles, self.result); })
      .def("normals",
           [](Self self) {
             return owned(
                 geometry::vertex_normals(self.drape->positions, self.garment->mesh().triangles));
           })
      .def("pattern_uv",
           [](Self self) { return shown(self.garment->mesh().vertex_uv, self.result); })
      .def("panel_id",
           [](Self self) { return shown(self.garment->mesh().vertex_panel, self.result); })
      .def("triangle_panel_id",
           [](Self self) { return shown(self.garment->mesh().triangle_panel, self.result); })
      .def("panel_names", [](Self self) { return self.garment->mesh().panel_names; })
      .def("corner_uv", corner_uv)
      .def("mass_kg",
           [](Self self) { return shown(self.garment->mesh().vertex_mass, self.result); })
      .def("body_normal_force_N",
           [](Self self) { return shown(self.drape->body_normal_force, self.result); })
      .def("maps", maps)
      .def("pattern", pattern_of);
}

}  // namespace loosefit::python
