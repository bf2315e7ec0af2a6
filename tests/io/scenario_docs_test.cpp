#include <gtest/gtest.h>

#include <sstream>

#include "loosefit/io/material_file.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

// Every key that the resolved scenario writes out must be explained.
TEST(ScenarioDocs, NameEveryKey) {
  std::string docs;
  for (const char* page : {"/docs/scenario.md", "/docs/garments.md"})
    docs += read_text_file(std::string(LOOSEFIT_SOURCE_DIR) + page, 1000000);
  scenario::Scenario scenario = default_scenario();
  scenario.attachments = {{"board", "back", garment::Board{}}, {"cable", "back", garment::Cable{}}};
  placement::SiteSpec pattern, anatomical;
  pattern.panel = "back";
  pattern.shift = {0.01, 0};
  anatomical.anatomy = placement::BodyAddress{placement::BodySegment::forearm, 1, Vec3(0, 50, 30)};
  anatomical.board = placement::SensorBoard{};
  scenario.sites = {placement::SiteSpec{}, pattern, anatomical};
  scenario.studied().material = load_material("wool-measured");
  scenario.ranking.modality = "ecg";
  scenario.garments.insert(scenario.garments.begin(),
                           {scenario.studied().spec, scenario.studied().material, 0.3});
  std::istringstream lines(scenario_toml(scenario));
  int keys = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.empty() || line[0] == '[' || equals == std::string::npos) continue;
    ++keys;
    EXPECT_NE(docs.find("`" + line.substr(0, equals) + "`"), std::string::npos)
        << line.substr(0, equals);
  }
  EXPECT_GT(keys, 50);
  for (const std::string& key : material_keys())
    EXPECT_NE(docs.find("`" + key + "`"), std::string::npos) << key;
}

}  // namespace
}  // namespace loosefit::io
