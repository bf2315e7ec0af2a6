#include "loosefit/io/material_file.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

MaterialCard overridden(const std::string& text) {
  const ConfigNode node = parse_toml(text, "m.toml");
  ConfigReader table(node, "m.toml");
  MaterialCard card = load_material("paper-cotton");
  read_material_constants(table, card);
  table.finish();
  return card;
}

std::string refusal(const std::string& text) {
  try {
    overridden(text);
  } catch (const InvalidInput& e) {
    return std::string(e.what()) + " | " + e.hint();
  }
  return "accepted";
}

TEST(MaterialCards, AllShippedCardsAreCompleteAndPlausible) {
  const auto names = material_names();
  ASSERT_GE(names.size(), 8u);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const MaterialCard card = load_material(name);
    EXPECT_EQ(card.material.name, name);
    EXPECT_GT(card.material.source.size(), 20u);
    // A garment fabric bends over its own weight within centimetres (materials.md sections 1 and
    // 2).
    EXPECT_GT(bending_length(card.material), 0.005);
    EXPECT_LT(bending_length(card.material), 0.035);
  }
}

// materials.md section 1: the paper's cotton has a bending length of 15.5 mm in the reading that
// makes it a fabric, and E h = 1.318e5 N/m at the thickness which agrees with it.
TEST(MaterialCards, PaperCottonAsDerived) {
  EXPECT_NEAR(bending_length(load_material("paper-cotton").material), 15.5e-3, 0.1e-3);
  const Material literal = load_material("paper-cotton-literal").material;
  EXPECT_NEAR(literal.stiffness_warp, 1.318e5, 0.001e5);
  EXPECT_NEAR(literal.stiffness_shear, 5.73e4, 0.01e4);
}

TEST(MaterialConstants, IsotropicPairReportsTheContradiction) {
  // 6.65 GPa over a real fabric thickness of 0.3 mm: bending would be 1.5e-2 N m.
  const auto toml = "youngs_modulus = 6.65e8\nelastic_thickness = 0.0003\n";
  const MaterialCard card = overridden(toml);
  EXPECT_NEAR(card.material.stiffness_warp, 6.65e8 * 3e-4, 1e-6);
  ASSERT_FALSE(card.notes.empty());
  EXPECT_NE(card.notes.back().find("0.00153 N m"), std::string::npos) << card.notes.back();
  EXPECT_NE(card.notes.back().find("4.41e-06 N m"), std::string::npos) << card.notes.back();
}

TEST(MaterialConstants, RefusesHalfAPairAndBothWays) {
  EXPECT_NE(refusal("youngs_modulus = 1e6\n").find("elastic_thickness: found nothing"),
            std::string::npos);
  EXPECT_NE(refusal("youngs_modulus = 1e6\nelastic_thickness = 3e-4\nstiffness_warp = 10\n")
                .find("either youngs_modulus or stiffness_warp"),
            std::string::npos);
}

TEST(MaterialConstants, RefusesOutOfRangeWithUnits) {
  EXPECT_NE(refusal("bending_weft = 0.045\n").find("0.045 gf cm²/cm is 4.41299e-06"),
            std::string::npos)
      << refusal("bending_weft = 0.045\n");
  EXPECT_NE(refusal("areal_density = 120\n").find("kg/m²"), std::string::npos);
  EXPECT_NE(refusal("friction_body = -1\n").find("a coefficient from 0 to 3"), std::string::npos);
}

TEST(MaterialToml, ReadsBackToTheSameConstants) {
  Material m = load_material("denim").material;
  m.damping = 0.1 + 0.2;
  const std::string text = material_toml(m);
  EXPECT_EQ(material_toml(overridden(text).material), text);
}

TEST(LoadMaterial, UnknownNameGetsAGuess) {
  try {
    load_material("polyster");
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_EQ(e.hint(), "did you mean \"polyester\"?");
  }
}

}  // namespace
}  // namespace loosefit
