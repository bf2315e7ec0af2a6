#include "loosefit/drape/putting_on.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "loosefit/drape/openings.h"
#include "loosefit/garment/assemble.h"
#include "support/placed_top.h"

namespace loosefit::drape {
namespace {

using kinds::OpeningUse;

/// A rim of straight pieces in drawn directions of the cloth, so long as cut.
Rim drawn_rim(OpeningUse use, double cut, std::mt19937& draw, int piece = 0) {
  std::uniform_real_distribution<double> share(0.2, 1), turn(0, 2 * kPi);
  Rim rim;
  rim.opening.use = use;
  rim.opening.piece = piece;
  rim.name = "the rim";
  double sum = 0;
  for (int k = 0; k < 9; ++k) {
    const double angle = turn(draw), length = share(draw);
    rim.parts.push_back({k, k + 1, length * Vec2(std::cos(angle), std::sin(angle))});
    sum += length;
  }
  for (Rim::Part& part : rim.parts) part.way *= cut / sum;
  return rim;
}

/// All of a rim along the weft.
Rim along_weft(OpeningUse use, double cut, int piece = 0) {
  Rim rim;
  rim.opening.use = use;
  rim.opening.piece = piece;
  rim.opening.girth = cut;
  rim.name = "the rim";
  rim.parts = {{0, 1, Vec2(cut / 2, 0)}, {1, 0, Vec2(-cut / 2, 0)}};
  return rim;
}

fabric::Material cloth(double warp, double weft) {
  fabric::Material m;
  m.name = "drawn cloth";
  m.valid_strain_warp = warp;
  m.valid_strain_weft = weft;
  return m;
}

body::PassingGirths woman() {
  body::PassingGirths g;
  g.head = 0.55;
  g.hand = {0.19, 0.19};
  g.foot = {0.31, 0.31};
  g.chest = 0.92;
  g.hip = 0.98;
  return g;
}

std::optional<bool> possible(const std::vector<Rim>& rims, const fabric::Material& material,
                             const body::PassingGirths& girths = woman()) {
  return putting_on(rims, girths, material).possible();
}

// A square that is sheared keeps its sides and gets a longer diagonal: √(2 + 2 sin γ).
TEST(PuttingOn, ShearMakesABiasEdgeLongerAndNoStraightOne) {
  Rim bias;
  bias.parts = {{0, 1, Vec2(0.1, 0.1)}, {1, 2, Vec2(-0.1, 0.1)}};
  for (const double shear : {0.05, 0.2, 0.4})
    EXPECT_NEAR(bias.stretched(0, 0, shear), 0.2 * std::sqrt(2 + 2 * std::sin(shear)), 1e-12);
  EXPECT_NEAR(along_weft(OpeningUse::neck, 0.5).stretched(0.3, 0.1, 0.4), 0.55, 1e-12);
}

// Every piece gets longer by the strains of its two directions.
TEST(PuttingOn, ARimOpensByTheStrainsOfItsDirections) {
  std::mt19937 draw(1);
  std::uniform_real_distribution<double> strain(0.01, 0.6), girth(0.2, 1.2);
  for (int k = 0; k < 100; ++k) {
    const Rim rim = drawn_rim(OpeningUse::neck, girth(draw), draw);
    const double warp = strain(draw), weft = strain(draw);
    double sum = 0;
    for (const Rim::Part& p : rim.parts) {
      const double length = p.way.norm(), c = p.way.x() / length, s = p.way.y() / length;
      sum += length * std::sqrt(c * c * (1 + weft) * (1 + weft) + s * s * (1 + warp) * (1 + warp));
    }
    const fabric::Material material = cloth(warp, weft);
    EXPECT_NEAR(rim.opened(material), sum, 1e-12);
    EXPECT_GE(sum, rim.cut() * (1 + std::min(warp, weft)) - 1e-12);
    EXPECT_LE(sum, rim.cut() * (1 + std::max(warp, weft)) + 1e-12);
    EXPECT_NEAR(drawn_rim(OpeningUse::neck, 0.5, draw).stretched(0.2, 0.2, 0), 0.6, 1e-12);
  }
}

// Tubes of drawn girth and strain against drawn girths of the body.
TEST(PuttingOn, WhatIsWiderThanTheOpenedRimDoesNotPass) {
  std::mt19937 draw(2);
  std::uniform_real_distribution<double> strain(0.01, 1), girth(0.1, 1.3);
  struct Through {
    OpeningUse use;
    std::function<void(body::PassingGirths&, double)> set;
  };
  const Through ways[] = {
      {OpeningUse::neck, [](auto& g, double x) { g.head = x; }},
      {OpeningUse::left_arm, [](auto& g, double x) { g.hand[0] = x; }},
      {OpeningUse::right_arm, [](auto& g, double x) { g.hand[1] = x; }},
      {OpeningUse::left_leg, [](auto& g, double x) { g.foot[0] = x; }},
      {OpeningUse::right_leg, [](auto& g, double x) { g.foot[1] = x; }},
      {OpeningUse::waist, [](auto& g, double x) { g.hip = x; }},
  };
  int passed = 0, stopped = 0;
  for (int k = 0; k < 120; ++k) {
    const Through& way = ways[k % std::size(ways)];
    const double cut = girth(draw), weft = strain(draw), body_girth = girth(draw);
    body::PassingGirths girths = woman();
    way.set(girths, body_girth);
    const double left = way.use == OpeningUse::waist ? 0.97 : 1;  // flesh gives way
    const bool passes = cut * (1 + weft) >= left * body_girth;
    EXPECT_EQ(possible({along_weft(way.use, cut)}, cloth(0.01, weft), girths), passes)
        << cut << " " << weft << " " << body_girth;
    ++(passes ? passed : stopped);
  }
  EXPECT_GT(std::min(passed, stopped), 20) << "both happen";
}

TEST(PuttingOn, TheReasonNamesTheOpeningAndAllFigures) {
  Rim neck = along_weft(OpeningUse::neck, 0.38);
  neck.name = "the neck";
  const PuttingOn judged = putting_on({neck}, woman(), cloth(0.1, 0.1));
  EXPECT_EQ(judged.reasons(),
            std::vector<std::string>{"the neck opens to 0.418 m in drawn cloth, 0.380 m as cut, "
                                     "and has to let pass 0.550 m (the head)"});
}

TEST(PuttingOn, AStatedStretchOfAKnitCountsBeyondTheRangeOfItsLaw) {
  fabric::Material knit = cloth(0.167, 0.167);
  const std::vector<Rim> ankle = {along_weft(OpeningUse::left_leg, 0.20)};
  EXPECT_EQ(possible(ankle, knit), false);
  knit.stretch_weft = 0.75;
  EXPECT_EQ(possible(ankle, knit), true);
  knit.stretch_weft = 0, knit.stretch_warp = 0.75;
  EXPECT_EQ(possible(ankle, knit), false) << "the rim runs along the weft";
}

// From below over the hips, or from above over the chest, hem and all.
TEST(PuttingOn, ASkirtOverTheHipsOrOverTheChest) {
  const auto skirt = [](double top, double hem) {
    return possible({along_weft(OpeningUse::upper, top), along_weft(OpeningUse::hem, hem)},
                    cloth(0.05, 0.05));
  };
  EXPECT_EQ(skirt(0.91, 0.60), true) << "over the hips, whatever the hem";
  EXPECT_EQ(skirt(0.86, 1.20), true) << "over the chest";
  EXPECT_EQ(skirt(0.86, 0.80), false) << "its hem is too narrow for the chest";
  EXPECT_EQ(skirt(0.70, 2.00), false);
}

TEST(PuttingOn, TrousersOverTheHipsAlone) {
  const auto trousers = [](double waist) {
    return possible({along_weft(OpeningUse::waist, waist), along_weft(OpeningUse::left_leg, 0.4),
                     along_weft(OpeningUse::right_leg, 0.4)},
                    cloth(0.05, 0.05));
  };
  EXPECT_EQ(trousers(0.91), true);
  EXPECT_EQ(trousers(0.89), false) << "wide enough for the chest";
}

TEST(PuttingOn, ATopOverTheChestUnlessTheHipsPassItsNeck) {
  const auto top = [](double neck, double hem) {
    return possible({along_weft(OpeningUse::neck, neck), along_weft(OpeningUse::hem, hem),
                     along_weft(OpeningUse::left_arm, 0.3), along_weft(OpeningUse::right_arm, 0.3)},
                    cloth(0.05, 0.05));
  };
  EXPECT_EQ(top(0.60, 0.90), true);
  EXPECT_EQ(top(0.60, 0.80), false);
  EXPECT_EQ(top(0.95, 0.80), true) << "stepped into";
  EXPECT_EQ(top(0.40, 0.90), false);
}

TEST(PuttingOn, AJumpsuitIsSteppedIntoThroughItsNeck) {
  const auto jumpsuit = [](double neck) {
    return possible({along_weft(OpeningUse::neck, neck), along_weft(OpeningUse::left_leg, 0.4),
                     along_weft(OpeningUse::right_leg, 0.4)},
                    cloth(0.05, 0.05));
  };
  EXPECT_EQ(jumpsuit(0.60), false);
  EXPECT_EQ(jumpsuit(0.95), true);
}

TEST(PuttingOn, AStockingAndASleeveAloneOverTheEndOfTheirLimb) {
  for (const auto& [limb, girth] : {std::pair(kLeftLeg, 0.31),
                                    {kRightLeg, 0.31},
                                    {kLeftArm, 0.19},
                                    {kRightArm, 0.19},
                                    {kHead, 0.55}}) {
    Rim rim = along_weft(OpeningUse::limb, 0);
    rim.opening.round = round_limb(limb);
    for (const double ratio : {0.98, 1.02}) {
      rim.parts = {{0, 1, Vec2(ratio * girth / 1.05, 0)}};
      EXPECT_EQ(possible({rim}, cloth(0.05, 0.05)), ratio > 1) << limb_name(limb);
    }
  }
}

// An open front leaves no neck; cut holes and slits of pockets are for nothing.
TEST(PuttingOn, WhatIsOpenOrForNothingIsNotAsked) {
  const fabric::Material material = cloth(0.05, 0.05);
  Rim hole = along_weft(OpeningUse::unknown, 0.1);
  hole.opening.is_cut_hole = true;
  EXPECT_EQ(possible({hole, along_weft(OpeningUse::cape_hem, 0.1)}, material), true);
  EXPECT_EQ(possible({hole}, material), std::nullopt);
  Rim slit = along_weft(OpeningUse::unknown, 0.3), waist = along_weft(OpeningUse::waist, 1.1);
  slit.opening.of_legs = waist.opening.of_legs = true;
  EXPECT_EQ(possible({waist, slit}, material), true);
  const std::vector<Rim> jacket = {along_weft(OpeningUse::left_arm, 0.3),
                                   along_weft(OpeningUse::right_arm, 0.3),
                                   along_weft(OpeningUse::unknown, 2)};
  EXPECT_EQ(possible(jacket, material), true);
  // Cloth that has nothing else, as a bag, is not judged.
  EXPECT_EQ(possible({along_weft(OpeningUse::unknown, 0.4), along_weft(OpeningUse::unknown, 0.1)},
                     cloth(0.05, 0.05)),
            std::nullopt);
  EXPECT_EQ(
      possible({along_weft(OpeningUse::unknown, 0.4, 1), along_weft(OpeningUse::neck, 0.6, 0)},
               cloth(0.05, 0.05)),
      std::nullopt);
}

// Arms by their labels; a keyhole hides which of the others is the neck.
TEST(PuttingOn, AnOpeningOfUnknownUseIsNotJudgedWhateverTheOthersAre) {
  const fabric::Material material = cloth(0.05, 0.05);
  std::vector<Rim> top = {
      along_weft(OpeningUse::left_arm, 0.3), along_weft(OpeningUse::right_arm, 0.3),
      along_weft(OpeningUse::unknown, 0.2), along_weft(OpeningUse::unknown, 0.15),
      along_weft(OpeningUse::unknown, 1.1)};
  EXPECT_EQ(possible(top, material), std::nullopt);
  EXPECT_EQ(putting_on(top, woman(), material).not_judged.size(), 1u) << "once for its cloth";
  // The edge over a bare shoulder is no open front.
  EXPECT_EQ(possible({along_weft(OpeningUse::left_arm, 0.3), along_weft(OpeningUse::unknown, 0.2),
                      along_weft(OpeningUse::hem, 1.1)},
                     material),
            std::nullopt);
  // Trousers of which only the legs are known.
  std::vector<Rim> trousers = {along_weft(OpeningUse::left_leg, 0.4),
                               along_weft(OpeningUse::right_leg, 0.4),
                               along_weft(OpeningUse::unknown, 0.5)};
  for (Rim& rim : trousers) rim.opening.of_legs = true;
  EXPECT_EQ(possible(trousers, material), std::nullopt);
}

TEST(PuttingOn, ClothWithoutOpeningsIsNotJudged) {
  EXPECT_EQ(possible({}, cloth(0.05, 0.05)), std::nullopt);
  EXPECT_EQ(putting_on({}, woman(), cloth(0.05, 0.05)).reasons().size(), 1u);
}

TEST(PuttingOn, WhatNobodyStatesIsNotJudgedUnlessItPassesAnyway) {
  const fabric::Material silent = cloth(0.1, 0);
  EXPECT_EQ(possible({along_weft(OpeningUse::neck, 0.50)}, silent), std::nullopt);
  EXPECT_EQ(possible({along_weft(OpeningUse::neck, 0.56)}, silent), true);
  EXPECT_EQ(possible({along_weft(OpeningUse::neck, 0.50), along_weft(OpeningUse::waist, 0.5)},
                     cloth(0.1, 0.1)),
            false);
  body::PassingGirths no_hands = woman();
  no_hands.hand = {};
  const std::vector<Rim> sleeves = {along_weft(OpeningUse::left_arm, 0.3)};
  EXPECT_EQ(possible(sleeves, cloth(0.1, 0.1), no_hands), std::nullopt);
  EXPECT_EQ(putting_on(sleeves, no_hands, cloth(0.1, 0.1)).reasons().size(), 1u);
  EXPECT_EQ(possible(sleeves, cloth(0.1, 0.1), {}), std::nullopt) << "a body without joints";
}

// Cuffs of pattern files, down to those that no hand goes through, are asked; gaps beside them are
// not.
TEST(PuttingOn, NarrowCuffsOfSewnSleevesAreOpeningsForArms) {
  for (const double cuff : {0.11, 0.05, 0.035, 0.025}) {
    testing_support::PlacedTop top;
    top.cuff = cuff;
    pattern::Pattern pattern = top.pattern();
    for (const bool labelled : {true, false}) {
      for (pattern::Panel& panel : pattern.panels)
        if (panel.name.find("sleeve") != std::string::npos) panel.label = labelled ? "arm" : "";
      const garment::Garment sewn = garment::assemble(pattern, 0.02, fabric::Material{});
      int arms = 0;
      for (const Opening& o : garment_openings(sewn, pattern))
        if (o.use == OpeningUse::left_arm || o.use == OpeningUse::right_arm) {
          ++arms;
          EXPECT_NEAR(o.girth, 2 * cuff, 0.01);
        }
      EXPECT_EQ(arms, labelled || 2 * cuff > 0.08 ? 2 : 0) << cuff << ' ' << labelled;
    }
  }
}

// A rim along drawn directions, drawn out by drawn shares.
TEST(OverstretchedRims, AreLongerThanTheClothBears) {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> strain(0.02, 0.8), valid(0.01, 0.6);
  for (int k = 0; k < 100; ++k) {
    Rim rim = drawn_rim(OpeningUse::left_arm, 0.2, draw);
    const double drawn = strain(draw), end = valid(draw), bears = std::max(end, kTears);
    const fabric::Material material = cloth(end, end);
    std::vector<Vec3> x = {Vec3::Zero()};
    for (const Rim::Part& p : rim.parts)
      x.push_back(x.back() + Vec3(0, 0, 1.0) * p.way.norm() * (1 + drawn));
    if (std::abs(drawn - bears) < 1e-6) continue;
    const auto found = overstretched_rims({rim}, x, material);
    EXPECT_EQ(found.size(), drawn > bears ? 1u : 0u) << drawn << " " << end;
    EXPECT_TRUE(overstretched_rims({rim}, x, cloth(0, 0)).empty()) << "nothing is stated";
  }
}

}  // namespace
}  // namespace loosefit::drape
