#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// The flat pieces at 1:1 (user unit = 1 mm), side by side without overlap, seen from the outside
/// of the cloth: outline with true curves, name, size, grain arrow, edge names and lengths, seam
/// numbers (the same number on both sides of a seam) and a 100 mm control square. No seam
/// allowance. \throws GeometryError for an invalid pattern.
std::string pattern_svg(const pattern::Pattern& pattern);

/// Where one piece lies on the sheet. Sheet: x to the right, y down [mm]; panel: y up [m].
struct PanelOnSheet {
  Vec2 corner = Vec2::Zero();  ///< upper left corner of the panel's extent on the sheet [mm]
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< extent in the panel [m]
  Vec2 at(const Vec2& p) const {
    return {corner.x() + (p.x() - low.x()) * 1000, corner.y() + (high.y() - p.y()) * 1000};
  }
};

/// What is drawn on the pieces, and written beside them in place of the list of seams.
struct SheetMarks {
  std::string title, words;  ///< two lines above the pieces
  /// SVG elements over a piece, by its index in Pattern::panels.
  std::function<std::string(int panel, const PanelOnSheet& sheet)> over_panel;
  std::vector<std::string> lines;  ///< beside the control square, plain text
};

/// The same sheet with marks; names and grain stand back.
std::string pattern_svg(const pattern::Pattern& pattern, const SheetMarks& marks);

/// Text made safe for XML.
std::string svg_escaped(const std::string& text);

/// \throws IoError if the file cannot be written.
void write_pattern_svg(const std::filesystem::path& path, const pattern::Pattern& pattern);

}  // namespace loosefit::io
