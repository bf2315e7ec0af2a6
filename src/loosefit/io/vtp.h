#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/drape/drape.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/performance_map.h"

namespace loosefit {

/// A named array of a VTP file: `components` doubles per point or per cell.
struct VtpArray {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

/// Writes a drape as VTK PolyData, appended raw zlib, double precision. Point arrays: the given
/// maps under PerformanceMap::array, `pattern_uv` [m], `panel_id`, `Normals`, `body_normal_force_N`
/// where the drape knows it, then `point_arrays`.
/// Cell arrays: `panel_id`, `corner_uv` (u, v of the three corners [m]), then `cell_arrays`. Field
/// data: the certificate and the panel names. Equal input gives equal bytes. \throws IoError when
/// the file cannot be written in full, InvalidInput on a wrong array length.
void write_drape_vtp(const std::filesystem::path& path, const Garment& garment, const Drape& drape,
                     const std::vector<PerformanceMap>& maps = {},
                     const std::vector<VtpArray>& point_arrays = {},
                     const std::vector<VtpArray>& cell_arrays = {});

/// Writes the body surface with `Normals`, `segment` (enum order of Segment) and `side` per point.
void write_body_vtp(const std::filesystem::path& path, const Body& body);

/// The surface in a file of write_body_vtp [m].
/// \throws IoError if it is missing or empty, InvalidInput if it is no such file or was changed.
TriangleMesh read_body_vtp(const std::filesystem::path& path);

/// What a drape file holds. `garment` carries topology, pattern coordinates, panels and flat area;
/// masses and edge chains are not stored, so it serves maps and pictures, not simulation.
struct DrapeFile {
  Garment garment;
  Drape drape;  ///< positions, certificate, normal force of the body
  std::vector<VtpArray> point_arrays, cell_arrays;  ///< everything else found in the file

  /// Point array by name; nullptr if there is none.
  const VtpArray* find(const std::string& name) const;
};

/// Reads a file of write_drape_vtp.
/// \throws IoError if it is missing or empty, InvalidInput if it is no such file or was changed.
DrapeFile read_drape_vtp(const std::filesystem::path& path);

}  // namespace loosefit
