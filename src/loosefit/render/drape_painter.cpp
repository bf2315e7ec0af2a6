#include "loosefit/render/drape_painter.h"

#include "loosefit/base/error.h"
#include "loosefit/render/lit.h"
#include "loosefit/render/mannequin.h"

namespace loosefit::render {
namespace {

constexpr Rgb kCloth = {226, 231, 238};
constexpr double kMapAmbient = 0.55;  // light left in the deepest shade of a map
constexpr double kThrough = 0.35;     // opacity of a garment that is looked through

void check_count(std::size_t found, std::size_t vertices, const std::string& what) {
  if (found != vertices)
    throw InvalidInput("pictures: " + what + " for " + std::to_string(found) +
                       " vertices, expected " + std::to_string(vertices) + " of the garment");
}

std::shared_ptr<const geometry::TriangleMesh> form_of(const DrawnDrape& drape) {
  check_count(drape.positions.size(), static_cast<std::size_t>(drape.garment.vertex_count),
              "positions");
  if (drape.form) return drape.form;
  return std::make_shared<const geometry::TriangleMesh>(
      mannequin(drape.body, drape.garment, drape.positions, drape.under));
}

SceneContent content_of(const DrawnDrape& drape, const geometry::TriangleMesh& form) {
  return {.body = form,
          .positions = drape.positions,
          .triangles = drape.garment.triangles,
          .lines = {},
          .seams = {},
          .under = drape.under.triangles.empty() ? nullptr : &drape.under};
}

SceneContent whole_content(const DrawnDrape& drape, const geometry::TriangleMesh& form,
                           const GarmentLines& lines, double frame_height) {
  SceneContent content = content_of(drape, form);
  content.lines = lines.boundary;
  content.seams = lines.seams;
  content.marked = drape.marked;
  content.frame_height = frame_height;
  return content;
}

}  // namespace

Image finished(UnfinishedPicture picture) {
  return scaled_down(lit(std::move(picture.colours), *picture.light, picture.ambient),
                     picture.supersampling);
}

DrapePainter::DrapePainter(const Screen& screen, const DrawnDrape& drape,
                           const PaintOptions& options)
    : options_(options),
      vertices_(drape.positions.size()),
      form_(form_of(drape)),
      lines_(garment_lines(drape.garment)),
      scene_(screen, whole_content(drape, *form_, lines_, options.frame_height), options.width,
             options.height, options.supersampling, options.ambient_occlusion) {}

void DrapePainter::look(const Camera& from) {
  scene_.look(from);
  light_ = std::make_shared<const Image>(scene_.light());
}

UnfinishedPicture DrapePainter::cloth() {
  return {scene_.colours(nullptr, kCloth), light_, kSceneAmbient, options_.supersampling};
}

UnfinishedPicture DrapePainter::layers() {
  scene_.set_opacity(kThrough);
  auto dim = std::make_shared<const Image>(scene_.light());
  UnfinishedPicture picture{scene_.colours(nullptr, kCloth), std::move(dim), kSceneAmbient,
                            options_.supersampling};
  scene_.set_opacity(1);
  return picture;
}

UnfinishedPicture DrapePainter::map(const maps::PerformanceMap& map) {
  check_count(map.values.size(), vertices_, "map " + map.array);
  return {scene_.colours(&map), light_, kMapAmbient, options_.supersampling};
}

double frame_height(const DrawnDrape& drape, double aspect, const Camera& from) {
  return frame_height(content_of(drape, *form_of(drape)), aspect, from);
}

}  // namespace loosefit::render
