#include "loosefit/base/control_characters.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "loosefit/base/text.h"

namespace loosefit {
namespace {

/// UTF-8 of what moves a cursor, turns text or hides it (Unicode 15, categories Cc and Cf).
const std::vector<std::string> kControls = {"\x01",   "\x1b",   "\x7f",   "\u0085",    "\u061c",
                                            "\u180e", "\u200b", "\u200e", "\u200f",    "\u2028",
                                            "\u202a", "\u202e", "\u2060", "\u2066",    "\u2069",
                                            "\u206f", "\ufeff", "\ufff9", "\U000e0041"};

std::string drawn_name(std::mt19937& random) {
  static const std::vector<std::string> kPlain = {"a", "ü", "中", "\"", "\\", "'", " ", "="};
  std::string name;
  for (int i = 0; i < 12; ++i)
    name += random() % 3 == 0 ? kControls[random() % kControls.size()]
                              : kPlain[random() % kPlain.size()];
  return name;
}

bool has_control(const std::string& text) {
  for (const std::string& control : kControls)
    if (text.find(control) != std::string::npos) return true;
  return false;
}

TEST(ControlCharacters, NoneReachesATerminalOrAPage) {
  std::mt19937 random(7);
  for (int draw = 0; draw < 200; ++draw) {
    const std::string name = drawn_name(random);
    EXPECT_FALSE(has_control(terminal_line(name))) << draw;
    EXPECT_FALSE(has_control(without_controls(name))) << draw;
  }
}

TEST(ControlCharacters, StandInJsonAsEscapesOfTheSameText) {
  // A document with the text as JSON libraries write it: only those below 0x20 escaped.
  EXPECT_EQ(json_without_controls("{\n \"a\": \"x\u202ey\"\n}"), "{\n \"a\": \"x\\u202ey\"\n}");
  EXPECT_EQ(json_without_controls("\"\x7f\""), "\"\\u007f\"");
  EXPECT_EQ(json_without_controls("\"\u061c\u0085\""), "\"\\u061c\\u0085\"");
  EXPECT_EQ(json_without_controls("\"\U000e0041\""), "\"\\udb40\\udc41\"");
  EXPECT_EQ(json_without_controls("\"kg/m² ü 中\""), "\"kg/m² ü 中\"");
}

TEST(ControlCharacters, CodePointsAreThoseOfUnicode) {
  EXPECT_EQ(code_point("A"), U'A');
  EXPECT_EQ(code_point("ü"), U'ü');
  EXPECT_EQ(code_point("\u202e"), U'\u202e');
  EXPECT_EQ(code_point("\U000e0041"), U'\U000e0041');
}

}  // namespace
}  // namespace loosefit
