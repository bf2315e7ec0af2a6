#include "loosefit/report/write_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/io/glb_write.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/render/colour_table.h"
#include "loosefit/report/fitted_maps.h"

namespace loosefit::report {
namespace {

constexpr std::array<std::uint8_t, 3> kCloth = {226, 231, 238}, kUnder = {150, 166, 200};

/// Maps are asked for by name; the first one may be more than one array, or none that is drawn.
std::optional<maps::PerformanceMap> chosen_map(const pipeline::CaseResult& result) {
  for (maps::PerformanceMap& map : fitted_maps(result))
    if (map.pictured) return map;
  return std::nullopt;
}

std::vector<render::Rgb> colours_on(const maps::PerformanceMap& map) {
  const render::ColourTable& table = render::colours_of(map);
  std::vector<render::Rgb> colours;
  for (double value : map.values) {
    const double share = render::colour_share(map, value);
    colours.push_back(std::isnan(share)
                          ? render::kUndefinedColour
                          : table[static_cast<std::size_t>(std::lround(255 * share))]);
  }
  return colours;
}

}  // namespace

void write_model(const std::filesystem::path& folder, const pipeline::CaseResult& result,
                 const CaseForms& forms) {
  const garment::Garment& garment = result.studied().mesh();
  const std::vector<Vec3>& positions = result.studied().drape.positions;
  io::GlbSurface cloth{.name = "garment", .positions = positions, .triangles = garment.triangles};
  cloth.colour = kCloth;
  cloth.two_sided = true;
  std::vector<std::array<std::string, 2>> notes = {
      {"settled_and_worn", result.certificate().holds() ? "yes" : "no"}};
  if (const auto map = chosen_map(result)) {
    cloth.colours = colours_on(*map);
    notes.push_back({"map", map->title});
    notes.push_back({"unit", map->unit});
    notes.push_back({"range", fmt::format("{:g} to {:g}", map->range_low, map->range_high)});
  }
  std::vector<io::GlbSurface> surfaces = {std::move(cloth)};
  const geometry::TriangleMesh under = pipeline::surface_under_studied(result);
  const CaseForms::Form kept = forms.in_studied();
  const geometry::TriangleMesh& form = *kept;
  if (!form.triangles.empty()) surfaces.push_back({"mannequin", form.vertices, form.triangles});
  if (!under.triangles.empty())
    surfaces.push_back({.name = "worn under it",
                        .positions = under.vertices,
                        .triangles = under.triangles,
                        .colour = kUnder,
                        .two_sided = true});
  io::write_glb(folder / kModelFile, surfaces, notes);
}

}  // namespace loosefit::report
