#include "loosefit/pattern/known_bands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/pattern/known_garment.h"
#include "support/unsewn_garments.h"

namespace loosefit::pattern {
namespace {

using testing_support::unsewn_skirt;
using testing_support::unsewn_trousers;
using testing_support::unsewn_tshirt;
using testing_support::upright_strip;

/// 0 where there is no such seam.
double length_of_second(const Pattern& pattern, const KnownGarment& known,
                        const std::string& name) {
  for (const ChainSeam& seam : known.seams)
    if (seam.name == name) return chain_length(pattern, seam.second);
  return 0;
}

TEST(KnownBands, ANeckbandAndCuffsOfATShirtAreSewnOnAndToThemselves) {
  Pattern pattern = unsewn_tshirt();
  const KnownGarment plain = know_garment(pattern);
  ASSERT_TRUE(plain.certain());
  const double wrist = 2 * 0.9 * 0.155;
  pattern.panels.push_back(upright_strip("neckband", 0.38, 0.03));
  pattern.panels.push_back(upright_strip("cuff_left", 0.9 * wrist, 0.05));
  pattern.panels.push_back(upright_strip("cuff_right", 0.9 * wrist, 0.05));
  const KnownGarment known = know_garment(pattern);
  EXPECT_TRUE(known.certain()) << known.doubts.front();
  EXPECT_EQ(known.seams.size(), plain.seams.size() + 6);
  for (int p = 4; p < 7; ++p) EXPECT_EQ(known.pieces[p].role, PieceRole::band);
  EXPECT_EQ(known.pieces[5].side, 1);
  EXPECT_EQ(known.pieces[6].side, -1);
  EXPECT_NEAR(length_of_second(pattern, known, "band_wrist_L"), wrist, 1e-9);
  EXPECT_NEAR(length_of_second(pattern, known, "band_ends_neck"), 0.03, 1e-9);
  const double neck = length_of_second(pattern, known, "band_neck");
  EXPECT_GT(neck, 0.38);
  EXPECT_LT(neck, 0.45);
}

TEST(KnownBands, AWaistbandGoesRoundAllPiecesOfTrousersAndSkirts) {
  Pattern trousers = unsewn_trousers(0.84);
  trousers.panels.push_back(upright_strip("waistband", 0.80, 0.04));
  KnownGarment known = know_garment(trousers);
  EXPECT_TRUE(known.certain()) << known.doubts.front();
  EXPECT_NEAR(length_of_second(trousers, known, "band_waist"), 0.84, 1e-3);
  // Each edge of the waist ends where the next begins: outseams at the ends and in the middle.
  for (const ChainSeam& seam : known.seams)
    if (seam.name == "band_waist") {
      ASSERT_EQ(seam.second.size(), 4u);
      std::vector<int> panels;
      for (const Stitch::Side& side : seam.second) panels.push_back(side.panel);
      EXPECT_EQ(panels, (std::vector<int>{panels[0], 1 - panels[0], 5 - panels[3], panels[3]}));
      EXPECT_EQ(known.pieces[panels[0]].side, known.pieces[panels[3]].side);
    }
  // As wide at the hem as at the waist: the name tells which.
  Pattern skirt = unsewn_skirt(0.74, 0.76);
  skirt.panels.push_back(upright_strip("waistband", 0.72, 0.04));
  known = know_garment(skirt);
  EXPECT_TRUE(known.certain()) << known.doubts.front();
  EXPECT_NEAR(length_of_second(skirt, known, "band_waist"), 0.74, 1e-9);
}

TEST(KnownBands, WhatOnlyItsLengthTellsIsADoubt) {
  Pattern pattern = unsewn_tshirt();
  pattern.panels.push_back(upright_strip("piece_5", 0.38, 0.03));
  const KnownGarment known = know_garment(pattern);
  EXPECT_FALSE(known.certain());
  EXPECT_NE(known.doubts.front().find("by its length alone"), std::string::npos);
  EXPECT_GT(length_of_second(pattern, known, "band_neck"), 0);
}

TEST(KnownBands, StripsThatNoLoopIsAsLongAsAreNoBands) {
  for (const double length : {0.2, 0.6}) {
    Pattern pattern = unsewn_tshirt();
    pattern.panels.push_back(upright_strip("neckband", length, 0.03));
    const KnownGarment known = know_garment(pattern);
    EXPECT_FALSE(known.certain());
    EXPECT_EQ(known.pieces[4].role, PieceRole::unknown);
    EXPECT_EQ(length_of_second(pattern, known, "band_neck"), 0);
  }
  // Nor is a second one for the same neck.
  Pattern pattern = unsewn_tshirt();
  pattern.panels.push_back(upright_strip("neckband", 0.38, 0.03));
  pattern.panels.push_back(upright_strip("neck tape", 0.38, 0.01));
  const KnownGarment known = know_garment(pattern);
  EXPECT_FALSE(known.certain());
  EXPECT_EQ(known.pieces[5].role, PieceRole::unknown);
}

}  // namespace
}  // namespace loosefit::pattern
