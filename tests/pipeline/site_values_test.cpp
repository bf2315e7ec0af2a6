// What a site is told by.
#include "loosefit/pipeline/site_values.h"

#include <gtest/gtest.h>

#include "loosefit/maps/catalogue.h"

namespace loosefit::pipeline {
namespace {

TEST(SiteValues, OneNameIsOneQuantity) {
  placement::Site site;
  for (const maps::MapDefinition& map : maps::map_catalogue())
    for (const maps::MapArray& array : map.arrays) site.map_values[array.style.array] = {-1, -2};
  placement::MetricValues sensor;
  for (const placement::MetricName& metric : placement::metric_vocabulary())
    sensor[metric.name] = 1;
  site.samples = {sensor};
  for (const auto& [name, value] : site_values(site)) {
    const bool metric = placement::find_metric(name) != nullptr;
    EXPECT_EQ(value, metric ? 1 : name.ends_with("_worst") ? -2 : -1) << name;
  }
  EXPECT_EQ(site_values(site).at("angular_deviation_deg"), 1) << "the turn of the sensor";
  EXPECT_EQ(site_values(site).at("angular_deviation_deg_map"), -1) << "the mean of points";
  EXPECT_EQ(site_values(site).at("distance_mm"), -1) << "which no sensor has";
}

TEST(SiteValues, SensorsAreToldByTheMedianOfTheirDonnings) {
  placement::Site site;
  site.samples = {{{"gap_mm", 5.0}}, {{"gap_mm", 1.0}}, {{"gap_mm", 2.0}, {"slip_mm", 4.0}}};
  EXPECT_EQ(site_values(site).at("gap_mm"), 2);
  EXPECT_EQ(site_values(site).at("slip_mm"), 4) << "of those that know it";
  site.samples.pop_back();
  EXPECT_EQ(site_values(site).at("gap_mm"), 3);
}

}  // namespace
}  // namespace loosefit::pipeline
