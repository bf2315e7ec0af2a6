#include "loosefit/fabric/kes_units.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::fabric {
namespace {

// docs/theory/materials.md 5: the conversions as derived there, to the digits given.
TEST(KesUnits, FactorsAreThoseDerived) {
  EXPECT_NEAR(kes_to_si("B", 1), 9.80665e-5, 1e-18);
  EXPECT_NEAR(kes_to_si("2HB", 1), 9.80665e-3, 1e-17);
  EXPECT_NEAR(kes_to_si("F", 1), 0.980665, 1e-15);
  EXPECT_NEAR(kes_to_si("G", 1), 56.1880, 5e-5);
  EXPECT_NEAR(kes_to_si("2HG", 1), 0.980665, 1e-15);
  EXPECT_NEAR(kes_to_si("2HG5", 1), 0.980665, 1e-15);
  EXPECT_NEAR(kes_to_si("WT", 1), 0.980665, 1e-15);
  EXPECT_NEAR(kes_to_si("W", 1), 0.01, 1e-18);
  EXPECT_NEAR(kes_to_si("pressure", 1), 133.322, 1e-12);
  EXPECT_NEAR(kes_to_si("FAST-B", 1), 1e-6, 1e-20);
  EXPECT_NEAR(kes_to_si("FAST-B", 1) / kes_unit("B").factor, 0.010197, 5e-7);
}

// Percentages, pure numbers and roughness, and what a card of a cotton shirting says of them.
TEST(KesUnits, OtherFiguresOfTheSheetInSi) {
  EXPECT_DOUBLE_EQ(kes_to_si("EMT", 4.5), 0.045);
  EXPECT_DOUBLE_EQ(kes_to_si("RT", 48), 0.48);
  EXPECT_DOUBLE_EQ(kes_to_si("RC", 52), 0.52);
  for (const char* number : {"LT", "LC", "MIU", "MMD"})
    EXPECT_DOUBLE_EQ(kes_to_si(number, 0.62), 0.62) << number;
  EXPECT_DOUBLE_EQ(kes_to_si("WC", 0.1),
                   0.0980665);  // 0.1 gf cm/cm² = 0.1 · 9.80665e-5 J / 1e-4 m²
  EXPECT_DOUBLE_EQ(kes_to_si("SMD", 5), 5e-6);
  EXPECT_DOUBLE_EQ(kes_to_si("T", 0.37), 0.37e-3);
  EXPECT_EQ(kes_units().size(), 20u) << "a new quantity needs its factor here";
}

TEST(KesUnits, UnknownQuantityGetsAGuess) {
  try {
    kes_unit("2HH");
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_EQ(e.hint(), "did you mean \"2HB\"?");
  }
}

// 500 gf/cm = 490.3 N/m at 5 %: docs/theory/materials.md 5.
TEST(KesUnits, TensileSecant) {
  EXPECT_NEAR(tensile_secant(5), 490.3 / 0.05, 1);
  EXPECT_NEAR(tensile_secant(40, 50), 49.03 / 0.4, 0.01);
}

TEST(Rounding, AcceptsWhatThePrintedDigitsAllow) {
  const double b = kes_unit("B").factor;
  EXPECT_TRUE(same_within_rounding(0.118, 0.118 * b, 1.15718e-5));
  EXPECT_TRUE(same_within_rounding(0.045, 0.045 * b, 4.41e-6));
  EXPECT_TRUE(same_within_rounding(0.12, 0.12 * b, 1.16e-5)) << "0.12 may be 0.1183";
  EXPECT_FALSE(same_within_rounding(0.118, 0.118 * b, 1.10e-5));
  EXPECT_FALSE(same_within_rounding(1, b, 1.03e-4)) << "never more than 2 %";
  EXPECT_FALSE(same_within_rounding(0.045, 0.045 * b, 4.41e-5)) << "another power of ten";
}

}  // namespace
}  // namespace loosefit::fabric
