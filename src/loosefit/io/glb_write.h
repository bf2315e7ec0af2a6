#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// One surface of a GLB file, z up as everywhere [m].
struct GlbSurface {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// Per vertex, as a display takes them (sRGB); empty: `colour` everywhere.
  std::vector<std::array<std::uint8_t, 3>> colours = {};
  std::array<std::uint8_t, 3> colour = {176, 176, 176};
  bool two_sided = false;
};

/// Binary glTF 2.0 (of the Khronos Group), which phones and browsers open: one node and mesh per
/// surface with POSITION, NORMAL and, with colours, COLOR_0 in linear light (16 bits). y is up in
/// glTF and the wearer looks along +z: (x, y, z) is written as (x, z, −y). `notes` become the
/// asset's extras, name and text.
/// \throws InvalidInput for a surface without triangles, with corners that do not exist or with
/// colours that do not fit; IoError when the file cannot be written in full.
void write_glb(const std::filesystem::path& path, const std::vector<GlbSurface>& surfaces,
               const std::vector<std::array<std::string, 2>>& notes = {});

}  // namespace loosefit::io
