#include "loosefit/io/seams_file.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/pattern/outline.h"
#include "support/dxf_text.h"
#include "support/mutate.h"
#include "support/unsewn_garments.h"

namespace loosefit::io {
namespace {

const char* const kSeams = R"([[seam]]
first = "SLEEVE.e1"
second = "SLEEVE.e3"
name = "underarm"
[[seam]]
first = "SLEEVE_mirrored.e1"
second = "SLEEVE_mirrored.e3"
reversed = true
)";

PatternFile tee() {
  PatternFile file = parse_dxf_pattern(gerber_like_dxf(), "tee.dxf");
  file.warnings.clear();
  return file;
}

std::string refusal(const std::string& text) {
  PatternFile file = tee();
  try {
    parse_seams(text, "tee.seams.toml", file);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(SeamsFile, SeamsOfASideFileAreThoseOfThePattern) {
  PatternFile file = tee();
  parse_seams(kSeams, "tee.seams.toml", file);
  const pattern::Pattern& pattern = file.pattern;
  ASSERT_EQ(pattern.stitches.size(), 2u);
  EXPECT_EQ(pattern.stitches[0].name, "underarm");
  const pattern::Panel& sleeve = pattern.panels[pattern.stitches[0].first.panel];
  EXPECT_EQ(sleeve.name, "SLEEVE");
  EXPECT_EQ(sleeve.edges[pattern.stitches[0].second.edge].name, "e3");
  EXPECT_FALSE(pattern.stitches[0].right_wrong);
  EXPECT_TRUE(pattern.stitches[1].right_wrong);
  EXPECT_EQ(seams_path("a/tee.dxf"), "a/tee.seams.toml");
  // Written and read again it is the same garment: the seams as long, the pieces as large.
  const pattern::Pattern again = parse_garmentcode(garmentcode_text(pattern), "p.json").pattern;
  ASSERT_EQ(again.panels.size(), pattern.panels.size());
  ASSERT_EQ(again.stitches.size(), 2u);
  for (std::size_t p = 0; p < again.panels.size(); ++p)
    EXPECT_NEAR(pattern::signed_area(pattern::outline_polygon(again.panels[p])),
                pattern::signed_area(pattern::outline_polygon(pattern.panels[p])), 1e-9);
}

TEST(SeamsFile, PiecesThatAreLeftOutAreNotTaken) {
  PatternFile file = tee();
  const std::size_t notches = file.notches.size();
  parse_seams("leave_out = [\"FRONT\"]\n" + std::string(kSeams), "tee.seams.toml", file);
  ASSERT_EQ(file.pattern.panels.size(), 2u);
  EXPECT_EQ(file.pattern.find_panel("FRONT"), -1);
  EXPECT_EQ(file.pattern.panel_order, (std::vector<int>{0, 1}));
  EXPECT_EQ(file.notches.size(), notches) << "those of the sleeves";
  for (const pattern::Notch& notch : file.notches) EXPECT_LT(notch.panel, 2);
  EXPECT_EQ(file.pattern.stitches.size(), 2u);
  EXPECT_NE(file.unused.back().find("FRONT: left out"), std::string::npos);
  EXPECT_NE(refusal("leave_out = [\"FRNT\"]\n").find("leave_out"), std::string::npos);
  EXPECT_NE(refusal("leave_out = [\"FRONT\", \"SLEEVE\", \"SLEEVE_mirrored\"]\n").find("not all"),
            std::string::npos);
  EXPECT_NE(refusal("leave_out = [\"FRONT\"]\n[[seam]]\nfirst = \"FRONT.e1\"\nsecond = "
                    "\"SLEEVE.e1\"\n")
                .find("a panel of the pattern"),
            std::string::npos);
}

TEST(SeamsFile, SidesOfDifferentLengthsAreTold) {
  PatternFile file = tee();
  parse_seams("[[seam]]\nfirst = \"SLEEVE.e1\"\nsecond = \"SLEEVE.e2\"\n", "s", file);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("208.8 and 549.3 mm"), std::string::npos) << file.warnings[0];
}

TEST(SeamsFile, MistakesAreToldWithTheirLine) {
  const auto told = [](const std::string& text, const std::string& words) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  told("[[seam]]\nfirst = \"SLEVE.e1\"\nsecond = \"SLEEVE.e2\"\n",
       "tee.seams.toml:2: seam[0].first");
  told("[[seam]]\nfirst = \"SLEEVE.e9\"\nsecond = \"SLEEVE.e2\"\n", "an edge of panel SLEEVE");
  told("[[seam]]\nfirst = \"SLEEVE.e2\"\nsecond = \"SLEEVE.e2\"\n", "not sewn yet");
  told("[[seam]]\nfirst = \"SLEEVE.e2\"\n", "second");
  told("[[seem]]\n", "seem");
  told("[[seam]]\nfirst = 3\nsecond = \"SLEEVE.e2\"\n", "found 3");
}

TEST(SeamsFile, AProposalForAHoodIsReadAsItWasProposed) {
  PatternFile file;
  file.pattern = testing_support::unsewn_hoodie();
  const std::string text = seams_text(file.pattern, pattern::propose_seams(file.pattern, {}));
  EXPECT_NE(text.find("begin = 0.3"), std::string::npos) << text;
  pattern::Pattern known = file.pattern;
  std::vector<pattern::Notch> notches;
  pattern::sew_chains(known, pattern::know_garment(known).seams, notches);
  parse_seams(text, "hoodie.seams.toml", file);
  ASSERT_EQ(file.pattern.stitches.size(), known.stitches.size());
  for (std::size_t i = 0; i < known.stitches.size(); ++i) {
    EXPECT_EQ(file.pattern.stitches[i].first.edge, known.stitches[i].first.edge);
    EXPECT_EQ(file.pattern.stitches[i].second.panel, known.stitches[i].second.panel);
    EXPECT_EQ(file.pattern.stitches[i].second.edge, known.stitches[i].second.edge);
  }
}

TEST(SeamsFile, ASideThatDoesNotGoAllTheWayRoundHasNoBeginning) {
  PatternFile file = tee();
  const pattern::Pattern before = file.pattern;
  try {
    parse_seams(
        "[[seam]]\nname = \"cap\"\nfirst = \"SLEEVE.e1\"\nsecond = \"SLEEVE.e2\"\n"
        "begin = 0.4\n",
        "tee.seams.toml", file);
    FAIL();
  } catch (const GeometryError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("tee.seams.toml: seam cap"), std::string::npos) << told;
    EXPECT_NE(told.find("does not end where it begins"), std::string::npos) << told;
  }
  for (std::size_t p = 0; p < before.panels.size(); ++p)
    EXPECT_EQ(file.pattern.panels[p].edges.size(), before.panels[p].edges.size());
}

TEST(SeamsFile, DamagedFilesAreRefusedOrRead) {
  int refused = 0;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE(seed);
    refused += !refusal(Mutator(seed)(kSeams)).empty();
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace loosefit::io
