#pragma once
#include <filesystem>
#include <string>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a sewing pattern of DXF-AAMA or ASTM D6673 (docs/patterns.md): blocks are pieces, one in
/// every size. Panels have their grain along y, notches, and edges e1, e2, … counted
/// counter-clockwise from where the outline of the file begins; no seams, since such files never
/// say what is sewn to what; their places are side by side. A piece that cannot be cloth is left
/// out with a warning. `file` only appears in messages. \throws InvalidInput and GeometryError
/// naming line, block or what else was found: no DXF, no
///         piece, no size that was asked for, units that cannot be told, nothing sound.
PatternFile parse_dxf_pattern(const std::string& text, const std::string& file,
                              const PatternWish& wish = {});
/// \throws IoError if the file cannot be read, and as parse_dxf_pattern.
PatternFile read_dxf_pattern(const std::filesystem::path& path, const PatternWish& wish = {});

}  // namespace loosefit::io
