#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <regex>

#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/pattern/outline.h"
#include "support/fuzz_cases.h"
#include "support/fuzz_tally.h"
#include "support/mutate.h"
#include "support/shirt_kind.h"
#include "support/sound_pieces.h"

// Patterns that our draft made, as files: the same bytes again, and known for what they are.
namespace loosefit::io {
namespace {

namespace fs = std::filesystem;

const std::string kSource = LOOSEFIT_SOURCE_DIR;
const std::string kShared = kSource + "/../shared/garments/";

std::string shirt_text() { return garmentcode_text(kinds::draft_shirt({})); }

pattern::Pattern parsed(const std::string& text) {
  return parse_garmentcode(text, "p.json").pattern;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

TEST(OwnPatterns, ReadAndWrittenAgainAreTheSameBytes) {
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * double(random() % 100001) / 1e5;
  };
  const std::vector<std::string> names = support::shirt_size_names();
  int drafted = 0;
  for (int i = 0; i < 60; ++i) {
    kinds::ShirtMeasures body = support::shirt_size(names[random() % names.size()]).body;
    for (double* value : {&body.chest, &body.waist, &body.hip, &body.arm_length, &body.hps_to_hem})
      *value *= uniform(0.93, 1.07);
    kinds::ShirtFit fit;
    fit.chest = uniform(0, 0.3), fit.hip = uniform(0, 0.3), fit.wrist = uniform(0.1, 0.4);
    fit.sleeve_length = i % 3 == 0 ? uniform(0.4, 0.9) : 1;
    if (i % 2) fit.waist = uniform(0, 0.3);
    std::string text;
    try {
      text = garmentcode_text(kinds::draft_shirt(body, fit, nullptr, {0, uniform(0.2, 1.2)}));
    } catch (const InvalidInput&) {
      continue;
    }
    ++drafted;
    const PatternFile again = parse_garmentcode(text, "p.json");
    EXPECT_TRUE(again.warnings.empty()) << again.warnings[0];
    EXPECT_EQ(again.pattern.kind, "long-sleeve-shirt");
    EXPECT_EQ(kinds::draft_mark(again.pattern), "shirt 1");
    ASSERT_EQ(garmentcode_text(again.pattern), text) << i;
  }
  EXPECT_GT(drafted, 40);
  for (const std::string& name : names) {
    const support::ShirtSize size = support::shirt_size(name);
    const std::string text = garmentcode_text(kinds::draft_shirt(size.body, size.fit));
    ASSERT_EQ(garmentcode_text(parsed(text)), text) << name;
  }
}

TEST(OwnPatterns, BandsAndHemsComeBackAndAreKnown) {
  for (const double neckband : {0.0, 0.02})
    for (const double cuff : {0.0, 0.05})
      for (const double length : {0.5, 1.0}) {
        kinds::ShirtFit fit = kinds::usual_shirt_fit();
        fit.neckband = neckband, fit.cuff = cuff, fit.sleeve_length = length;
        fit.neckband_stretch = length < 1 ? 0.1 : 0.0;  // straight and curved
        fit.band_stiffness = 1.5, fit.edge_finish = 0.012;
        const pattern::Pattern shirt = kinds::draft_shirt({}, fit);
        const std::string text = garmentcode_text(shirt);
        const PatternFile again = parse_garmentcode(text, "p.json");
        EXPECT_TRUE(again.warnings.empty()) << again.warnings[0];
        EXPECT_EQ(again.pattern.kind, "long-sleeve-shirt");
        ASSERT_EQ(again.pattern.panels.size(), shirt.panels.size());
        for (std::size_t p = 0; p < shirt.panels.size(); ++p) {
          const pattern::Panel &a = shirt.panels[p], &b = again.pattern.panels[p];
          EXPECT_EQ(b.part, a.part);
          EXPECT_EQ(b.cloth, a.cloth);
          ASSERT_EQ(b.edges.size(), a.edges.size());
          for (std::size_t e = 0; e < a.edges.size(); ++e) {
            EXPECT_EQ(b.edges[e].part, a.edges[e].part);
            EXPECT_NEAR(b.edges[e].finish, a.edges[e].finish, 1e-12);
          }
        }
        EXPECT_EQ(garmentcode_text(again.pattern), text);
      }
}

TEST(OwnPatterns, ClothOutOfRangeIsNamed) {
  kinds::ShirtFit fit = kinds::usual_shirt_fit();
  fit.neckband = 0.02;
  const std::string text =
      replaced(garmentcode_text(kinds::draft_shirt({}, fit)), "\"mass\":2.0", "\"mass\":-2.0");
  try {
    parse_garmentcode(text, "p.json");
    FAIL() << "no error";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("loosefit_cloth.mass: found -2.0, expected 0.01 to 100"),
              std::string::npos)
        << e.what();
  }
}

TEST(OwnPatterns, WhatWasReadFromOthersIsWrittenAndReadAsTheSameBytes) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kSource + "/tests/data/patterns"))
    files.push_back(entry.path());
  if (fs::exists(kShared))
    for (const auto& entry : fs::directory_iterator(kShared))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    const pattern::Pattern pattern = read_garmentcode(file).pattern;
    EXPECT_EQ(kinds::draft_mark(pattern), "");
    const std::string text = garmentcode_text(pattern);
    EXPECT_EQ(garmentcode_text(parsed(text)), text);
  }
}

TEST(OwnPatterns, PartsAreFoundByTheSeams) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  pattern::Pattern blank = shirt;
  for (pattern::Panel& panel : blank.panels) {
    panel.part.clear(), panel.name = "piece " + panel.name;
    for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
  }
  std::swap(blank.panels[0].name, blank.panels[1].name);
  ASSERT_TRUE(kinds::garment_kind("long-sleeve-shirt").note_parts(blank));
  for (std::size_t p = 0; p < 6; ++p) {
    EXPECT_EQ(blank.panels[p].part, shirt.panels[p].part);
    for (std::size_t e = 0; e < shirt.panels[p].edges.size(); ++e)
      EXPECT_EQ(blank.panels[p].edges[e].part, shirt.panels[p].edges[e].part);
  }
  pattern::Pattern open = shirt;
  open.stitches.pop_back();
  EXPECT_FALSE(kinds::garment_kind("long-sleeve-shirt").note_parts(open))
      << "a sleeve that is not closed";
  pattern::Pattern crossed = shirt;
  std::swap(crossed.stitches[0].second, crossed.stitches[1].second);
  EXPECT_FALSE(kinds::garment_kind("long-sleeve-shirt").note_parts(crossed))
      << "a side sewn to a shoulder";
}

TEST(OwnPatterns, AreKnownWithOtherNames) {
  std::string text = shirt_text();
  for (const char* name : {"front", "back", "sleeve_L_front", "sleeve_R_back"})
    text = replaced(text, std::string("\"") + name + "\"", std::string("\"my ") + name + " 2\"");
  const PatternFile file = parse_garmentcode(text, "p.json");
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(kinds::draft_mark(file.pattern), "shirt 1");
  EXPECT_EQ(file.pattern.find_panel("front"), -1);
  EXPECT_EQ(file.pattern.panels[0].name, "my front 2");
  EXPECT_EQ(kinds::shirt_girths(file.pattern, .4), kinds::shirt_girths(parsed(shirt_text()), .4));
}

TEST(OwnPatterns, NamesAloneDoNotMakeAShirt) {
  // The mark is there, but somebody has sewn a piece elsewhere.
  std::string text = shirt_text();
  const std::size_t last = text.rfind(",\n      [{", text.find("panel_order"));
  ASSERT_NE(last, std::string::npos);
  text.erase(last, text.find("\n    ],", last) - last);
  const PatternFile file = parse_garmentcode(text, "p.json");
  EXPECT_EQ(kinds::draft_mark(file.pattern), "");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("loosefit_draft"), std::string::npos) << file.warnings[0];

  // Sewn like a shirt and called front and back, but with neither mark nor our edges.
  std::string foreign = replaced(shirt_text(), "\"loosefit_draft\"", "\"other_draft\"");
  EXPECT_EQ(kinds::draft_mark(parsed(foreign)), "shirt 1") << "a file of ours without a mark";
  foreign = replaced(foreign, "\"name\":\"hem\"", "\"name\":\"lower\"");
  EXPECT_EQ(kinds::draft_mark(parsed(foreign)), "");
  EXPECT_EQ(parsed(foreign).kind, "pattern-file");
}

TEST(OwnPatterns, OtherKeysAreToldAsNotRead) {
  std::string text = shirt_text();
  text =
      replaced(text, "\"properties\": {", "\"parameters\": {\"length\": 3},\n  \"properties\": {");
  const auto warnings = parse_garmentcode(text, "p.json").warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "keys not read: parameters");
}

TEST(OwnPatterns, KeysThatTheExamplesNameExist) {
  const std::string text = read_text_file(kSource + "/examples/patterns/README.md", 100000);
  const std::regex assignment("`([a-z_]+ = [^`]+)`");
  int found = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), assignment), end; it != end; ++it, ++found)
    EXPECT_NO_THROW(parse_scenario("[garment]\n" + (*it)[1].str(), kSource + "/examples/x.toml"))
        << (*it)[1];
  EXPECT_GT(found, 0);
  EXPECT_EQ(text.find("file ="), std::string::npos);
}

TEST(OwnPatternsFuzz, DamagedFilesAreReadOrRefused) {
  std::vector<std::string> texts = {shirt_text()};
  for (const char* name : {"gpg_tee.json", "gpg_skirt_4_panels.json"})
    if (fs::exists(kShared + name)) texts.push_back(read_text_file(kShared + name, 1 << 20));
  std::vector<std::string> whole;
  for (const std::string& text : texts) whole.push_back(pieces_text(parsed(text)));
  const unsigned cases = fuzz_cases(2400);
  FuzzTally tally("JSON of our drafts", cases);
  for (unsigned seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE(seed);
    const std::string text = Mutator(seed)(texts[seed % texts.size()]);
    tally.begin();
    try {
      const pattern::Pattern pattern = parsed(text);
      EXPECT_EQ(wrong_pieces(pattern, kLargestPiece), "");
      kinds::draft_mark(pattern);
      if (seed % 10 == 0) garmentcode_text(pattern);
      tally.read(pieces_text(pattern) == whole[seed % texts.size()]);
    } catch (const InvalidInput&) {
      tally.refuse();
    }
  }
  tally.expect_real_damage(1.0 / 8);
}

}  // namespace
}  // namespace loosefit::io
