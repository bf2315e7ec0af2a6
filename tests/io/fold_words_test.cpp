#include "loosefit/io/pieces/fold_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "loosefit/io/read_pattern.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/hole.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

bool tells(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

/// Halves of a front and a back of a skirt, wider below; a text in each.
std::string half_skirt(double top, double flare, double length, const std::string& text,
                       bool fold_lines) {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2000mm\" height=\"1500mm\" "
      "viewBox=\"0 0 2000 1500\">";
  int k = 0;
  for (const char* name : {"front", "back"}) {
    const double x = 100 + 900 * k++;
    svg += fmt::format("<g id=\"{}\"><path d=\"M{} 100 H{} L{} {} H{} z\"/>", name, x, x + top,
                       x + top + flare, 100 + length, x);
    if (fold_lines)
      svg += fmt::format("<path id=\"fold-{}\" d=\"M{} 100 V{}\"/>", k, x, 100 + length);
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\">{}</text></g>", x + top / 3, 100 + length / 2, text);
  }
  return svg + "</svg>";
}

class FoldWords : public ::testing::Test {
 protected:
  PatternFile read(const std::string& text, const std::string& side = {}) const {
    std::filesystem::remove(folder_ / "skirt.seams.toml");
    std::ofstream(folder_ / "skirt.svg") << text;
    if (!side.empty()) std::ofstream(folder_ / "skirt.seams.toml") << side;
    return read_pattern(folder_ / "skirt.svg");
  }
  const support::ScratchFolder folder_;
};

TEST_F(FoldWords, HalvesWhoseFoldNoLineMarksAreSewnOnlyWhenSomebodyHasLooked) {
  std::mt19937 draw(61);
  std::uniform_real_distribution<double> top(250, 350), flare(20, 120), length(450, 800);
  for (const char* text : {"cut 1 on fold", "CUT ON FOLD", "place on fold", "1x im Stoffbruch",
                           "Cut 1, place to fold", "couper 1 sur la pliure", "cut on the fold"}) {
    const double a = top(draw), b = flare(draw), c = length(draw);
    SCOPED_TRACE(text);
    const PatternFile half = read(half_skirt(a, b, c, text, false));
    EXPECT_FALSE(half.placed);
    EXPECT_TRUE(half.pattern.stitches.empty());
    EXPECT_EQ(half.doubts.size(), 2u);
    EXPECT_NE(half.not_placed.find("front may be half a piece"), std::string::npos)
        << half.not_placed;
    EXPECT_TRUE(tells(half.warnings, "piece front: its text"));
    EXPECT_TRUE(tells(half.used, "not unfolded"));

    const PatternFile whole = read(half_skirt(a, b, c, text, true));
    EXPECT_TRUE(whole.doubts.empty());
    EXPECT_FALSE(whole.pattern.stitches.empty());
    for (std::size_t k = 0; k < whole.pattern.panels.size(); ++k)
      EXPECT_NEAR(pattern::cloth_area(whole.pattern.panels[k]),
                  2 * pattern::cloth_area(half.pattern.panels[k]), 1e-6);

    const PatternFile told =
        read(half_skirt(a, b, c, text, false), "confirmed = true\n[pieces]\nfront = \"front\"\n");
    EXPECT_FALSE(told.pattern.stitches.empty());
  }
}

// A piece by itself is told what it lacks: a poncho where it is folded, a wrap what holds it.
TEST_F(FoldWords, APieceByItselfIsToldWhyItIsNotPutOn) {
  std::mt19937 draw(31);
  std::uniform_real_distribution<double> side(700, 1400), radius(80, 150);
  for (int i = 0; i < 6; ++i) {
    const double w = side(draw), h = side(draw), r = radius(draw);
    const bool neck = i % 2 == 0;
    const std::string hole = neck ? fmt::format(" M{} {} a{} {} 0 1 0 {} 0 a{} {} 0 1 0 {} 0 Z",
                                                w / 2 - r, h / 2, r, r, 2 * r, r, r, -2 * r)
                                  : "";
    const PatternFile file = read(
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
                    "viewBox=\"-50 -50 {0} {1}\"><g id=\"{2}\"><path fill-rule=\"evenodd\" "
                    "d=\"M0 0 H{3} V{4} H0 Z{5}\"/></g></svg>",
                    w + 100, h + 100, neck ? "poncho" : "wrap", w, h, hole));
    EXPECT_FALSE(file.placed);
    EXPECT_NE(file.not_placed.find(neck ? "folded over the shoulders" : "wrapped, tied"),
              std::string::npos)
        << file.not_placed;
    EXPECT_NE(file.not_placed_hint.find(neck ? "front and back" : "as a tube"), std::string::npos);
  }
}

TEST_F(FoldWords, TextsOfFoldedHemsAndMirroredTwinsAreNoHalves) {
  for (const char* text : {"fold up twice", "1 + mirror", "hem fold line", "cut 1 + mirror",
                           "fold up at the hem", "Saumbruch", "sleeve mirror"}) {
    const PatternFile file = read(half_skirt(300, 40, 600, text, false));
    EXPECT_TRUE(file.doubts.empty()) << text;
  }
  // A mark that lies on no part of the outline and not in its middle leaves the same doubt.
  const std::string text = half_skirt(300, 40, 600, "front", true);
  EXPECT_TRUE(read(text).doubts.empty());
  for (const int x : {90, 110, 150}) {
    std::string moved = text;
    const std::size_t at = moved.find("d=\"M100 100 V");
    ASSERT_NE(at, std::string::npos);
    moved.replace(at, 13, fmt::format("d=\"M{} 100 V", x));
    const PatternFile file = read(moved);
    EXPECT_EQ(file.doubts.size(), 1u) << x;
    EXPECT_TRUE(file.pattern.stitches.empty());
    EXPECT_TRUE(tells(file.used, "piece front (at line 1): its outline, not unfolded"));
  }
  EXPECT_FALSE(speaks_of_fold("1 + mirror"));
  EXPECT_FALSE(speaks_of_fold("cut 2, mirrored"));
  EXPECT_TRUE(speaks_of_fold("cut 1 on fold"));
}

}  // namespace
}  // namespace loosefit::io
