#include "loosefit/io/vtp_polydata.h"

#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/io/vtp_seal.h"

namespace loosefit::io {
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

}  // namespace

vtkSmartPointer<vtkPolyData> read_sealed_vtp(const std::filesystem::path& path, const char* what) {
  std::error_code error_code;
  std::string bytes;
  if (std::filesystem::is_regular_file(path, error_code)) {
    std::ifstream stream(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  if (bytes.empty())
    throw IoError("cannot read " + path.string() + ": expected a " + what + " of loosefit");
  if (!vtp_seal_matches(bytes))
    throw InvalidInput({path.string(), 0, ""}, "no matching checksum in the last line",
                       std::string("a ") + what + " as loosefit wrote it",
                       "figures only hold for the positions they were made for");

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
  vtkSmartPointer<vtkPolyData> data = reader->GetOutput();
  if (!error.empty() || !data || data->GetNumberOfPoints() == 0)
    throw InvalidInput({path.string(), 0, ""}, "a file that VTK cannot read",
                       std::string("a ") + what + " written by loosefit", error);
  return data;
}

geometry::TriangleMesh surface_of(const std::filesystem::path& path, vtkPolyData* data) {
  geometry::TriangleMesh mesh;
  const vtkIdType points = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i) {
    Vec3 p;
    data->GetPoint(i, p.data());
    if (!p.allFinite())
      throw InvalidInput({path.string(), 0, "point " + std::to_string(i)},
                         "a number that is not finite", "coordinates in metres");
    mesh.vertices.push_back(p);
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
    mesh.triangles.push_back(
        {static_cast<int>(corner[0]), static_cast<int>(corner[1]), static_cast<int>(corner[2])});
  }
  return mesh;
}

}  // namespace loosefit::io
