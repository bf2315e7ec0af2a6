#include "loosefit/maps/mesh_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace loosefit::maps {
namespace {

using Json = nlohmann::json;

double mean_over_starts(const Json& starts, const std::string& array, const std::string& region,
                        const std::string& statistic) {
  double sum = 0;
  int settled = 0;
  for (const Json& drape : starts) {
    if (!drape.at("settled").get<bool>()) continue;
    sum += drape.at("maps").at(array).at(region).at(statistic).get<double>();
    ++settled;
  }
  return sum / settled;
}

double two_thirds(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(0.68 * double(values.size()))) - 1];
}

// The table is that of the recorded drapes: whoever measures anew and forgets it is told.
TEST(MeshError, IsThatOfTheRecordedDrapesOfTheReferenceShirt) {
  const Json record =
      Json::parse(std::ifstream(LOOSEFIT_SOURCE_DIR "/validation/convergence/results.json"));
  const std::map<std::string, std::string> statistic_of = {
      {"strain_warp", "p95"},
      {"strain_weft", "p95"},
      {"shear_angle_deg", "p95"},
      {"strain_max", "area_mean"},
      {"distance_mm", "area_mean"},
      {"angular_deviation_deg", "area_mean"},
      {"angular_deviation_total_deg", "area_mean"}};
  for (const auto& [array, statistic] : statistic_of) {
    const Json& regions = record.at("5").begin()->at("maps").at(array);
    std::vector<double> least;
    for (const int edge : {20, 14, 10, 7}) {
      std::vector<double> relative;
      for (const auto& [region, unused] : regions.items()) {
        if (region == "whole") continue;
        const double fine = mean_over_starts(record.at("5"), array, region, statistic);
        const double coarse =
            mean_over_starts(record.at(std::to_string(edge)), array, region, statistic);
        relative.push_back(std::abs(coarse - fine) / std::abs(fine));
        if (edge == 7) least.push_back(std::abs(coarse - fine));
      }
      constexpr double kLarge = 1e6;  // far above the least error
      EXPECT_NEAR(mesh_error(array, kLarge, 1e-3 * edge).value() / kLarge, two_thirds(relative),
                  0.006)
          << array << " at " << edge << " mm";
    }
    const double found = mesh_error(array, 0, 0.007).value();
    EXPECT_NEAR(found, two_thirds(least), 0.06 * found) << array;
  }
}

TEST(MeshError, GrowsWithTheEdgesBetweenThoseThatWereMeasured) {
  const double at_14 = mesh_error("distance_mm", 100, 0.014).value();
  const double at_20 = mesh_error("distance_mm", 100, 0.020).value();
  EXPECT_NEAR(mesh_error("distance_mm", 100, 0.017).value(), 0.5 * (at_14 + at_20), 1e-12);
  EXPECT_EQ(mesh_error("distance_mm", -100, 0.014), at_14);
  EXPECT_EQ(mesh_error("distance_mm", 100, 0.003), mesh_error("distance_mm", 100, 0.007));
}

TEST(MeshError, IsNotInventedWhereNobodyHasMeasured) {
  EXPECT_FALSE(mesh_error("pressure_kpa", 1, 0.014).has_value());
  EXPECT_FALSE(mesh_error("distance_mm", 10, 0.03).has_value());
  EXPECT_FALSE(mesh_error("distance_mm", std::nan(""), 0.014).has_value());
}

}  // namespace
}  // namespace loosefit::maps
