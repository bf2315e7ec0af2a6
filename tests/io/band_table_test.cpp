#include "loosefit/io/band_table.h"

#include <gtest/gtest.h>

#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "support/side_file.h"

// Bands of another cloth in every file that may tell of one.
namespace loosefit::io {
namespace {

using support::refusal_of;

TEST(BandTable, ThoseOfAScenarioAreReadAndWrittenAgain) {
  const scenario::Scenario scenario = parse_scenario(
      "[garment]\n[[garment.band]]\npanels = [\"front\", \"back\"]\nlayers = 1.5\nstiffness = "
      "0.3\n[[under]]\npattern = \"t-shirt\"\n[[under.band]]\npanels = [\"back\"]\n",
      "case.toml");
  const auto& bands = scenario.studied().spec.bands;
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_EQ(bands[0].panels, (std::vector<std::string>{"front", "back"}));
  EXPECT_EQ(bands[0].cloth, (pattern::PanelCloth{1.5, 0.3, 1})) << "no softer in bending";
  ASSERT_EQ(scenario.garments[0].spec.bands.size(), 1u);
  EXPECT_EQ(scenario.garments[0].spec.bands[0].cloth, (pattern::PanelCloth{2, 2, 2})) << "folded";
  const scenario::Scenario again = parse_scenario(scenario_toml(scenario), "again.toml");
  EXPECT_EQ(again.studied().spec.bands, bands);
  EXPECT_EQ(again.garments[0].spec.bands, scenario.garments[0].spec.bands);
}

TEST(BandTable, OddOnesAreRefusedByFileLineAndKey) {
  const auto refused = [](const std::string& keys) {
    return refusal_of([&] { parse_scenario("[garment]\n[[garment.band]]\n" + keys, "case.toml"); });
  };
  EXPECT_NE(refused("layers = 2\n").find("case.toml:2: garment.band[0].panels: found nothing"),
            std::string::npos);
  EXPECT_NE(refused("panels = [\"front\"]\nstiffness = -1\n")
                .find("case.toml:4: garment.band[0].stiffness: found -1"),
            std::string::npos);
  EXPECT_NE(
      refused("panels = [\"front\"]\n[[garment.band]]\npanels = [\"back\", \"front\"]\n")
          .find("case.toml:5: garment.band[1].panels: found \"front\", expected a panel that no "
                "band before it has"),
      std::string::npos);
  EXPECT_NE(refused("panels = [\"front\"]\nlayer = 2\n").find("layers"), std::string::npos);
}

TEST(BandTable, APanelIsFoundByItsName) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  pattern::set_cloth(shirt, {{"front"}, pattern::cloth_of_layers(2, 5)});
  EXPECT_EQ(shirt.panels[shirt.find_panel("front")].cloth, (pattern::PanelCloth{2, 5, 5}));
  EXPECT_EQ(shirt.panels[shirt.find_panel("back")].cloth, pattern::PanelCloth{});
  EXPECT_NE(refusal_of([&] {
              pattern::set_cloth(shirt, {{"frnt"}, {}});
            }).find("did you mean \"front\"?"),
            std::string::npos);
}

TEST(BandTable, ThoseBesideADrawingAreOfTheirClothToo) {
  const pattern::Pattern tee =
      support::tee_with_side_file("[[band]]\npanels = [\"SLEEVE\"]\nstiffness = 0.5\n");
  EXPECT_EQ(tee.panels[tee.find_panel("SLEEVE")].cloth, (pattern::PanelCloth{2, 0.5, 1}));
  EXPECT_NE(refusal_of([&] {
              support::tee_with_side_file("[[band]]\npanels = [\"SLEVE\"]\n");
            }).find("tee.seams.toml:2: band[0].panels: found \"SLEVE\", expected a panel"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::io
