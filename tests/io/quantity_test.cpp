#include "loosefit/io/pieces/quantity.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace loosefit::io {
namespace {

using Pair = std::pair<int, int>;  // as drawn, mirrored

Pair counts(const std::optional<PieceCount>& count) {
  return count ? Pair(count->as_drawn, count->mirrored) : Pair(-1, -1);
}

Pair halves(int n) { return n % 2 == 0 ? Pair(n / 2, n / 2) : Pair(n, 0); }

TEST(PieceQuantity, OneNumberInEveryWayOfWritingItIsTheSameCount) {
  for (int n = 1; n <= 12; ++n) {
    const std::string digits = std::to_string(n);
    for (const std::string& value :
         {digits, " " + digits + " ", digits + ",0", digits + ".0", digits + ",00", "x" + digits,
          digits + "x", digits + " x", "\xc3\x97" + digits, "Cut " + digits, "CUT: " + digits,
          "cut x" + digits, digits + " pcs",
          digits + " St\xc3\xbc"
                   "ck",
          "QTY=" + digits})
      EXPECT_EQ(counts(read_quantity(value)), halves(n)) << value;
    for (const std::string& text :
         {"gore, cut " + digits, "Gore QTY " + digits + " self", "gore x" + digits + " (fabric)",
          digits + " pieces of the gore", "Anzahl: " + digits, "zuschneiden: " + digits + "x",
          "Couper " + digits + " fois", "cortar " + digits, "cut " + digits + " on the fold"})
      EXPECT_EQ(counts(find_quantity(text)), halves(n)) << text;
    EXPECT_EQ(counts(find_quantity(digits + " pairs")), Pair(n, n));
    EXPECT_EQ(counts(find_quantity("cut " + digits + " identical")), Pair(n, 0));
    EXPECT_EQ(counts(find_quantity("cut " + digits + ", not mirrored")), Pair(n, 0));
    EXPECT_EQ(counts(read_quantity(digits + "," + std::to_string(n))), Pair(n, n));
  }
}

TEST(PieceQuantity, WordsForNumbersAndPairsCount) {
  EXPECT_EQ(counts(find_quantity("cut two, mirrored")), Pair(1, 1));
  EXPECT_EQ(counts(find_quantity("cut one")), Pair(1, 0));
  EXPECT_EQ(counts(find_quantity("sleeve, 1 pair")), Pair(1, 1));
  EXPECT_EQ(counts(find_quantity("cut a pair")), Pair(1, 1));
  EXPECT_EQ(counts(find_quantity("1 Paar")), Pair(1, 1));
  EXPECT_EQ(counts(read_quantity("two")), Pair(1, 1));
  EXPECT_EQ(counts(read_quantity("2 mirrored")), Pair(1, 1));
  EXPECT_EQ(counts(read_quantity("0")), Pair(0, 0));
  EXPECT_EQ(counts(read_quantity("1,1")), Pair(1, 1));
  EXPECT_EQ(counts(read_quantity("0,1")), Pair(0, 1));
}

TEST(PieceQuantity, SaysHowItWasReadWhereThatIsNotPlain) {
  EXPECT_EQ(read_quantity("2,0")->doubt, "the number 2: half of them as drawn, half mirrored");
  EXPECT_EQ(read_quantity("2,0")->said, "2,0");
  EXPECT_TRUE(read_quantity("1,0")->doubt.empty());
  EXPECT_TRUE(read_quantity("2")->doubt.empty());
  EXPECT_FALSE(read_quantity("1,5")->doubt.empty());
  EXPECT_FALSE(find_quantity("cut 1, mirrored")->doubt.empty());
}

TEST(PieceQuantity, SizesMeasuresAndOtherClothsAreNoCounts) {
  for (const char* text :
       {"FRONT 2X", "100 x 100 mm", "size 38", "front 2", "1.5 cm seam allowance",
        "pattern 3 of 12", "cut on fold", "sleeve_x5F_left", "cut 2 from lining", "Cut 2 Fusible",
        "1,5 x", "armhole"})
    EXPECT_EQ(counts(find_quantity(text)), Pair(-1, -1)) << text;
  for (const char* value : {"", "some", "1.5", "-", "many pieces", "12345"})
    EXPECT_EQ(counts(read_quantity(value)), Pair(-1, -1)) << value;
  EXPECT_EQ(counts(find_quantity("cut 2 from lining; cut 1 from main fabric")), Pair(1, 0));
  EXPECT_EQ(counts(find_quantity("cut 4 self, cut 2 lining")), Pair(2, 2));
}

TEST(PieceQuantity, NumbersWithUnitsAndTurnsOfAHemAreNoCounts) {
  for (int n = 1; n <= 12; ++n) {
    const std::string d = std::to_string(n);
    for (const char* unit : {"\"", " in", " cm", "cm", " mm", " m", " inch", "\xe2\x80\xb3",
                             "\xc2\xb0", "'", " deg", "%"})
      for (const std::string& text :
           {"test square " + d + unit + " x " + d + unit, "Cut " + d + unit + " below line",
            "square " + d + " x " + d + unit, "cut " + d + " x " + d + unit})
        EXPECT_EQ(counts(find_quantity(text)), Pair(-1, -1)) << text;
    for (const std::string& text :
         {"turn hem " + d + " times", "Saum " + d + " mal einschlagen", "plier " + d + " fois",
          "cut on fold, turn hem " + d + " times"})
      EXPECT_EQ(counts(find_quantity(text)), Pair(-1, -1)) << text;
    for (const std::string& text : {"cut sleeve " + d + " times", d + " mal zuschneiden",
                                    "\"cut " + d + "\"", "cut " + d + " in main fabric"})
      EXPECT_EQ(counts(find_quantity(text)), halves(n)) << text;
  }
}

TEST(PieceQuantity, CapitalsHandsAndWordsAreRead) {
  for (int n = 1; n <= 12; ++n) {
    const std::string d = std::to_string(n);
    for (const std::string& text :
         {"SLEEVE X" + d, "X" + d, "gore, " + d + " Teile", "Quantity " + d + ".0", "Amount: " + d})
      EXPECT_EQ(counts(find_quantity(text)), halves(n)) << text;
    EXPECT_EQ(counts(read_quantity(d + " (MIRRORED)")).first, (n + 1) / 2);
    for (int m = 1; m <= 3; ++m) {
      const std::string e = std::to_string(m);
      for (const std::string& text : {"cut " + d + " left, " + e + " right", "cut " + d + "+" + e,
                                      "Quantity: " + d + "L " + e + "R"})
        EXPECT_EQ(counts(find_quantity(text)), Pair(n, m)) << text;
      EXPECT_EQ(counts(read_quantity(d + "L " + e + "R")), Pair(n, m));
    }
  }
  for (const char* six : {"six", "sechs", "seis", "sei", "zes"})
    EXPECT_EQ(counts(find_quantity(std::string("Cut ") + six)), Pair(3, 3)) << six;
}

TEST(PieceQuantity, NumbersOfPiecesAndTwinsInTheWordsOfManyFiles) {
  for (int n = 1; n <= 12; ++n) {
    const std::string d = std::to_string(n);
    for (const std::string& text : {"No. of pieces: " + d, "Number of pieces " + d,
                                    "nb de pi\xc3\xa8"
                                    "ces : " +
                                        d,
                                    "PI\xc3\x88"
                                    "CES: " +
                                        d,
                                    "St\xc3\xbc"
                                    "ck: " +
                                        d,
                                    "Anz. " + d, "Teile: " + d, "cut (" + d + ")",
                                    "Cut [" + d + "]", "Cut-" + d, "copies: " + d, d + " required"})
      EXPECT_EQ(counts(find_quantity(text)), halves(n)) << text;
    for (const std::string& text : {d + " + mirror", d + "+mirror", d + " + " + d + " mirrored",
                                    d + " and " + d + " reversed", "cut: " + d + " + mirror",
                                    d + " und " + d + " gespiegelt"}) {
      EXPECT_EQ(counts(find_quantity(text)), Pair(n, n)) << text;
      EXPECT_EQ(counts(read_quantity(text)), Pair(n, n)) << text;
    }
  }
  EXPECT_EQ(counts(find_quantity("cut left and right")), Pair(1, 1));
  EXPECT_EQ(counts(find_quantity("Cut L + R")), Pair(1, 1));
}

TEST(PieceQuantity, WordsOfACountThatAreNotUnderstoodAreKnownAsSuch) {
  for (const char* text : {"cut both left", "cut for size 38", "2 reversed sides"})
    EXPECT_TRUE(speaks_of_count(text)) << text;
  for (const char* text : {"cut 2", "front", "cut on fold", "size 38", "Teil 2", "N 7"})
    EXPECT_FALSE(speaks_of_count(text)) << text;
}

TEST(PieceQuantity, NamesKeepWhatIsNoCount) {
  for (const auto& [text, name] :
       {std::pair{"sleeve x2", "sleeve"}, std::pair{"gore, cut 2, mirrored", "gore"},
        std::pair{"2x cuff", "cuff"}, std::pair{"yoke (cut 2)", "yoke"}}) {
    std::string rest;
    ASSERT_TRUE(find_quantity(text, &rest)) << text;
    EXPECT_EQ(rest, name);
  }
}

TEST(PieceQuantity, KeysThatCountPieces) {
  for (const char* key : {"Quantity", "QTY", "cut", "Cut Quantity", "Anzahl", "No. of pieces",
                          "Nr of Pieces", "Number of pieces",
                          "Nb de pi\xc3\xa8"
                          "ces",
                          "Anzahl Teile", "Pieces", "cut-no"})
    EXPECT_TRUE(counts_pieces(key)) << key;
  for (const char* key : {"data_x", "Piece Name", "No.", "Number", "size"})
    EXPECT_FALSE(counts_pieces(key)) << key;
}

}  // namespace
}  // namespace loosefit::io
