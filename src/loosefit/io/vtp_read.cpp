#include "loosefit/io/vtp_read.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/io/vtp_polydata.h"

namespace loosefit::io {
namespace {

// Earlier versions also took a residual [–] that was this much larger for rest, where the next
// Newton step moved no vertex farther [m] and turned 99 % of the normals by no more [rad].
constexpr double kToleranceWithLittleLeft = 0.02, kLeftToMove = 1e-4, kLeftToTurn = radians(0.2);

vtkDataArray* need(const std::filesystem::path& path, vtkFieldData* from, const char* name,
                   int components, vtkIdType tuples) {
  vtkDataArray* array = from->GetArray(name);
  const std::string shape = std::to_string(tuples) + " × " + std::to_string(components) + " values";
  if (!array) throw InvalidInput({path.string(), 0, name}, "nothing", "an array of " + shape);
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != tuples)
    throw InvalidInput({path.string(), 0, name},
                       std::to_string(array->GetNumberOfTuples()) + " × " +
                           std::to_string(array->GetNumberOfComponents()) + " values",
                       shape);
  return array;
}

std::vector<std::string> strings(const std::filesystem::path& path, vtkFieldData* from,
                                 const char* name) {
  auto* array = vtkStringArray::SafeDownCast(from->GetAbstractArray(name));
  if (!array) throw InvalidInput({path.string(), 0, name}, "nothing", "an array of texts");
  std::vector<std::string> values;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) values.push_back(array->GetValue(i));
  return values;
}

std::vector<int> panel_ids(const std::filesystem::path& path, vtkFieldData* from, vtkIdType tuples,
                           int panels) {
  vtkDataArray* array = need(path, from, "panel_id", 1, tuples);
  std::vector<int> ids(tuples);
  for (vtkIdType i = 0; i < tuples; ++i) {
    const double id = array->GetComponent(i, 0);
    if (!(id >= 0 && id < panels))
      throw InvalidInput({path.string(), 0, "panel_id"}, std::to_string(id),
                         "an index of the " + std::to_string(panels) + " panels");
    ids[i] = static_cast<int>(id);
  }
  return ids;
}

std::vector<VtpArray> others(vtkFieldData* from, const std::vector<std::string>& known) {
  std::vector<VtpArray> arrays;
  for (int a = 0; a < from->GetNumberOfArrays(); ++a) {
    vtkDataArray* array = from->GetArray(a);
    if (!array || !array->GetName()) continue;
    VtpArray copy{array->GetName(), array->GetNumberOfComponents(), {}};
    if (std::find(known.begin(), known.end(), copy.name) != known.end()) continue;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      for (int c = 0; c < copy.components; ++c) copy.values.push_back(array->GetComponent(i, c));
    arrays.push_back(std::move(copy));
  }
  return arrays;
}

}  // namespace

const VtpArray* DrapeFile::find(const std::string& name) const {
  for (const VtpArray& array : point_arrays)
    if (array.name == name) return &array;
  return nullptr;
}

DrapeFile read_drape_vtp(const std::filesystem::path& path) {
  const vtkSmartPointer<vtkPolyData> data = read_sealed_vtp(path, "drape.vtp");
  geometry::TriangleMesh surface = surface_of(path, data);

  // Topology and positions.
  DrapeFile file;
  file.garment.vertex_count = static_cast<int>(surface.vertices.size());
  file.garment.triangles = std::move(surface.triangles);
  file.drape.positions = std::move(surface.vertices);
  const vtkIdType points = data->GetNumberOfPoints();
  const auto cells = static_cast<vtkIdType>(file.garment.triangles.size());

  // What ties the mesh to its pattern; the flat area follows from it.
  garment::Garment& garment = file.garment;
  garment.panel_names = strings(path, data->GetFieldData(), "panel_names");
  const int panels = static_cast<int>(garment.panel_names.size());
  garment.vertex_panel = panel_ids(path, data->GetPointData(), points, panels);
  garment.triangle_panel = panel_ids(path, data->GetCellData(), cells, panels);
  vtkDataArray* uv = need(path, data->GetPointData(), "pattern_uv", 2, points);
  for (vtkIdType i = 0; i < points; ++i)
    garment.vertex_uv.emplace_back(uv->GetComponent(i, 0), uv->GetComponent(i, 1));
  vtkDataArray* corners = need(path, data->GetCellData(), "corner_uv", 6, cells);
  for (vtkIdType i = 0; i < cells; ++i) {
    std::array<Vec2, 3> triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = {corners->GetComponent(i, 2 * k), corners->GetComponent(i, 2 * k + 1)};
    garment.area += geometry::flat_area(triangle);
    garment.triangle_uv.push_back(triangle);
  }

  // The certificate, in the field data.
  drape::Certificate& certificate = file.drape.certificate;
  vtkDataArray* residual = need(path, data->GetFieldData(), "residual", 2, 1);
  certificate.residual = residual->GetComponent(0, 0);
  certificate.residual_max = residual->GetComponent(0, 1);
  vtkDataArray* crossings = need(path, data->GetFieldData(), "intersections", 1, 2);
  certificate.intersections_body = static_cast<int>(crossings->GetComponent(0, 0));
  certificate.intersections_self = static_cast<int>(crossings->GetComponent(1, 0));
  // Absent in early files.
  if (data->GetFieldData()->HasArray("folded_edges"))
    certificate.folded_edges = static_cast<int>(
        need(path, data->GetFieldData(), "folded_edges", 1, 1)->GetComponent(0, 0));
  if (data->GetFieldData()->HasArray("stable"))
    certificate.stable = need(path, data->GetFieldData(), "stable", 1, 1)->GetComponent(0, 0) != 0;
  if (data->GetFieldData()->HasArray("allowed_residual"))
    certificate.allowed_residual =
        need(path, data->GetFieldData(), "allowed_residual", 1, 1)->GetComponent(0, 0);
  if (data->GetFieldData()->HasArray("left_to_go")) {  // in early files
    vtkDataArray* left = need(path, data->GetFieldData(), "left_to_go", 2, 1);
    if (left->GetComponent(0, 0) <= kLeftToMove && left->GetComponent(0, 1) <= kLeftToTurn)
      certificate.allowed_residual = kToleranceWithLittleLeft;
  }
  const auto reason = strings(path, data->GetFieldData(), "stop_reason");
  if (!reason.empty()) certificate.stop_reason = reason.front();
  if (data->GetFieldData()->HasArray("worn_reasons"))  // absent in early files
    certificate.worn_reasons = strings(path, data->GetFieldData(), "worn_reasons");

  // The contact force, where the drape knew it, and whatever else is there.
  if (data->GetPointData()->HasArray("body_normal_force_N")) {
    vtkDataArray* force = need(path, data->GetPointData(), "body_normal_force_N", 1, points);
    for (vtkIdType i = 0; i < points; ++i)
      file.drape.body_normal_force.push_back(force->GetComponent(i, 0));
  }

  file.point_arrays =
      others(data->GetPointData(), {"Normals", "pattern_uv", "panel_id", "body_normal_force_N"});
  file.cell_arrays = others(data->GetCellData(), {"panel_id", "corner_uv"});
  return file;
}

geometry::TriangleMesh read_body_vtp(const std::filesystem::path& path) {
  return surface_of(path, read_sealed_vtp(path, "body.vtp"));
}

}  // namespace loosefit::io
