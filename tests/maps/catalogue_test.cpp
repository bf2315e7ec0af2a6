#include "loosefit/maps/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/compute_maps.h"
#include "support/tube_garment.h"
#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

std::string in_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

/// The row of docs/maps.md for one array.
std::string row(const MapDefinition& map, const MapArray& array) {
  const MapArrayStyle& style = array.style;
  std::string metrics;
  for (const SiteMetric& metric : array.metrics)
    metrics += (metrics.empty() ? "`" : ", `") + metric.name + "`";
  const std::string made = map.by_default       ? "by default"
                           : map.needs_postures ? "with [postures]"
                                                : "on request";
  return "| `" + style.array + "` | `" + map.name + "` | " + style.unit + " | " +
         shortest(style.range_low) + " … " + shortest(style.range_high) + " | " +
         in_cell(array.meaning) + " | " + in_cell(array.formula) + " | " + in_cell(array.source) +
         " | " + metrics + " | " + made + " |";
}

TEST(MapCatalogue, StandsInTheDocuments) {
  std::ifstream file(LOOSEFIT_SOURCE_DIR "/docs/maps.md");
  std::vector<std::string> found, expected;
  for (std::string line; std::getline(file, line);)
    if (line.rfind("| `", 0) == 0) found.push_back(line);
  std::string all;
  for (const MapDefinition& map : map_catalogue())
    for (const MapArray& array : map.arrays) {
      expected.push_back(row(map, array));
      all += expected.back() + "\n";
    }
  EXPECT_EQ(found, expected) << "the table of docs/maps.md has to read\n" << all;
}

TEST(MapCatalogue, NamesUnitsAndRangesFitTogether) {
  std::set<std::string> arrays, pictures, metrics;
  for (const MapDefinition& map : map_catalogue())
    for (const MapArray& array : map.arrays) {
      const MapArrayStyle& style = array.style;
      EXPECT_TRUE(arrays.insert(style.array).second) << style.array << " twice";
      EXPECT_TRUE(pictures.insert(style.map).second) << style.map << " twice";
      for (const SiteMetric& metric : array.metrics)
        EXPECT_TRUE(metrics.insert(metric.name).second) << metric.name << " twice";
      const std::string suffix = style.array.substr(style.array.rfind('_') + 1);
      const std::string unit = style.unit == "–" ? "" : style.unit;
      EXPECT_EQ(suffix == "mm" || suffix == "deg" || suffix == "kPa" ? suffix : "", unit);
      EXPECT_LT(style.range_low, style.range_high) << style.array;
      EXPECT_EQ(style.diverging, style.range_low < 0) << style.array;
      EXPECT_TRUE(std::is_sorted(style.breaks.begin(), style.breaks.end()));
      if (!style.breaks.empty()) {
        EXPECT_EQ(style.breaks.front(), style.range_low) << style.array;
        EXPECT_EQ(style.breaks.back(), style.range_high) << style.array;
      }
      for (const std::string* text : {&style.title, &array.meaning, &array.formula, &array.source})
        EXPECT_FALSE(text->empty()) << style.array;
      for (const SiteMetric& metric : array.metrics)
        EXPECT_FALSE(metric.footprint == OverFootprint::rigid && !array.rigid &&
                     !map.needs_postures)
            << metric.name << " has nothing to read of a rigid footprint";
    }
}

TEST(MapCatalogue, KnowsWhatIsMadeByDefault) {
  EXPECT_EQ(default_map_names(), (std::vector<std::string>{"strain", "shear", "distance",
                                                           "angular-deviation", "crimp"}));
  for (const std::string& name : map_names()) EXPECT_FALSE(find_map(name)->needs_postures) << name;
  EXPECT_EQ(find_map("drape"), nullptr);
  EXPECT_EQ(find_map_array("gap_mm")->style.map, "gap");
  EXPECT_EQ(find_map_array("gap"), nullptr);
}

TEST(MapCatalogue, LeadsWithWhatALeadFeelsAndKeepsPrincipalStrainBehindIt) {
  const double radius = 0.11;
  const garment::Garment tube = testing::tube_garment(2 * kPi * radius, 0.2, 20, 4);
  const drape::Drape drape = testing::settled_drape(tube, [&](const Vec2& uv) {
    const double a = uv.x() / radius;
    return Vec3(radius * std::cos(a), radius * std::sin(a), 0.4 + uv.y());
  });
  const body::PosedBody body = testing::cylinder_body(0.1, 1.0, 100, 20);
  const fabric::Material material;
  const auto arrays = [&](const std::vector<std::string>& names) {
    std::vector<std::string> made;
    for (const PerformanceMap& map :
         compute_maps(tube, drape, body, names, {.material = &material}))
      made.push_back(map.array);
    return made;
  };
  const std::vector<std::string> principal = {"strain_vertical", "strain_max", "strain_min",
                                              "slack"};
  std::vector<std::string> all = {"strain_warp", "strain_weft", "shear_angle_deg"};
  all.insert(all.end(), principal.begin(), principal.end());
  EXPECT_EQ(arrays({"shear", "strain"}), all);
  EXPECT_EQ(arrays({"principal-strain"}), principal);
  EXPECT_EQ(arrays({"principal-strain", "strain"}).size(), 2 + principal.size())
      << "asked for twice, made once";
}

TEST(MapCatalogue, EveryMapHasAValueAtEveryVertexOfAPatchBeforeAWall) {
  const body::Body body = testing::wall_body();
  garment::Garment patch = testing::patch_garment(0.04, 0.01);
  patch.vertex_ease_cut.assign(patch.vertex_count, 0.1);
  patch.vertex_ease_asked.assign(patch.vertex_count, 0.08);
  const std::vector<Vec3> positions = testing::before_wall(patch, 0.02);
  const WornGarment worn = relate(patch, positions, body);
  const std::vector<double> none(patch.vertex_count, 0.0);
  const PressureField pressure{none, none, none, std::vector<char>(patch.vertex_count, 0)};
  const fabric::Material material;
  const DressedState state{positions, body, worn};
  const std::vector<DressedState> states = {state};
  for (const MapDefinition& map : map_catalogue()) {
    const auto made =
        make_maps(map, {patch, positions, worn, &material, &pressure, &state, &states});
    ASSERT_EQ(made.size(), map.arrays.size());
    for (const PerformanceMap& array : made) {
      ASSERT_EQ(array.values.size(), static_cast<std::size_t>(patch.vertex_count)) << array.array;
      for (double value : array.values) EXPECT_TRUE(std::isfinite(value)) << array.array;
    }
  }
}

TEST(MapCatalogue, RefusesWhatTheInputLacks) {
  const garment::Garment garment;
  const std::vector<Vec3> positions;
  const WornGarment worn;
  for (const MapDefinition& map : map_catalogue())
    if (map.needs_material || map.needs_forces || map.needs_postures) {
      EXPECT_THROW(make_maps(map, {garment, positions, worn}), InvalidInput) << map.name;
    }
  EXPECT_THROW(make_maps("stain", {garment, positions, worn}), InvalidInput);
}

}  // namespace
}  // namespace loosefit::maps
