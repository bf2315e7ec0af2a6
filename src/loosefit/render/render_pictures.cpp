#include "loosefit/render/render_pictures.h"

#include <algorithm>

#include "loosefit/render/drape_painter.h"
#include "loosefit/render/legend.h"

namespace loosefit::render {
namespace {

/// The same picture on a taller sheet with room for the legend.
Image with_foot(const Image& image, int foot) {
  Image sheet(image.width, image.height + foot);
  std::copy(image.pixels.begin(), image.pixels.end(), sheet.pixels.begin());
  return sheet;
}

}  // namespace

std::vector<Picture> render_pictures(const Screen& screen, const std::filesystem::path& dir,
                                     const body::Body& body, const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const std::vector<maps::PerformanceMap>& maps,
                                     const PictureOptions& options,
                                     const std::function<void(double)>& after_each) {
  const int foot = options.height / 7;
  DrapePainter painter(screen, {body, garment, positions, options.under, options.marked},
                       {.width = options.width,
                        .height = options.height - foot,
                        .supersampling = options.supersampling,
                        .ambient_occlusion = options.ambient_occlusion});
  // Pictures in all, for the progress.
  const bool layered = !options.under.triangles.empty();
  std::vector<const maps::PerformanceMap*> drawn;
  for (const maps::PerformanceMap& map : maps)
    if (map.pictured) drawn.push_back(&map);
  const double total = static_cast<double>(
      options.views.size() * (drawn.size() + (options.undecorated ? (layered ? 2 : 1) : 0)));

  std::vector<Picture> pictures;
  // Writes a picture and tells of it.
  const auto finish = [&](Image image, const std::string& map, View view) {
    draw_line_names(image, options.marked);
    pictures.push_back({map, view, dir / (map + "-" + name(view) + ".png"), jpeg(image)});
    write_png(pictures.back().file, image);
    if (after_each) after_each(static_cast<double>(pictures.size()) / total);
  };
  for (View view : options.views) {
    painter.look(camera(view));
    // The plain drape; with other layers also one that is seen through.
    if (options.undecorated) finish(painter.cloth(), "drape", view);
    if (options.undecorated && layered) finish(painter.layers(), "layers", view);
    // The maps, each with its legend below.
    for (const maps::PerformanceMap* map : drawn) {
      Image image = with_foot(painter.map(*map), foot);
      draw_legend(image, *map, foot);
      finish(image, map->map.empty() ? map->array : map->map, view);
    }
  }
  return pictures;
}

}  // namespace loosefit::render
