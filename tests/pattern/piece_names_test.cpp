#include "loosefit/pattern/piece_names.h"

#include <gtest/gtest.h>

namespace loosefit::pattern {
namespace {

TEST(PieceNames, RtIsABackInGermanAndTheRightOfAnythingElse) {
  EXPECT_TRUE(words_of("RT").back);
  EXPECT_TRUE(words_of("Bluse RT 1").back);
  for (const char* name : {"FRONT_RT", "SLEEVE_RT", "POCKET_RT", "SIDE_RT", "BACK_RT"}) {
    EXPECT_TRUE(words_of(name).right) << name;
    EXPECT_FALSE(words_of(name).left) << name;
  }
  EXPECT_TRUE(words_of("FRONT_RT").front);
  EXPECT_FALSE(words_of("SLEEVE_RT").back);
  EXPECT_TRUE(words_of("BACK_RT").back);
}

TEST(PieceNames, ATwinIsForTheOtherHand) {
  EXPECT_TRUE(words_of("FRONT_L_mirrored").right);
  EXPECT_FALSE(words_of("FRONT_L_mirrored").left);
  EXPECT_TRUE(words_of("SLEEVE_RT_mirrored").left);
  const PieceWords neither = words_of("SLEEVE_mirrored");
  EXPECT_FALSE(neither.left || neither.right);
}

TEST(PieceNames, AHoodieIsNoHood) {
  for (const char* name : {"Hoodie_Front", "hoody back", "Hooded_Tunic_Front", "motherhood_front"})
    EXPECT_FALSE(words_of(name).hood) << name;
  for (const char* name :
       {"hood_L", "Hoodie_Hood", "left_hood", "HoodCentre", "Kapuze", "Kapuzenteil"})
    EXPECT_TRUE(words_of(name).hood) << name;
}

TEST(PieceNames, BacksOfManyLanguages) {
  for (const char* name :
       {"Rock hinten", "ROCK HINTEN", "Derrière", "Trasero", "dos", "achterpand", "Rückenteil"})
    EXPECT_TRUE(words_of(name).back) << name;
}

TEST(PieceNames, WhatSaysBothSaysNeither) {
  const PieceWords both = words_of("front and back, left right");
  EXPECT_FALSE(both.front || both.back || both.left || both.right);
}

}  // namespace
}  // namespace loosefit::pattern
