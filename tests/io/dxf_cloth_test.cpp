#include <gtest/gtest.h>

#include "loosefit/io/dxf/dxf_pieces.h"

namespace loosefit::io {
namespace {

DxfPiece piece(const std::string& fabric, const std::string& category = {},
               const std::string& annotation = {}) {
  DxfPiece p;
  p.fabric = fabric, p.category = category, p.annotation = annotation;
  return p;
}

TEST(DxfCloth, LiningIsAnotherClothWhateverGeneralWordStandsBesideIt) {
  for (const char* text : {"Lining Fabric", "BODY LINING", "Tela de forro", "Tissu doublure",
                           "Tessuto fodera", "Tecido de forro", "stof voering", "LINING",
                           "Interlining 2", "Lining & Interfacing", "Cut 2 Lining"}) {
    EXPECT_EQ(of_other_cloth(piece(text)), std::string("Fabric \"") + text + '"');
    EXPECT_NE(of_other_cloth(piece("", text)), "") << text;
    EXPECT_NE(of_other_cloth(piece("", "", text)), "") << text;
  }
  EXPECT_NE(of_other_cloth(piece("Fabric 2 lining")), "");
}

TEST(DxfCloth, OwnClothCountsFromAnotherPart) {
  for (const char* text :
       {"Self, Lining", "Lining;Self", "shell+lining", "Self & Lining", "Main/Lining",
        "fabric and lining", "Tela, forro", "Tela y forro", "Tissu et doublure",
        "Oberstoff und Futter", "tessuto e fodera", "Body", "Fabric A"}) {
    EXPECT_EQ(of_other_cloth(piece(text)), "");
    EXPECT_EQ(of_other_cloth(piece("", text)), "") << text;
    EXPECT_EQ(of_other_cloth(piece("", "", text)), "") << text;
  }
  EXPECT_EQ(of_other_cloth(piece("", "", "Cut 2 self 2 lining")), "");
  EXPECT_EQ(of_other_cloth(piece("", "", "fusible tape at the neck")), "");
}

TEST(DxfCloth, OwnFabricIsBelievedBeforeTheOtherTexts) {
  EXPECT_EQ(of_other_cloth(piece("SELF", "LINING")), "");
  EXPECT_EQ(of_other_cloth(piece("Shell", "", "Fusible")), "");
  EXPECT_EQ(of_other_cloth(piece("Body", "Lining")), "");
  EXPECT_EQ(of_other_cloth(piece("Cotton", "LINING")), "Category \"LINING\"");
  EXPECT_EQ(of_other_cloth(piece("Fabric 1", "LINING")), "Category \"LINING\"") << "of any cloth";
  EXPECT_EQ(of_other_cloth(piece("LINING", "SHELL")), "Fabric \"LINING\"");
}

}  // namespace
}  // namespace loosefit::io
