#include "support/sound_pieces.h"

#include "loosefit/io/dxf/dxf_read.h"
#include "support/dxf_text.h"

// What the runs of damaged files ask of pieces that are read: a reader that gave these would be
// told.
namespace loosefit::io {
namespace {

constexpr double kUnit = 0.001;  ///< of the file [m]

class SoundPieces : public ::testing::Test {
 protected:
  const std::string text = gerber_like_dxf();
  pattern::Pattern pattern = parse_dxf_pattern(text, "t.dxf").pattern;
  std::string wrong() const { return wrong_pieces(pattern, kUnit * largest_number(text)); }
};

TEST_F(SoundPieces, PiecesOfAWholeFileAreSound) { EXPECT_EQ(wrong(), ""); }

TEST_F(SoundPieces, PiecesInAnotherUnitAreLargerThanTheFile) {
  for (const char* unit : {"cm", "inch"}) {
    pattern = parse_dxf_pattern(text, "t.dxf", {"", unit}).pattern;
    EXPECT_NE(wrong().find("larger than anything in the file"), std::string::npos) << unit;
  }
}

TEST_F(SoundPieces, OpenOutlinesAndNumbersThatAreNoneAreTold) {
  const pattern::Pattern whole = pattern;
  pattern.panels[0].edges.pop_back();
  EXPECT_NE(wrong().find("an outline that is not closed"), std::string::npos);
  pattern = whole;
  pattern.panels[0].vertices[0].x() = std::nan("");
  EXPECT_NE(wrong().find("a point that is no number"), std::string::npos);
  pattern = whole;
  pattern.panels[0].edges[0].end = 1000;
  EXPECT_NE(wrong().find("a corner that is not there"), std::string::npos);
}

TEST_F(SoundPieces, TextOfPiecesTellsAPointThatMoved) {
  const std::string before = pieces_text(pattern);
  EXPECT_EQ(pieces_text(parse_dxf_pattern(text, "t.dxf").pattern), before);
  pattern.panels[0].vertices[0].x() += 1e-9;
  EXPECT_NE(pieces_text(pattern), before);
}

}  // namespace
}  // namespace loosefit::io
