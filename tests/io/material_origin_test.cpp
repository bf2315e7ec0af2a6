#include "loosefit/io/material_origin.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"

namespace loosefit::io {
namespace {

scenario::MaterialCard card(const std::string& section) {
  return parse_scenario("[material]\n" + section, "m.toml").studied().material;
}

std::string from(const scenario::MaterialCard& card, const std::string& key) {
  for (const ConstantInUse& c : constants_in_use(card))
    if (c.key == key) return c.from;
  return "no such constant";
}

const char* const kSheet =
    "[material.kes]\nW = 14\nT = 0.4\nB_warp = 0.1\nB_weft = 0.05\nG = 0.5\nEMT_warp = 5\n"
    "EMT_weft = 6\n";

TEST(MaterialOrigin, CardAsItIsKeepsNameAndSource) {
  const scenario::MaterialCard plain = card("");
  EXPECT_EQ(plain.material.name, "paper-cotton");
  EXPECT_EQ(plain.material.source, load_material("paper-cotton").material.source);
  EXPECT_EQ(from(plain, "poisson"), "card paper-cotton");
  EXPECT_EQ(from(plain, "bending_hysteresis_warp"), "default");
  EXPECT_EQ(own_constants_toml(plain), "");
}

TEST(MaterialOrigin, ReplacedClothIsNotCalledByItsCard) {
  const scenario::MaterialCard own = card(kSheet);
  EXPECT_EQ(own.material.name, "own constants");
  EXPECT_EQ(own.material.source.find("Harms"), std::string::npos) << own.material.source;
  EXPECT_NE(own.material.source.find("inherited from card paper-cotton: poisson, bending_poisson, "
                                     "friction_body, friction_self, damping"),
            std::string::npos)
      << own.material.source;
  EXPECT_EQ(from(own, "friction_body"), "inherited from card paper-cotton");
  EXPECT_EQ(from(own, "thickness"), "scenario: kes.T = 0.4 mm × 0.001");
  EXPECT_EQ(from(own, "stiffness_warp"),
            "scenario: kes.EMT_warp = 5 %: 500 gf/cm × 0.980665 / (5 / 100)");
  const scenario::MaterialCard named =
      card(std::string("title = \"jersey 7\"\nsource = \"our KES-FB\"\n") + kSheet);
  EXPECT_EQ(named.material.name, "jersey 7");
  EXPECT_EQ(named.material.source.rfind("our KES-FB; inherited", 0), 0u) << named.material.source;
}

TEST(MaterialOrigin, PartlyReplacedClothSaysWhat) {
  const scenario::MaterialCard part =
      card("name = \"wool\"\nfriction_body = 0.2\nthickness = 0.0006\n");
  EXPECT_EQ(part.material.name, "wool, changed: thickness, friction_body");
  EXPECT_EQ(from(part, "friction_body"), "scenario");
  EXPECT_EQ(from(part, "bending_warp").rfind("inherited from card wool", 0), 0u);
  // What the scenario gives is its own even where the card has the same figure.
  EXPECT_EQ(card("damping = 0.02\n").material.name, "paper-cotton, changed: damping");
}

TEST(MaterialOrigin, ResolvedScenarioTellsTheSame) {
  for (const std::string& section :
       {std::string(kSheet), std::string("name = \"wool\"\ndamping = 0.02\nthickness = 0.0006\n"),
        std::string("name = \"wool-measured\"\nstiffness_weft = 900\n"),
        std::string("title = \"t\"\n"), std::string("source = \"s\"\nthickness = 0.0006\n"),
        std::string("title = \"t\"\nsource = \"s\"\n"), std::string()}) {
    SCOPED_TRACE(section);
    const scenario::Scenario first = parse_scenario("[material]\n" + section, "m.toml");
    const std::string text = scenario_toml(first);
    const scenario::Scenario second = parse_scenario(text, "m.toml");
    EXPECT_EQ(scenario_toml(second), text);
    EXPECT_EQ(second.studied().material.material.name, first.studied().material.material.name);
    EXPECT_EQ(second.studied().material.material.source, first.studied().material.material.source);
    const auto a = constants_in_use(first.studied().material),
               b = constants_in_use(second.studied().material);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].from, b[i].from) << a[i].key;
      EXPECT_EQ(a[i].value, b[i].value) << a[i].key;
    }
  }
}

TEST(MaterialOrigin, OwnSourceStandsEvenWhereEveryFigureIsThatOfTheCard) {
  const std::string all = material_toml(load_material("denim").material);
  const scenario::MaterialCard own =
      card("name = \"denim\"\ntitle = \"my cloth\"\nsource = \"own KES-F, lab 2026\"\n" + all);
  EXPECT_EQ(own.material.name, "my cloth");
  EXPECT_EQ(own.material.source.rfind("own KES-F, lab 2026", 0), 0u) << own.material.source;
  EXPECT_EQ(from(own, "thickness"), "scenario");
  const scenario::MaterialCard noted = card("source = \"checked by us\"\n");
  EXPECT_EQ(noted.material.source.rfind("checked by us; all constants: card paper-cotton", 0), 0u)
      << noted.material.source;
}

// Scenarios that were resolved without `given` state every constant of the card.
TEST(MaterialOrigin, EveryConstantAsInTheCardIsTheCard) {
  const std::string all = material_toml(load_material("denim").material);
  EXPECT_EQ(card("name = \"denim\"\n" + all).material.name, "denim");
}

TEST(MaterialOrigin, UnknownGivenConstantIsRefused) {
  EXPECT_THROW(card("given = [\"thicknes\"]\n"), InvalidInput);
}

}  // namespace
}  // namespace loosefit::io
