#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// The data of a file of ours, at least one point. `what`: its usual name, for errors.
/// \throws IoError if it is missing or empty, InvalidInput if it is no such file or was changed.
vtkSmartPointer<vtkPolyData> read_sealed_vtp(const std::filesystem::path& path, const char* what);

/// Its points [m] and triangles. `path` is for errors.
/// \throws InvalidInput for coordinates that are not finite and cells that are no triangles.
geometry::TriangleMesh surface_of(const std::filesystem::path& path, vtkPolyData* data);

}  // namespace loosefit::io
