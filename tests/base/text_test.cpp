#include "loosefit/base/text.h"

#include <gtest/gtest.h>

namespace loosefit {
namespace {

TEST(EditDistance, CountsSwapsAsOneAndIgnoresDashAndCase) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);
  EXPECT_EQ(edit_distance("Angular_Deviation", "angular-deviation"), 0);
}

TEST(ClosestMatch, FindsASlipAndRefusesAStranger) {
  const std::vector<std::string> keys = {"chest", "waist", "hip", "edge_length"};
  EXPECT_EQ(closest_match("cheast", keys), "chest");
  EXPECT_EQ(closest_match("edge_lenght", keys), "edge_length");
  EXPECT_EQ(closest_match("temperature", keys), "");
  EXPECT_EQ(closest_match(std::string(100000, 'x'), keys), "");
  EXPECT_EQ(closest_match("hop", {"hip", "hup"}), "hip") << "ties go to the earlier one";
}

TEST(DidYouMean, ListsAllWhenNothingIsNear) {
  EXPECT_EQ(did_you_mean("hipp", {"chest", "hip"}), "did you mean \"hip\"?");
  EXPECT_EQ(did_you_mean("zzzzz", {"chest", "hip"}), "known: chest, hip");
}

TEST(Shortest, ReadsBackToTheSameDouble) {
  for (double x : {0.1, 1.0 / 3, 4.41e-6, 1e300, -2.5}) EXPECT_EQ(std::stod(shortest(x)), x);
}

TEST(Printable, EscapesAndCuts) {
  EXPECT_EQ(printable("a\nb"), "a\\x0ab");
  EXPECT_EQ(printable(std::string(100, 'x'), 5), "xxxxx...");
  const std::string name = "Ärmel für größere 袖 😀";
  for (std::size_t limit = 0; limit <= name.size(); ++limit) {
    const std::string shown = printable(name, limit);
    EXPECT_EQ(shown.find("\\x"), std::string::npos) << shown;
    EXPECT_TRUE(valid_utf8(shown)) << shown;
    EXPECT_EQ(shown.ends_with("..."), limit < name.size()) << shown;
  }
  EXPECT_EQ(printable(name), name);
  EXPECT_EQ(printable("a\xff"), "a\\xff");
}

TEST(TerminalText, ControlsAndBrokenBytesAreEscaped) {
  EXPECT_EQ(terminal_line("µN m, K² – 5 ‰ … 漢字 😀"), "µN m, K² – 5 ‰ … 漢字 😀");
  EXPECT_EQ(terminal_line("a\x1b[31m\r\n\t\x7f"), "a\\x1b[31m\\x0d\\n\\x09\\x7f");
  EXPECT_EQ(terminal_line("\xc2\x9b"
                          "31m"),
            "\\xc2\\x9b31m")
      << "C1: CSI in one character";
  EXPECT_EQ(terminal_line("a\u202eb\u200bc\ufeff"),
            "a\\xe2\\x80\\xaeb\\xe2\\x80\\x8bc\\xef\\xbb\\xbf");
  // Not UTF-8: a lone byte, a cut sequence, overlong, a surrogate, beyond U+10FFFF.
  for (const char* broken : {"\xff", "\xe2\x80", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
    EXPECT_EQ(terminal_line(broken).find_first_not_of("\\x0123456789abcdef"), std::string::npos)
        << terminal_line(broken);
  EXPECT_EQ(terminal_text("a\nb\x1b"), "a\nb\\x1b");
  EXPECT_EQ(without_controls("a\n\x1b\xff"), "a\n\ufffd\ufffd");
}

}  // namespace
}  // namespace loosefit
