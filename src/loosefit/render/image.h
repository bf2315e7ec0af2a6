#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/render/colour_table.h"

namespace loosefit::render {

/// 8-bit RGB raster, row 0 at the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  Image() = default;
  Image(int w, int h, Rgb colour = {255, 255, 255})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, colour) {}
  Rgb& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Rgb& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Averages blocks of factor × factor pixels in linear light.
Image scaled_down(const Image& image, int factor);

/// Fills the rectangle [x0, x1) × [y0, y1), clipped to the image.
void fill(Image& image, int x0, int y0, int x1, int y1, Rgb colour);

/// Draws `text` in VTK's own sans-serif font, `size` pixels high, its anchor at (x, y):
/// `align` -1 starts there, 0 is centred, +1 ends there; y is the baseline's line top.
void draw_text(Image& image, const std::string& text, int x, int y, int size, int align = -1,
               Rgb colour = {40, 40, 40}, bool bold = false);

/// The image as JPEG, good enough to read its legend.
std::string jpeg(const Image& image);

/// \throws IoError when the file cannot be written in full.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace loosefit::render
