#include "loosefit/render/figure.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/render/colour_table.h"
#include "loosefit/render/legend.h"

namespace loosefit::render {
namespace {

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;
using Pattern = std::unique_ptr<cairo_pattern_t, Release>;

/// Where the parts of a figure stand [pixels of the PNG].
struct Layout {
  int panel_width, panel_height, columns, rows;
  double text;            ///< height of captions and ticks
  double title, caption;  ///< bands above the grid and above each panel
  double gap;             ///< between panels, and around all
  double legend;          ///< height of one row of legends
  int legends_per_row, legend_rows;
  double left(int panel) const { return gap + (panel % columns) * (panel_width + gap); }
  double top(int panel) const {
    return gap + title + (panel / columns) * (caption + panel_height + gap);
  }
  double width() const { return gap + columns * (panel_width + gap); }
  double foot() const { return gap + title + rows * (caption + panel_height + gap); }
  double height() const { return foot() + legend_rows * (legend + gap); }
};

Layout layout_of(const Figure& figure) {
  LOOSEFIT_ASSERT(!figure.panels.empty() && figure.columns > 0);
  Layout layout{};
  layout.panel_width = figure.panels[0].picture.width;
  layout.panel_height = figure.panels[0].picture.height;
  const int count = static_cast<int>(figure.panels.size());
  layout.columns = std::min(figure.columns, count);
  layout.rows = (count + layout.columns - 1) / layout.columns;
  layout.text = std::clamp(layout.panel_width / 22.0, 11.0, 40.0);
  layout.gap = std::round(0.5 * layout.text);
  layout.title = figure.title.empty() ? 0 : 2 * layout.text;
  const bool captioned =
      count > 1 || std::any_of(figure.panels.begin(), figure.panels.end(),
                               [](const FigurePanel& panel) { return !panel.caption.empty(); });
  layout.caption = captioned ? 1.6 * layout.text : 0;
  layout.legend = 5 * layout.text;
  const int legends = static_cast<int>(figure.legends.size());
  // A bar is readable from 20 characters on.
  layout.legends_per_row =
      std::clamp(static_cast<int>(layout.width() / (20 * layout.text)), 1, std::max(legends, 1));
  layout.legend_rows = (legends + layout.legends_per_row - 1) / layout.legends_per_row;
  return layout;
}

void set_colour(cairo_t* context, const Rgb& c) {
  cairo_set_source_rgb(context, c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
}

void draw_text(cairo_t* context, const std::string& text, double x, double baseline, double size,
               double align, bool bold = false) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  cairo_move_to(context, x - align * extents.x_advance, baseline);
  set_colour(context, {20, 20, 20});
  cairo_show_text(context, text.c_str());
}

void draw_picture(cairo_t* context, const Image& picture, double x, double y) {
  const Surface raster(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
  unsigned char* data = cairo_image_surface_get_data(raster.get());
  const int stride = cairo_image_surface_get_stride(raster.get());
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const Rgb& c = picture.at(column, row);
      const std::uint32_t packed = std::uint32_t{c[0]} << 16 | std::uint32_t{c[1]} << 8 | c[2];
      std::memcpy(data + std::ptrdiff_t{row} * stride + 4 * column, &packed, 4);
    }
  cairo_surface_mark_dirty(raster.get());
  cairo_set_source_surface(context, raster.get(), x, y);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_paint(context);
}

void draw_bar(cairo_t* context, const FigureLegend& legend, double left, double top, double width,
              double text) {
  const maps::MapArrayStyle& style = legend.style;
  draw_text(context, legend_title(style), left + width / 2, top + text, text, 0.5, true);
  const double bar_top = top + 1.5 * text, bar_height = 1.4 * text;
  // One stop per entry of the table, so that the bar is the table in every format.
  const ColourTable& colours = colours_of(style);
  const Pattern ramp(cairo_pattern_create_linear(left, 0, left + width, 0));
  for (std::size_t i = 0; i < colours.size(); ++i)
    cairo_pattern_add_color_stop_rgb(ramp.get(), (static_cast<double>(i) + 0.5) / colours.size(),
                                     colours[i][0] / 255.0, colours[i][1] / 255.0,
                                     colours[i][2] / 255.0);
  cairo_rectangle(context, left, bar_top, width, bar_height);
  cairo_set_source(context, ramp.get());
  cairo_fill_preserve(context);
  set_colour(context, {60, 60, 60});
  cairo_set_line_width(context, text / 14);
  cairo_stroke(context);
  for (const LegendTick& tick : legend_ticks(style, legend.values_below, legend.values_above)) {
    const double x = left + tick.share * width;
    cairo_move_to(context, x, bar_top + bar_height);
    cairo_line_to(context, x, bar_top + bar_height + 0.3 * text);
    set_colour(context, {60, 60, 60});
    cairo_stroke(context);
    draw_text(context, tick.text, x, bar_top + bar_height + 1.3 * text, 0.9 * text, 0.5);
  }
}

void draw(cairo_t* context, const Figure& figure, const Layout& layout) {
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_paint(context);
  if (!figure.title.empty())
    draw_text(context, figure.title, layout.width() / 2, layout.gap + 1.2 * layout.text,
              1.25 * layout.text, 0.5, true);
  const int count = static_cast<int>(figure.panels.size());
  for (int p = 0; p < count; ++p) {
    const double x = layout.left(p), baseline = layout.top(p) + 1.1 * layout.text;
    draw_picture(context, figure.panels[p].picture, x, layout.top(p) + layout.caption);
    double from = x;
    if (count > 1) {  // a ... z, then aa, ab ...
      std::string letter = p < 26 ? "" : std::string(1, static_cast<char>('a' + p / 26 - 1));
      letter += static_cast<char>('a' + p % 26);
      draw_text(context, letter, x, baseline, layout.text, 0, true);
      from += (0.6 + 0.7 * static_cast<double>(letter.size())) * layout.text;
    }
    draw_text(context, figure.panels[p].caption, from, baseline, layout.text, 0);
  }
  const double slot = layout.width() / layout.legends_per_row;
  const int legends = static_cast<int>(figure.legends.size());
  for (int i = 0; i < legends; ++i) {
    const int row = i / layout.legends_per_row;
    // The last row may have fewer: it is centred.
    const int in_row = std::min(layout.legends_per_row, legends - row * layout.legends_per_row);
    const double start = 0.5 * (layout.width() - in_row * slot);
    const double width = std::min(0.8 * slot, 36 * layout.text);
    const double middle = start + (i % layout.legends_per_row + 0.5) * slot;
    draw_bar(context, figure.legends[i], middle - width / 2,
             layout.foot() + row * (layout.legend + layout.gap), width, layout.text);
  }
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("cannot draw the figure: ") + cairo_status_to_string(status));
}

std::string vectors(const Figure& figure, bool pdf) {
  const Layout layout = layout_of(figure);
  const double points = 72 / kFigureResolution;
  std::string bytes;
  {
    const double width = points * layout.width(), height = points * layout.height();
    const Surface surface(pdf ? cairo_pdf_surface_create_for_stream(append, &bytes, width, height)
                              : cairo_svg_surface_create_for_stream(append, &bytes, width, height));
    check(cairo_surface_status(surface.get()));
    // Equal figures give equal files.
    if (pdf)
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                     "2000-01-01T00:00:00Z");
    const Context context(cairo_create(surface.get()));
    cairo_scale(context.get(), points, points);
    draw(context.get(), figure, layout);
    cairo_surface_finish(surface.get());
    check(cairo_status(context.get()));
    check(cairo_surface_status(surface.get()));
  }
  return bytes;
}

}  // namespace

FigureSize size_of(const Figure& figure) {
  const Layout layout = layout_of(figure);
  return {static_cast<int>(std::ceil(layout.width())),
          static_cast<int>(std::ceil(layout.height()))};
}

FigureFormat figure_format(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".png") return FigureFormat::png;
  if (ending == ".svg") return FigureFormat::svg;
  if (ending == ".pdf") return FigureFormat::pdf;
  throw InvalidInput("figure: found '" + file.filename().string() +
                     "', expected a name that ends in .png, .svg or .pdf");
}

std::string figure_file(const Figure& figure, FigureFormat format) {
  if (format != FigureFormat::png) return vectors(figure, format == FigureFormat::pdf);
  const Layout layout = layout_of(figure);
  const FigureSize size = size_of(figure);
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height));
  check(cairo_surface_status(surface.get()));
  const Context context(cairo_create(surface.get()));
  draw(context.get(), figure, layout);
  check(cairo_status(context.get()));
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace loosefit::render
