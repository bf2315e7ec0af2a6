#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/io/vtp.h"
#include "loosefit/io/vtp_seal.h"

namespace loosefit {
namespace {

/// Keeps what VTK would print while it lives, so that the caller gets one error.
class CapturedErrors : public vtkOutputWindow {
 public:
  static CapturedErrors* New() { return new CapturedErrors; }
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    if (first_.empty()) first_ = text;
  }
  void DisplayWarningText(const char* text) override { DisplayErrorText(text); }
  void begin() {
    SetInstance(this);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  void end() {
    SetInstance(nullptr);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
  }
  /// First message without VTK's source location.
  std::string first() const { return first_.substr(0, first_.find('\n')); }

 private:
  std::string first_;
};

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

void read_surface(const std::filesystem::path& path, vtkPolyData* data, DrapeFile& file) {
  const vtkIdType points = data->GetNumberOfPoints();
  file.garment.vertex_count = static_cast<int>(points);
  for (vtkIdType i = 0; i < points; ++i) {
    Vec3 p;
    data->GetPoint(i, p.data());
    if (!p.allFinite())
      throw InvalidInput({path.string(), 0, "point " + std::to_string(i)},
                         "a number that is not finite", "coordinates in metres");
    file.drape.positions.push_back(p);
  }
  vtkCellArray* cells = data->GetPolys();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    vtkIdType size = 0;
    const vtkIdType* corner = nullptr;
    cells->GetCellAtId(i, size, corner);
    bool valid = size == 3;
    for (int k = 0; valid && k < 3; ++k) valid = corner[k] >= 0 && corner[k] < points;
    if (!valid)
      throw InvalidInput({path.string(), 0, "cell " + std::to_string(i)},
                         std::to_string(size) + " corners or an index out of range",
                         "a triangle of existing points");
    file.garment.triangles.push_back(
        {static_cast<int>(corner[0]), static_cast<int>(corner[1]), static_cast<int>(corner[2])});
  }
}

}  // namespace

const VtpArray* DrapeFile::find(const std::string& name) const {
  for (const VtpArray& array : point_arrays)
    if (array.name == name) return &array;
  return nullptr;
}

DrapeFile read_drape_vtp(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw IoError("cannot read " + path.string());
  if (!vtp_seal_matches(bytes))
    throw InvalidInput({path.string(), 0, ""}, "no matching checksum in the last line",
                       "a drape.vtp as loosefit wrote it",
                       "a certificate only holds for the positions it was made for");

  vtkNew<CapturedErrors> captured;
  captured->begin();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  std::string error;
  try {
    reader->Update();
  } catch (const std::exception& problem) {  // sizes that no memory can hold
    error = problem.what();
  }
  captured->end();
  if (error.empty()) error = captured->first();
  vtkPolyData* data = reader->GetOutput();
  if (!error.empty() || !data || data->GetNumberOfPoints() == 0)
    throw InvalidInput({path.string(), 0, ""}, "a file that VTK cannot read",
                       "a drape.vtp written by loosefit", error);

  DrapeFile file;
  read_surface(path, data, file);
  const vtkIdType points = data->GetNumberOfPoints();
  const auto cells = static_cast<vtkIdType>(file.garment.triangles.size());

  Garment& garment = file.garment;
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
    const Vec2 e = triangle[1] - triangle[0], f = triangle[2] - triangle[0];
    garment.area += 0.5 * std::abs(e.x() * f.y() - e.y() * f.x());
    garment.triangle_uv.push_back(triangle);
  }

  Certificate& certificate = file.drape.certificate;
  vtkDataArray* residual = need(path, data->GetFieldData(), "residual", 2, 1);
  certificate.residual = residual->GetComponent(0, 0);
  certificate.residual_max = residual->GetComponent(0, 1);
  vtkDataArray* crossings = need(path, data->GetFieldData(), "intersections", 1, 2);
  certificate.intersections_body = static_cast<int>(crossings->GetComponent(0, 0));
  certificate.intersections_self = static_cast<int>(crossings->GetComponent(1, 0));
  const auto reason = strings(path, data->GetFieldData(), "stop_reason");
  if (!reason.empty()) certificate.stop_reason = reason.front();

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

}  // namespace loosefit
