#include "loosefit/render/render_pictures.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/render/garment_lines.h"
#include "loosefit/render/legend.h"
#include "loosefit/render/lit.h"
#include "loosefit/render/mannequin.h"
#include "loosefit/render/scene.h"

namespace loosefit::render {
namespace {
constexpr Rgb kCloth = {226, 231, 238};
constexpr double kMapAmbient = 0.55;  // light left in the deepest shade of a map
constexpr double kThrough = 0.35;     // opacity of a garment that is looked through

/// The same picture on a taller sheet with room for the legend.
Image with_foot(const Image& image, int foot) {
  Image sheet(image.width, image.height + foot);
  std::copy(image.pixels.begin(), image.pixels.end(), sheet.pixels.begin());
  return sheet;
}

void check_sizes(const garment::Garment& garment, const std::vector<Vec3>& positions,
                 const std::vector<maps::PerformanceMap>& maps) {
  const auto n = static_cast<std::size_t>(garment.vertex_count);
  if (positions.size() != n)
    throw InvalidInput("pictures: " + std::to_string(positions.size()) + " positions for " +
                       std::to_string(n) + " garment vertices");
  for (const maps::PerformanceMap& map : maps)
    if (map.values.size() != n)
      throw InvalidInput("pictures: map " + map.array + " has " +
                         std::to_string(map.values.size()) + " values for " + std::to_string(n) +
                         " garment vertices");
}
}  // namespace

std::vector<Picture> render_pictures(const Screen& screen, const std::filesystem::path& dir,
                                     const body::Body& body, const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const std::vector<maps::PerformanceMap>& maps,
                                     const PictureOptions& options,
                                     const std::function<void(double)>& after_each) {
  check_sizes(garment, positions, maps);
  // One scene for all pictures: what changes is view, opacity and colours.
  const GarmentLines lines = garment_lines(garment);
  const int foot = options.height / 7;
  const geometry::TriangleMesh form = mannequin(body, garment, positions, options.under.vertices);
  const bool layered = !options.under.triangles.empty();
  Scene scene(screen,
              {form, positions, garment.triangles, lines.boundary, lines.seams,
               layered ? &options.under : nullptr},
              options.width, options.height - foot, options.supersampling,
              options.ambient_occlusion);
  // Pictures in all, for the progress.
  std::vector<const maps::PerformanceMap*> drawn;
  for (const maps::PerformanceMap& map : maps)
    if (map.pictured) drawn.push_back(&map);
  const double total = static_cast<double>(
      options.views.size() * (drawn.size() + (options.undecorated ? (layered ? 2 : 1) : 0)));

  std::vector<Picture> pictures;
  // Writes a picture and tells of it.
  const auto finish = [&](const Image& image, const std::string& map, View view) {
    pictures.push_back({map, view, dir / (map + "-" + name(view) + ".png"), jpeg(image)});
    write_png(pictures.back().file, image);
    if (after_each) after_each(static_cast<double>(pictures.size()) / total);
  };
  for (View view : options.views) {
    scene.look(view);
    // Shading is drawn once per view and serves every picture of it.
    const Image light = scene.light();
    // The plain drape; with other layers also one that is seen through.
    if (options.undecorated)
      finish(scaled_down(lit(scene.colours(nullptr, kCloth), light, kSceneAmbient),
                         options.supersampling),
             "drape", view);
    if (options.undecorated && layered) {
      scene.set_opacity(kThrough);
      const Image dim = scene.light();
      finish(scaled_down(lit(scene.colours(nullptr, kCloth), dim, kSceneAmbient),
                         options.supersampling),
             "layers", view);
      scene.set_opacity(1);
    }
    // The maps, each with its legend below.
    for (const maps::PerformanceMap* map : drawn) {
      Image image = with_foot(
          scaled_down(lit(scene.colours(map), light, kMapAmbient), options.supersampling), foot);
      draw_legend(image, *map, foot);
      finish(image, map->map.empty() ? map->array : map->map, view);
    }
  }
  return pictures;
}

}  // namespace loosefit::render
