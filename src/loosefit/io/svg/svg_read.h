#pragma once
#include <filesystem>
#include <string>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a sewing pattern drawn as SVG (docs/patterns.md): by FreeSewing, whose groups and classes
/// say what is what, or by Inkscape and other programs, where closed lines are pieces, named by
/// inkscape:label, id or the group round them, and lines called grain, fold, notch, seam or hole
/// are that. Panels as of parse_dxf_pattern. `file` only appears in messages. \throws InvalidInput
/// and GeometryError naming line and key: no SVG, no piece, a size that no outline is labelled
/// with, units that cannot be told.
PatternFile parse_svg_pattern(const std::string& text, const std::string& file,
                              const PatternWish& wish = {});
/// \throws IoError if the file cannot be read, and as parse_svg_pattern.
PatternFile read_svg_pattern(const std::filesystem::path& path, const PatternWish& wish = {});

}  // namespace loosefit::io
