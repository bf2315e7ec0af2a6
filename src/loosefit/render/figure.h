#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/maps/performance_map.h"
#include "loosefit/render/image.h"

namespace loosefit::render {

/// One picture of a figure; all have the same size.
struct FigurePanel {
  Image picture;
  std::string caption;  ///< may be empty
};

/// One colour bar. Ends that stand for "and beyond" carry ≤ and ≥.
struct FigureLegend {
  maps::MapArrayStyle style;
  bool values_below = false, values_above = false;
};

/// Pictures in a grid, row by row, lettered a, b, c where there are several, with the legends in a
/// row below: one for all pictures of a map.
struct Figure {
  std::vector<FigurePanel> panels;
  std::vector<FigureLegend> legends;
  int columns = 1;
  std::string title;  ///< may be empty
};

/// Pixels of a figure as PNG.
struct FigureSize {
  int width = 0, height = 0;
};
FigureSize size_of(const Figure& figure);

/// In SVG and PDF text, ticks and colour bars are vectors, and the pictures are embedded.
enum class FigureFormat { png, svg, pdf };
/// By the ending of a file's name. \throws InvalidInput for any but .png, .svg, .pdf.
FigureFormat figure_format(const std::filesystem::path& file);

/// Pixels of a picture per inch of SVG and PDF: what journals ask for.
inline constexpr double kFigureResolution = 300;

/// The bytes of a file; equal figures give equal bytes, but for the numbers by which an SVG names
/// its parts. \pre there are panels, all of one size
/// \throws Error when it cannot be drawn (too large).
std::string figure_file(const Figure& figure, FigureFormat format);

}  // namespace loosefit::render
