#include "loosefit/io/material_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/fabric/stress_curve.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/toml_file.h"
#include "support/scratch_folder.h"
#include "support/wool_sample.h"

namespace loosefit::io {
namespace {

scenario::MaterialCard overridden(const std::string& text) {
  const ConfigNode node = parse_toml(text, "m.toml");
  ConfigReader table(node, "m.toml");
  scenario::MaterialCard card = load_material("paper-cotton");
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
    const scenario::MaterialCard card = load_material(name);
    EXPECT_EQ(card.material.name, name);
    EXPECT_GT(card.material.source.size(), 20u);
    EXPECT_GT(card.status.size(), 20u);
    EXPECT_NE(read_text_file(data_directory() / "materials" / (name + ".toml"), 100000)
                  .find("\nbending_poisson = "),
              std::string::npos)
        << "stated, not left to the default";
    // A garment fabric bends over its own weight within centimetres (docs/theory/materials.md
    // 1 and 2).
    EXPECT_GT(bending_length(card.material), 0.005);
    EXPECT_LT(bending_length(card.material), 0.035);
  }
}

// docs/theory/materials.md 1: the paper's cotton has a bending length of 15.5 mm in the reading
// that makes it a fabric, and E h = 1.318e5 N/m at the thickness which agrees with it.
TEST(MaterialCards, PaperCottonAsDerived) {
  EXPECT_NEAR(bending_length(load_material("paper-cotton").material), 15.5e-3, 0.1e-3);
  const fabric::Material literal = load_material("paper-cotton-literal").material;
  EXPECT_NEAR(literal.stiffness_warp, 1.318e5, 0.001e5);
  EXPECT_NEAR(literal.stiffness_shear, 5.73e4, 0.01e4);
}

TEST(MaterialConstants, IsotropicPairReportsTheContradiction) {
  // 6.65 GPa over a real fabric thickness of 0.3 mm: bending would be 1.5e-2 N m.
  const auto toml = "youngs_modulus = 6.65e8\nelastic_thickness = 0.0003\n";
  const scenario::MaterialCard card = overridden(toml);
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
  fabric::Material m = load_material("denim").material;
  m.damping = 0.1 + 0.2;
  const std::string text = material_toml(m);
  EXPECT_EQ(material_toml(overridden(text).material), text);
}

// Every KES figure of every card against the constant in use.
TEST(MaterialCards, KesFiguresAreTheConstantsInUse) {
  int figures = 0, constants = 0;
  for (const std::string& name : material_names()) {
    const scenario::MaterialCard card = load_material(name);
    const fabric::Material& m = card.material;
    for (const scenario::KesFigure& f : card.kes) {
      SCOPED_TRACE(name + " " + f.key);
      ++figures;
      const double si = fabric::kes_to_si(f.unit.quantity, f.value);
      const auto expect_used = [&](double used, double per_figure) {
        ++constants;
        EXPECT_TRUE(fabric::same_within_rounding(f.value, si, used * per_figure)) << used;
      };
      const bool warp = f.key.find("_weft") == std::string::npos;
      const bool weft = f.key.find("_warp") == std::string::npos;
      if (f.unit.quantity == "B" && warp) expect_used(m.bending_warp, 1);
      if (f.unit.quantity == "B" && weft) expect_used(m.bending_weft, 1);
      if (f.unit.quantity == "2HB" && warp) expect_used(m.bending_hysteresis_warp, 2);
      if (f.unit.quantity == "2HB" && weft) expect_used(m.bending_hysteresis_weft, 2);
      if (f.unit.quantity == "G") expect_used(m.stiffness_shear, 1);
      if (f.unit.quantity == "EMT" && warp) expect_used(490.3325 / m.stiffness_warp, 1);
      if (f.unit.quantity == "EMT" && weft) expect_used(490.3325 / m.stiffness_weft, 1);
    }
  }
  EXPECT_GT(figures, 15);
  EXPECT_GT(constants, 20);
}

// docs/theory/materials.md 3: residual curvature HB/B of the three fabrics of Matsudaira 2015.
TEST(MaterialCards, ResidualCurvaturesAsMeasured) {
  const std::pair<const char*, double> expected[] = {
      {"cotton-broad", 52.54}, {"wool-tropical", 24.63}, {"polyester-faille", 18.42}};
  for (const auto& [name, curvature] : expected) {
    const fabric::Material m = load_material(name).material;
    EXPECT_NEAR(m.bending_hysteresis_warp / m.bending_warp, curvature, 0.005) << name;
    EXPECT_NEAR(m.bending_hysteresis_weft / m.bending_weft, curvature, 0.005) << name;
  }
}

TEST(MaterialCards, MeasuredWoolIsTheSample) {
  const fabric::Material m = load_material("wool-measured").material,
                         sample = support::wool_sample();
  ASSERT_EQ(m.curve_warp.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(m.curve_warp[i].force, sample.curve_warp[i].force);
    EXPECT_EQ(m.curve_weft[i].strain, sample.curve_weft[i].strain);
    EXPECT_EQ(m.curve_shear[i].force, sample.curve_shear[i].force);
  }
  EXPECT_DOUBLE_EQ(m.stiffness_weft, fabric::StressCurve::tension(m.curve_weft).at(0).tangent);
}

TEST(Kes, GivesTheConstantWhenTheSiFigureIsAbsent) {
  const fabric::Material m = overridden(
                                 "[kes]\nB_warp = 0.1\nB_weft = 0.05\n2HB = 0.06\nG = 0.5\n"
                                 "W = 14\nT = 0.4\nEMT_warp = 5\nLT_warp = 0.7\nMIU = 0.2\n")
                                 .material;
  EXPECT_DOUBLE_EQ(m.bending_warp, 9.80665e-6);
  EXPECT_DOUBLE_EQ(m.bending_weft, 4.903325e-6);
  EXPECT_DOUBLE_EQ(m.bending_hysteresis_weft, 0.03 * 9.80665e-3);
  EXPECT_NEAR(m.stiffness_shear, 28.094, 1e-3);
  EXPECT_DOUBLE_EQ(m.areal_density, 0.14);
  EXPECT_DOUBLE_EQ(m.thickness, 4e-4);
  EXPECT_NEAR(m.stiffness_warp, 9806.65, 1e-6);
  EXPECT_EQ(m.stiffness_weft, 2000) << "no EMT_weft";
  EXPECT_NEAR(overridden("[kes]\nEMT = 40\nEMT_load = 50\n").material.stiffness_weft, 122.58, 0.01);
}

TEST(Kes, DisagreementNamesBothFigures) {
  const std::string no = refusal("bending_warp = 1.3e-5\n[kes]\nB = 0.118\n");
  EXPECT_NE(no.find("bending_warp: found 1.3e-05, expected 1.15718e-05, which is kes.B = 0.118 gf"),
            std::string::npos)
      << no;
  EXPECT_EQ(refusal("bending_warp = 1.16e-5\n[kes]\nB = 0.118\n"), "accepted");
  EXPECT_NE(refusal("[kes]\n2HB_wrap = 0.1\n").find("did you mean \"2HB_warp\"?"),
            std::string::npos);
  EXPECT_NE(refusal("[kes]\nB = 0.1\nB_warp = 0.1\n").find("either B"), std::string::npos);
  const std::string si = refusal("[kes]\nB = 4.4e-6\n");
  EXPECT_NE(si.find("m.toml:2: kes.B"), std::string::npos) << si;
  EXPECT_NE(si.find("units of the KES instruments"), std::string::npos) << si;
}

TEST(Kes, FiguresHaveTheRangesOfTheConstantsThatTheyBecome) {
  struct Figure {
    const char* key;
    double factor;     ///< to SI, by hand (docs/theory/materials.md 5)
    double low, high;  ///< of the constant [SI]
  };
  const Figure figures[] = {{"W", 0.01, 0.01, 5},
                            {"T", 1e-3, 5e-5, 5e-3},
                            {"G", 56.188, 0.1, 1e6},
                            {"B_warp", 9.80665e-5, 1e-8, 1e-3},
                            {"2HB_weft", 9.80665e-3 / 2, 0, 0.1}};
  for (const Figure& f : figures) {
    const auto said = [&](double figure) {
      return refusal("[kes]\n" + std::string(f.key) + " = " + std::to_string(figure) + "\n");
    };
    EXPECT_EQ(said(0.98 * f.high / f.factor), "accepted") << f.key;
    EXPECT_NE(said(1.02 * f.high / f.factor).find(f.key), std::string::npos);
    if (f.low > 1e-5 * f.factor) {  // else too small for six decimals
      EXPECT_EQ(said(1.02 * f.low / f.factor), "accepted") << f.key;
      EXPECT_NE(said(0.98 * f.low / f.factor).find(f.key), std::string::npos);
    }
  }
}

TEST(Kes, NoElongationAndLoadTogetherLeaveTheRangeOfStiffness) {
  std::mt19937 random(29);
  const auto drawn = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  int taken = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const double emt = drawn(1e-3, 1e5), load = drawn(1, 1e4);
    const std::string text =
        "[kes]\nEMT = " + std::to_string(emt) + "\nEMT_load = " + std::to_string(load) + "\n";
    if (refusal(text) != "accepted") continue;
    ++taken;
    const double stiffness = overridden(text).material.stiffness_warp;
    EXPECT_TRUE(stiffness >= 1 && stiffness <= 1e6) << text;
  }
  EXPECT_GT(taken, 50);
}

scenario::MaterialCard own_card(const std::string& text) {
  const support::ScratchFolder scratch;
  const auto path = scratch / "card.toml";
  std::ofstream(path) << text;
  return read_material_file(path);
}

// A card may be written from a KES sheet alone; what the instruments do not tell is still required.
TEST(Kes, MakesACompleteCard) {
  const std::string sheet =
      "title = \"own\"\nsource = \"own measurement\"\npoisson = 0\nfriction_body = 0.4\n"
      "friction_self = 0.4\ndamping = 0.02\n[kes]\nW = 12\nT = 0.5\nB = 0.045\n2HB = 0.04\n"
      "EMT_warp = 3\nEMT_weft = 6\n";
  const fabric::Material m = own_card(sheet + "G = 0.7\n").material;
  EXPECT_DOUBLE_EQ(m.areal_density, 0.12);
  EXPECT_DOUBLE_EQ(m.stiffness_warp, 2 * m.stiffness_weft);
  try {
    own_card(sheet);
    FAIL() << "no shear stiffness";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("stiffness_shear: found nothing"), std::string::npos);
  }
  const std::string curve = "[curve.shear]\nangle = [0.1]\nstress = [4]\n";
  EXPECT_NEAR(own_card(sheet + curve).material.stiffness_shear, 40, 0.1);
}

TEST(Curves, AreReadAsForceOrAsStress) {
  const fabric::Material force =
      overridden("[curve.warp]\nelongation = [0, 0.1, 0.2]\nforce = [0, 50, 150]\n").material;
  ASSERT_EQ(force.curve_warp.size(), 3u);
  EXPECT_DOUBLE_EQ(force.stiffness_warp, 500);
  EXPECT_TRUE(force.curve_weft.empty());
  const fabric::Material stress =
      overridden("[curve.warp]\ngreen_strain = [0.105]\nsecond_piola_kirchhoff = [50]\n").material;
  EXPECT_NEAR(stress.curve_warp[0].strain, 0.1, 1e-15);
  EXPECT_NEAR(stress.curve_warp[0].force, 55, 1e-12);
  const fabric::Material shear =
      overridden("[curve.shear]\nangle = [0.5]\nstress = [20]\n").material;
  EXPECT_DOUBLE_EQ(shear.curve_shear[0].strain, std::sin(0.5));
}

TEST(Curves, BadOnesAreRefusedWithPlaceAndReason) {
  const std::string falling = refusal("[curve.weft]\nelongation = [0.1, 0.2]\nforce = [50, 40]\n");
  EXPECT_NE(falling.find("m.toml:3: curve.weft.force, point 2: found force 40"), std::string::npos)
      << falling;
  EXPECT_NE(refusal("[curve.weft]\nelongation = [0.1, 0.2]\nforce = [50]\n")
                .find("found 1 numbers, expected 2, one for every elongation"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.weft]\nelongation = [10]\nforce = [50]\n").find("10 % is 0.1"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.weft]\nforce = [50]\n").find("elongation: found nothing"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.weft]\nelongation = [0.1]\nforce = [50]\ngreen_strain = [0.1]\n")
                .find("either elongation with force or"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.wrap]\nforce = [50]\n").find("did you mean \"warp\"?"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.warp]\nforces = [50]\n").find("did you mean \"force\"?"),
            std::string::npos);
  EXPECT_NE(refusal("[curve.warp]\nelongation = [0.1]\nforce = [0.01]\n").find("initial slope"),
            std::string::npos);
  EXPECT_NE(refusal("stiffness_warp = 100\n[curve.warp]\nelongation = [0.1]\nforce = [50]\n")
                .find("either stiffness_warp or curve.warp"),
            std::string::npos);
}

scenario::MaterialCard wool_with(const std::string& text) {
  const ConfigNode node = parse_toml(text, "m.toml");
  ConfigReader table(node, "m.toml");
  scenario::MaterialCard card = load_material("wool-measured");
  read_material_constants(table, card);
  table.finish();
  return card;
}

TEST(Curves, ReadBackToTheSamePoints) {
  const std::string text = material_toml(load_material("wool-measured").material);
  EXPECT_NE(text.find("curve.warp.elongation = ["), std::string::npos) << text;
  EXPECT_EQ(text.find("stiffness_"), std::string::npos) << text;
  EXPECT_EQ(material_toml(wool_with(text).material), text);
  EXPECT_EQ(material_toml(overridden(text).material), text) << "over another card, too";
}

TEST(Curves, AStiffnessTakesTheirPlace) {
  const scenario::MaterialCard card = wool_with("stiffness_warp = 800\n");
  EXPECT_TRUE(card.material.curve_warp.empty());
  EXPECT_FALSE(card.material.curve_weft.empty());
  ASSERT_EQ(card.notes.size(), 1u);
  const std::string text = material_toml(card.material);
  EXPECT_EQ(material_toml(wool_with(text).material), text);
  const fabric::Material isotropic =
      wool_with("youngs_modulus = 1e6\nelastic_thickness = 3e-4\n").material;
  EXPECT_TRUE(isotropic.curve_weft.empty() && isotropic.curve_shear.empty());
}

TEST(LoadMaterial, UnknownNameGetsAGuess) {
  try {
    load_material("polyster");
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_EQ(e.hint(), "did you mean \"polyester\"?");
  }
}

TEST(Kes, WrongShapesNameTheKeysThatHaveIt) {
  const std::string pair = refusal("[kes]\nEMT = [5, 6]\n");
  EXPECT_NE(pair.find("m.toml:2: kes.EMT: found an array of 2, expected one number in %"),
            std::string::npos)
      << pair;
  EXPECT_NE(pair.find("EMT_warp and EMT_weft"), std::string::npos) << pair;
  for (const char* quantity : {"B", "2HB", "LT", "WT", "RT"}) {
    const std::string q = quantity;
    const std::string no = refusal("[kes]\n" + q + " = { warp = 1, weft = 2 }\n");
    EXPECT_NE(no.find(q + "_warp and " + q + "_weft"), std::string::npos) << no;
  }
  const std::string text = refusal("[kes]\nEMT_warp = \"5 %\"\n");
  EXPECT_NE(text.find("one number in %"), std::string::npos) << text;
  const std::string shear = refusal("[kes]\nG_warp = 0.5\n");
  EXPECT_NE(shear.find("kes.G_warp: found a key of its own, expected G alone"), std::string::npos)
      << shear;
}

TEST(Kes, ACardTellsAllThatItLacksAtOnce) {
  try {
    own_card("title = \"own\"\npoisson = 0\n[kes]\nW = 12\nT = 0.5\nB = 0.045\nEMT = 3\n");
    FAIL() << "no source, shear, friction, damping";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find(
                  "source, stiffness_shear, friction_body, friction_self, damping: found nothing"),
              std::string::npos)
        << e.what();
    EXPECT_NE(e.hint().find("friction_body (a coefficient from 0 to 3)"), std::string::npos)
        << e.hint();
  }
  try {
    own_card("sourse = \"own\"\n");
    FAIL() << "a misspelt key";
  } catch (const InvalidInput& e) {
    EXPECT_EQ(e.hint(), "did you mean \"source\"?") << e.what();
  }
}

// Beyond the range of its constants a drape is extrapolated, so no card may leave it open.
TEST(MaterialFile, EveryShippedCardSaysHowFarItsTensionHoldsAndWhereThatIsFrom) {
  for (const std::string& name : material_names()) {
    const scenario::MaterialCard card = load_material(name);
    EXPECT_GT(card.material.valid_strain_warp, 0) << name;
    EXPECT_GT(card.material.valid_strain_weft, 0) << name;
    EXPECT_FALSE(card.valid_strain_source.empty()) << name;
  }
}

TEST(MaterialFile, ACurveIsValidUpToItsLastPoint) {
  const fabric::Material wool = load_material("wool-measured").material;
  // Green strain 0.1142 and 0.01361: λ = √(1 + 2 E).
  EXPECT_NEAR(wool.valid_strain_weft, std::sqrt(1 + 2 * 0.1142) - 1, 1e-12);
  EXPECT_NEAR(wool.valid_strain_warp, std::sqrt(1 + 2 * 0.01361) - 1, 1e-12);
  EXPECT_NEAR(wool.valid_shear, std::asin(0.14), 1e-12);
}

TEST(MaterialFile, AnotherStiffnessIsNotValidAsFarAsThatOfTheCardWas) {
  const auto own = [](const std::string& text) {
    return parse_scenario("[material]\nname = \"wool-measured\"\n" + text, "m.toml")
        .studied()
        .material.material;
  };
  EXPECT_EQ(own("stiffness_weft = 900\n").valid_strain_weft, 0);
  EXPECT_GT(own("stiffness_weft = 900\n").valid_strain_warp, 0);
  EXPECT_EQ(own("stiffness_weft = 900\nvalid_strain_weft = 0.3\n").valid_strain_weft, 0.3);
  EXPECT_EQ(own("kes.EMT_weft = 6\n").valid_strain_weft, 0.06);
}

TEST(MaterialFile, AKnitStatesItsStretchAndAnotherStiffnessHasNone) {
  const auto own = [](const std::string& text) {
    return parse_scenario("[material]\nname = \"cotton-jersey\"\n" + text, "m.toml")
        .studied()
        .material.material;
  };
  for (const std::string name : {"cotton-jersey", "cotton-rib", "compression-knit"}) {
    const fabric::Material knit = load_material(name).material;
    EXPECT_GT(knit.stretch_weft, knit.valid_strain_weft) << name;
    EXPECT_EQ(knit.gives_weft(), knit.stretch_weft) << name;
  }
  EXPECT_EQ(load_material("cotton-shirting").material.stretch_weft, 0) << "a woven";
  EXPECT_EQ(own("stiffness_weft = 900\n").stretch_weft, 0);
  EXPECT_GT(own("stiffness_weft = 900\n").stretch_warp, 0);
  EXPECT_EQ(own("stiffness_weft = 900\nstretch_weft = 0.6\n").stretch_weft, 0.6);
}

// A resolved scenario gives the same cloth when it is read again.
TEST(MaterialFile, TheStretchOfAKnitIsWrittenOutAndReadAgain) {
  const scenario::Scenario first =
      parse_scenario("[material]\nname = \"cotton-rib\"\nstretch_weft = 0.7\n", "m.toml");
  const scenario::Scenario again = parse_scenario(scenario_toml(first), "again.toml");
  EXPECT_EQ(again.studied().material.material.stretch_weft, 0.7);
  EXPECT_EQ(again.studied().material.material.stretch_warp,
            load_material("cotton-rib").material.stretch_warp);
}

}  // namespace
}  // namespace loosefit::io
