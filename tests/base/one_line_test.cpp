#include "loosefit/base/one_line.h"

#include <gtest/gtest.h>

namespace loosefit {
namespace {

TEST(OneLine, KeepsWordsOfAllLanguages) {
  for (const std::string text : {"front", "Ärmel links", "前身頃", "10 m² – 5°", "👕", ""})
    EXPECT_EQ(one_line(text), text);
}

TEST(OneLine, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(one_line("\x1b[2Ja\nb\tc\x7f"), "\\x1b[2Ja\\x0ab\\x09c\\x7f");
  EXPECT_EQ(one_line("a\xc2\x9b"
                     "31m"),
            "a\\xc2\\x9b31m")
      << "CSI of Latin-1";
  EXPECT_EQ(one_line("a\xe2\x80\xae"
                     "b"),
            "a\\xe2\\x80\\xaeb")
      << "right to left";
  EXPECT_EQ(one_line(std::string("a\0b", 3)), "a\\x00b");
}

TEST(OneLine, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(one_line("\xff"), "\\xff");
  EXPECT_EQ(one_line("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(one_line("\xc0\x8a"), "\\xc0\\x8a") << "overlong newline";
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "surrogate";
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

}  // namespace
}  // namespace loosefit
