#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/io/freesewing_json.h"
#include "loosefit/io/seams_file.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/pattern_check.h"
#include "loosefit/pattern/place_pieces.h"
#include "loosefit/pattern/propose_seams.h"
#include "support/drawn_tshirt.h"
#include "support/fuzz_cases.h"
#include "support/fuzz_tally.h"
#include "support/mutate.h"
#include "support/sound_pieces.h"

// Damaged SVG, FreeSewing JSON and side files: never a crash, never a hang; an error that says
// where, or sound panels that can be sewn and placed or are told not to be.
namespace loosefit::io {
namespace {

using Read = std::function<PatternFile(const std::string&)>;

/// All that follows on reading.
void go_on(PatternFile file) {
  pattern::check_pattern(file.pattern);
  const pattern::SeamProposals found = pattern::propose_seams(file.pattern, file.notches);
  std::vector<pattern::ChainSeam> seams;
  for (const pattern::SeamProposal& p : found.seams) seams.push_back(p.seam);
  PatternFile again = file;
  parse_seams(seams_text(file.pattern, found), "s.toml", again);
  EXPECT_EQ(again.pattern.stitches.empty(), seams.empty());
  pattern::check_pattern(again.pattern);
  try {
    pattern::place_pieces(again.pattern);
    pattern::check_pattern(again.pattern);
  } catch (const GeometryError&) {
  }
  const PatternFile written = parse_dxf_pattern(dxf_text(again.pattern), "w.dxf", {"", "mm"});
  EXPECT_EQ(written.pattern.panels.size(), again.pattern.panels.size());
}

/// `whole`: the text that the pieces come from, where the damaged one has none.
void fuzz(const std::string& format, const std::string& valid, const std::string& name,
          const Read& read, const std::string& whole = {}) {
  const unsigned cases = fuzz_cases(600);
  const std::string undamaged = pieces_text(read(valid).pattern);
  FuzzTally tally(format, cases);
  const auto start = std::chrono::steady_clock::now();
  for (unsigned seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE(seed);
    const std::string damaged = Mutator(seed)(valid);
    tally.begin();
    try {
      PatternFile file = read(damaged);
      const bool same = pieces_text(file.pattern) == undamaged;
      EXPECT_EQ(wrong_pieces(file.pattern, 0.001 * largest_number(whole.empty() ? damaged : whole)),
                "");
      // What is lost is told. A piece whose name no longer says sleeve has no mirrored twin.
      EXPECT_TRUE(file.pattern.panels.size() >= 3 || !file.warnings.empty() ||
                  !file.unused.empty());
      go_on(std::move(file));
      tally.read(same);
    } catch (const InvalidInput& error) {
      tally.refuse();
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), 900u) << message;
      EXPECT_EQ(message.rfind(name + ":", 0), 0u) << message;
    }
  }
  tally.expect_real_damage(0.1);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 0.1 * cases + 10);
}

TEST(DrawingFuzz, FreesewingSvg) {
  fuzz("SVG of FreeSewing", testing_support::freesewing_tshirt(true), "fuzz.svg",
       [](const std::string& text) { return parse_svg_pattern(text, "fuzz.svg"); });
}

TEST(DrawingFuzz, OtherSvg) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900mm\" height=\"700mm\"\n"
      "viewBox=\"0 0 900 700\">\n";
  for (const auto& [name, d] : {std::pair{"front", testing_support::kFrontHalf},
                                std::pair{"back", testing_support::kBackHalf}})
    text +=
        std::string("<g id=\"") + name + "\" transform=\"translate(5 5) rotate(2)\">\n<path d=\"" +
        d +
        "\"/>\n<path id=\"fold\" d=\"M0 100V590\"/>\n<path id=\"notch\" d=\"M183 120h5\"/>\n</g>\n";
  text += std::string("<path id=\"sleeve\" transform=\"matrix(1 0 0 1 500 200)\" d=\"") +
          testing_support::kSleeve +
          "\"/>\n<path id=\"sleeve_2\" transform=\"translate(700 400) scale(-1 1)\"\n d=\"" +
          testing_support::kSleeve +
          "\"/>\n<rect x=\"1\" y=\"2\" width=\"20\" height=\"30\" rx=\"2\"/>\n</svg>\n";
  fuzz("SVG of a drawing program", text, "fuzz.svg",
       [](const std::string& t) { return parse_svg_pattern(t, "fuzz.svg"); });
}

TEST(DrawingFuzz, FreesewingJson) {
  fuzz("JSON of FreeSewing", testing_support::freesewing_json(), "fuzz.json",
       [](const std::string& text) { return parse_freesewing_json(text, "fuzz.json"); });
}

TEST(DrawingFuzz, RunsOfASideFile) {
  const std::string drawing = testing_support::freesewing_tshirt(true);
  const PatternFile shirt = parse_svg_pattern(drawing, "t.svg");
  const std::string valid =
      seams_text(shirt.pattern, pattern::propose_seams(shirt.pattern, shirt.notches));
  fuzz(
      "side file (TOML)", valid, "fuzz.toml",
      [&](const std::string& text) {
        PatternFile file = shirt;
        parse_seams(text, "fuzz.toml", file);
        pattern::check_pattern(file.pattern);
        file.pattern.stitches.clear();
        return file;
      },
      drawing);
}

}  // namespace
}  // namespace loosefit::io
