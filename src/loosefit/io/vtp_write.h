#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/regions.h"
#include "loosefit/drape/drape.h"
#include "loosefit/garment/garment.h"
#include "loosefit/io/vtp_array.h"
#include "loosefit/maps/performance_map.h"

namespace loosefit::io {

/// Writes a drape as VTK PolyData, appended raw zlib, double precision. Point arrays: the given
/// maps under PerformanceMap::array, `pattern_uv` [m], `panel_id`, `Normals`, `body_normal_force_N`
/// where the drape knows it, `region_id` where regions are given (index into the field data
/// `region_names`), then `point_arrays`.
/// Cell arrays: `panel_id`, `corner_uv` (u, v of the three corners [m]), then `cell_arrays`. Field
/// data: the certificate and the panel names. Equal input gives equal bytes. \throws IoError when
/// the file cannot be written in full, InvalidInput on a wrong array length.
void write_drape_vtp(const std::filesystem::path& path, const garment::Garment& garment,
                     const drape::Drape& drape, const std::vector<maps::PerformanceMap>& maps = {},
                     const std::vector<VtpArray>& point_arrays = {},
                     const std::vector<VtpArray>& cell_arrays = {},
                     const std::vector<body::Region>& regions = {});

/// Writes the body surface with `Normals`, `segment` (enum order of Segment) and `side` per point.
void write_body_vtp(const std::filesystem::path& path, const body::Body& body);

}  // namespace loosefit::io
