#include "loosefit/io/sites_csv.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

TEST(SitesCsv, WritesOneRowPerSiteWithUnitsInTheHead) {
  Site site;
  site.name = "left \"heart\", upper";
  site.panel = "front";
  site.at = {0.0125, 0.4};
  site.position = {0.05, -0.11, 1.25};
  site.region = Region::chest;
  site.values["distance_mm"] = {3.25, 4.5};
  site.values["strain_weft"] = {std::nan(""), std::nan("")};
  const auto path = std::filesystem::path(::testing::TempDir()) / "sites.csv";
  write_sites_csv(path, {site});
  std::ifstream f(path);
  const std::string text{std::istreambuf_iterator<char>(f), {}};
  EXPECT_EQ(text,
            "name,panel,u_m,v_m,x_m,y_m,z_m,region,distance_mm,distance_mm_p95,strain_weft,"
            "strain_weft_p95\n"
            "\"left \"\"heart\"\", upper\",front,0.0125,0.4,0.05,-0.11,1.25,chest,3.25,4.5,,\n");
}

TEST(SitesCsv, FullDiskIsAnError) { EXPECT_THROW(write_sites_csv("/dev/full", {}), IoError); }

}  // namespace
}  // namespace loosefit
