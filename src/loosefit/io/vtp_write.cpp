#include "loosefit/io/vtp_write.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp_seal.h"

namespace loosefit::io {
namespace {

void add_array(vtkFieldData* to, const std::string& name, int components,
               const std::vector<double>& values, std::size_t tuples) {
  if (values.size() != tuples * components)
    throw InvalidInput("array '" + name + "' has " + std::to_string(values.size()) +
                       " values, expected " + std::to_string(tuples * components));
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  to->AddArray(array);
}

void add_array(vtkFieldData* to, const std::string& name, const std::vector<int>& values) {
  vtkNew<vtkIntArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  to->AddArray(array);
}

void add_strings(vtkFieldData* to, const std::string& name,
                 const std::vector<std::string>& values) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  for (const std::string& value : values) array->InsertNextValue(value);
  to->AddArray(array);
}

/// "distance_mm: mm": one line per array that has a unit.
std::vector<std::string> units_of(const std::vector<maps::PerformanceMap>& maps) {
  std::vector<std::string> units = {"Points: m", "pattern_uv: m", "corner_uv: m",
                                    "body_normal_force_N: N"};
  for (const maps::PerformanceMap& map : maps)
    units.push_back(map.array + ": " + (map.unit == "–" ? "1" : map.unit));
  return units;
}

template <class Vec>
std::vector<double> flat(const std::vector<Vec>& points) {
  std::vector<double> values;
  values.reserve(points.size() * Vec::RowsAtCompileTime);
  for (const Vec& p : points) values.insert(values.end(), p.data(), p.data() + p.size());
  return values;
}

void set_surface(vtkPolyData* data, const std::vector<Vec3>& positions,
                 const std::vector<Triangle>& triangles, const std::vector<Vec3>& normals) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : positions) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : triangles)
    cells->InsertNextCell({vtkIdType{t[0]}, vtkIdType{t[1]}, vtkIdType{t[2]}});
  data->SetPoints(points);
  data->SetPolys(cells);
  add_array(data->GetPointData(), "Normals", 3, flat(normals), positions.size());
  data->GetPointData()->SetActiveNormals("Normals");
}

/// Through memory, so that every failing write is seen and named.
void write(const std::filesystem::path& path, vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);  // numbers hardly shrink with more
  writer->SetHeaderTypeToUInt64();
  writer->SetByteOrderToLittleEndian();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw IoError("cannot encode " + path.string());
  std::string bytes = writer->GetOutputString();
  bytes += vtp_seal(bytes);
  write_text_file(path.string(), bytes);
}

}  // namespace

void write_drape_vtp(const std::filesystem::path& path, const garment::Garment& garment,
                     const drape::Drape& drape, const std::vector<maps::PerformanceMap>& maps,
                     const std::vector<VtpArray>& point_arrays,
                     const std::vector<VtpArray>& cell_arrays,
                     const std::vector<body::Region>& regions) {
  const std::size_t points = garment.vertex_count, cells = garment.triangles.size();
  if (drape.positions.size() != points)
    throw InvalidInput("drape has " + std::to_string(drape.positions.size()) +
                       " positions, expected one for each of the garment's " +
                       std::to_string(points) + " vertices");
  // The surface.
  vtkNew<vtkPolyData> data;
  set_surface(data, drape.positions, garment.triangles,
              geometry::vertex_normals(drape.positions, garment.triangles));

  // Per point: maps, then what ties the mesh to its pattern.
  vtkPointData* point_data = data->GetPointData();
  for (const maps::PerformanceMap& map : maps)
    add_array(point_data, map.array, 1, map.values, points);
  add_array(point_data, "pattern_uv", 2, flat(garment.vertex_uv), points);
  add_array(point_data, "panel_id", garment.vertex_panel);
  if (!drape.body_normal_force.empty())
    add_array(point_data, "body_normal_force_N", 1, drape.body_normal_force, points);
  if (!regions.empty()) {
    if (regions.size() != points)
      throw InvalidInput("found " + std::to_string(regions.size()) + " regions, expected " +
                         std::to_string(points) + ", one for each vertex");
    std::vector<int> ids;
    for (body::Region region : regions) ids.push_back(static_cast<int>(region));
    add_array(point_data, "region_id", ids);
  }
  for (const VtpArray& a : point_arrays)
    add_array(point_data, a.name, a.components, a.values, points);

  // Per triangle: panel and pattern coordinates of its corners (a seam vertex has several).
  vtkCellData* cell_data = data->GetCellData();
  std::vector<double> corners;
  for (const auto& uv : garment.triangle_uv)
    for (const Vec2& corner : uv) corners.insert(corners.end(), {corner.x(), corner.y()});
  add_array(cell_data, "panel_id", garment.triangle_panel);
  add_array(cell_data, "corner_uv", 6, corners, cells);
  for (const VtpArray& a : cell_arrays) add_array(cell_data, a.name, a.components, a.values, cells);

  // The certificate and the names.
  const drape::Certificate& c = drape.certificate;
  vtkFieldData* field = data->GetFieldData();
  add_array(field, "residual", 2, {c.residual, c.residual_max}, 1);
  add_array(field, "intersections", {c.intersections_body, c.intersections_self});
  add_array(field, "folded_edges", {c.folded_edges});
  if (c.allowed_residual != solver::kRestTolerance)
    add_array(field, "allowed_residual", 1, {c.allowed_residual}, 1);
  if (c.stable) add_array(field, "stable", {*c.stable ? 1 : 0});
  add_strings(field, "stop_reason", {c.stop_reason});
  add_array(field, "worn", {c.worn() ? 1 : 0});
  add_strings(field, "worn_reasons", c.worn_reasons);
  add_strings(field, "panel_names", garment.panel_names);
  if (!regions.empty()) add_strings(field, "region_names", body::region_names());
  add_strings(field, "units", units_of(maps));
  write(path, data);
}

void write_body_vtp(const std::filesystem::path& path, const body::Body& body) {
  vtkNew<vtkPolyData> data;
  set_surface(data, body.surface.vertices, body.surface.triangles,
              body.normals.empty()
                  ? geometry::vertex_normals(body.surface.vertices, body.surface.triangles)
                  : body.normals);
  if (!body.segment.empty()) {
    std::vector<int> segment;
    for (body::Segment s : body.segment) segment.push_back(static_cast<int>(s));
    add_array(data->GetPointData(), "segment", segment);
    add_array(data->GetPointData(), "side", body.side);
  }
  write(path, data);
}

}  // namespace loosefit::io
