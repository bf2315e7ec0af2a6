#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// What is fixed to a piece: the outline of a sensor, or the path of a cable.
struct PatternMark {
  std::string name;
  std::string panel;       ///< by name
  std::vector<Vec2> line;  ///< [m]; one point: a place without an outline
  bool closed = false;
};

/// Layer of these marks: ASTM D6673 gives it no meaning.
inline constexpr int kMarkLayer = 20;

/// The pattern as DXF-AAMA (ASTM D6673, R12 text, millimetres): a block per piece, side by side.
/// Every edge is an open polyline on layer 1 (boundary) and on layer 14 (sew line: there is no
/// allowance), its ends turn points on layer 2; notches on 4, the grain on 7, marks with their
/// names on kMarkLayer. Chords stay within 5 µm of the curves. Seams are not written: the format
/// has none. \throws GeometryError for an invalid pattern, InvalidInput for a mark on no panel.
std::string dxf_text(const pattern::Pattern& pattern,
                     const std::vector<pattern::Notch>& notches = {},
                     const std::vector<PatternMark>& marks = {});
/// \throws IoError if the file cannot be written, and as dxf_text.
void write_dxf(const std::filesystem::path& path, const pattern::Pattern& pattern,
               const std::vector<pattern::Notch>& notches = {},
               const std::vector<PatternMark>& marks = {});

}  // namespace loosefit::io
