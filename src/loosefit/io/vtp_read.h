#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/garment/garment.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/io/vtp_array.h"

namespace loosefit::io {

/// The surface in a file of write_body_vtp [m].
/// \throws IoError if it is missing or empty, InvalidInput if it is no such file or was changed.
geometry::TriangleMesh read_body_vtp(const std::filesystem::path& path);

/// What a drape file holds. `garment` carries topology, pattern coordinates, panels and flat area;
/// masses and edge chains are not stored, so it serves maps and pictures, not simulation.
struct DrapeFile {
  garment::Garment garment;
  drape::Drape drape;  ///< positions, certificate, normal force of the body
  std::vector<VtpArray> point_arrays, cell_arrays;  ///< everything else found in the file

  /// Point array by name; nullptr if there is none.
  const VtpArray* find(const std::string& name) const;
};

/// Reads a file of write_drape_vtp.
/// \throws IoError if it is missing or empty, InvalidInput if it is no such file or was changed.
DrapeFile read_drape_vtp(const std::filesystem::path& path);

}  // namespace loosefit::io
