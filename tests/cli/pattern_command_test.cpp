#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/girths_along.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_pattern.h"
#include "support/drawn_tshirt.h"
#include "support/dxf_text.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace loosefit {
namespace {

namespace fs = std::filesystem;

class PatternCommand : public testing::Test {
 protected:
  const support::ScratchFolder base;
  std::string file(const std::string& name, const std::string& text) const {
    io::write_text_file((base / name).string(), text);
    return (base / name).string();
  }
  ProgramRun pattern(const std::string& arguments) const {
    return run_program(std::string(LOOSEFIT_BINARY) + " pattern " + arguments);
  }
  /// The pattern.json that the command writes.
  std::string written(const std::string& arguments) const {
    const fs::path out = base / "out";
    fs::remove_all(out);
    const ProgramRun run = pattern(arguments + " -o " + out.string());
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return run.exit_code == 0 ? io::read_text_file((out / "pattern.json").string(), 1 << 24) : "";
  }
};

TEST_F(PatternCommand, HasTheDefaultsOfAScenario) {
  const pipeline::CaseBody body = pipeline::make_body(io::default_scenario().body);
  const auto of_run = [&](const std::string& garment) {
    const scenario::Scenario scenario = io::parse_scenario("[garment]\n" + garment, "case.toml");
    return io::garmentcode_text(pipeline::make_pattern(scenario.studied().spec, body.body,
                                                       kinds::girths_along(body.path(0).body()))
                                    .pattern);
  };
  EXPECT_EQ(written(""), of_run(""));
  EXPECT_EQ(written("--pattern t-shirt"), of_run("pattern = \"t-shirt\""));
  EXPECT_EQ(written("--fit-chest 0.2 --sleeve-length 0.8"),
            of_run("fit = { chest = 0.2, sleeve_length = 0.8 }"));
  EXPECT_EQ(written("--pattern t-shirt --size men-M"),
            of_run("pattern = \"t-shirt\"\nsize = \"men-M\""));
}

TEST_F(PatternCommand, MeasuresHaveTheRangeOfBodiesAndHintsAtOtherUnits) {
  for (const char* options : {"--chest 2.0", "--pattern tank-top --chest 2.0",
                              "--pattern trousers --hip 2.0", "--waist 2.1"}) {
    const ProgramRun run = pattern(options);
    EXPECT_EQ(run.exit_code, 2) << options;
    EXPECT_NE(run.output.find("expected metres from 0.3"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("to 1."), std::string::npos) << run.output;
  }
  for (const auto& [option, hint] : {std::pair{"--hip 38", "38 inches is 0.9652"},
                                     {"--chest 92", "92 cm is 0.92"},
                                     {"--arm-length 24", "24 inches is 0.6096"},
                                     {"--hps-to-hem 28", "28 inches is 0.7112"}})
    EXPECT_NE(pattern(option).output.find(hint), std::string::npos) << pattern(option).output;
}

TEST_F(PatternCommand, DecimalCommasAndUnitsOnTheCommandLineAreNamed) {
  for (const char* option : {"--chest 0,92", "--chest=0,92", "--fit-chest 0,2"}) {
    const ProgramRun run = pattern(option);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.output.find("decimal comma"), std::string::npos) << run.output;
  }
  EXPECT_NE(pattern("--chest 0,92").output.find("write --chest 0.92"), std::string::npos);
  for (const char* option : {"--chest 92cm", "--chest 36in", "--chest 0.92m"})
    EXPECT_NE(pattern(option).output.find("a number without a unit"), std::string::npos) << option;
}

TEST_F(PatternCommand, DraftsForTheBodyOfAFileAsForThatOfAScenario) {
  const std::string person = "--sex male --age 40 --height 1.8 ";
  const ProgramRun made = run_program(std::string(LOOSEFIT_BINARY) + " body " + person + "-o " +
                                      (base / "him").string());
  ASSERT_EQ(made.exit_code, 0) << made.output;
  const std::string scenario =
      file("case.toml",
           "[body]\nsex = \"male\"\nage = 40\nheight = 1.8\n"
           "[garment]\nfit = { sleeve_follow = 0 }\n");  // a table has no girths along
  // A table of a body has no girths along the arm: sleeves differ, the trunk does not.
  const auto trunk = [](const std::string& pattern) {
    return pattern.substr(0, pattern.find("sleeve"));
  };
  const std::string of_table = written("--body " + (base / "him/body.json").string());
  EXPECT_GT(trunk(of_table).size(), 1000u);
  EXPECT_EQ(trunk(of_table), trunk(written("--scenario " + scenario)));
}

TEST_F(PatternCommand, RefusesAMeasureThatWasGivenAndAdaptsOneThatWasNot) {
  const ProgramRun given = pattern("--arm-length 0.19 --sleeve-length 1");
  EXPECT_EQ(given.exit_code, 2);
  EXPECT_NE(given.output.find("error: measures.arm_length: found 0.19 m"), std::string::npos)
      << given.output;
  const ProgramRun adapted = pattern("--pattern t-shirt --arm-length 0.3");
  EXPECT_EQ(adapted.exit_code, 0) << adapted.output;
  EXPECT_NE(adapted.output.find("warning: fit.sleeve_length: 0."), std::string::npos)
      << adapted.output;
}

TEST_F(PatternCommand, ToldOfAnotherKindOfFile) {
  const ProgramRun run = pattern("--file " + file("shirt.pdf", "%PDF-1.4\n"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.output.find("shirt.pdf: found a PDF document, expected GarmentCode JSON"),
            std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("patterns are read from GarmentCode JSON"), std::string::npos);
  file("shirt.dxf", "  0\nSECTION\n  2\nBLOCKS\n");
  const ProgramRun scenario =
      pattern("--scenario " + file("case.toml", "[garment]\npattern = \"shirt.dxf\"\n"));
  EXPECT_EQ(scenario.exit_code, 2);
  EXPECT_NE(scenario.output.find("shirt.dxf:4: section BLOCKS"), std::string::npos)
      << scenario.output;
}

TEST_F(PatternCommand, ShowsADxfFileWithItsSeamsAndWhatWasNotUsed) {
  const std::string name = file("tee.dxf", gerber_like_dxf());
  file("tee.seams.toml", "[[seam]]\nfirst = \"SLEEVE.e1\"\nsecond = \"SLEEVE.e3\"\n");
  const ProgramRun run = pattern("--file " + name + " --size 42");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  for (const char* words : {"size 42 of 40, 42", "SLEEVE_mirrored", "SLEEVE.e3",
                            "not used:", "layer 8 (internal lines): 1 LINE", "have no sew line"})
    EXPECT_NE(run.output.find(words), std::string::npos) << words << "\n" << run.output;
  const ProgramRun alone = pattern("--units mm");
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.output.find("error: --units: found mm"), std::string::npos) << alone.output;
}

TEST_F(PatternCommand, SewsAKnownGarmentUnaskedAndWritesItInEveryFormat) {
  const std::string name = file("tee.svg", testing_support::freesewing_tshirt(true));
  const fs::path out = base / "out";
  const ProgramRun run = pattern("--file " + name + " -o " + out.string());
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("sewn by what its pieces are, t-shirt: 8 seams"), std::string::npos)
      << run.output;
  EXPECT_EQ(run.output.find("cannot be worn"), std::string::npos) << run.output;
  for (const char* written : {"pattern.json", "pattern.svg", "pattern.dxf"}) {
    SCOPED_TRACE(written);
    const ProgramRun again = pattern("--file " + (out / written).string());
    EXPECT_EQ(again.exit_code, 0) << again.output;
    EXPECT_NE(again.output.find("4 pieces, 0.6397 m2"), std::string::npos) << again.output;
    EXPECT_NE(again.output.find("armhole_L_1"), std::string::npos) << again.output;
  }
  // A scenario that names the file makes the same pattern.
  const ProgramRun scenario =
      pattern("--scenario " + file("case.toml", "[garment]\npattern = \"tee.svg\"\n"));
  EXPECT_EQ(scenario.exit_code, 0) << scenario.output;
  EXPECT_NE(scenario.output.find("armhole_L_1"), std::string::npos) << scenario.output;
}

TEST_F(PatternCommand, ProposesSeamsOnceAndNeverOverwritesThem) {
  const std::string name = file("tee.dxf", gerber_like_dxf());
  const fs::path seams = base / "tee.seams.toml", picture = base / "tee.seams.svg";
  const ProgramRun first = pattern("--file " + name + " --propose-seams");
  EXPECT_EQ(first.exit_code, 0) << first.output;
  ASSERT_TRUE(fs::exists(seams)) << first.output;
  const std::string text = io::read_text_file(seams.string(), 1 << 20);
  EXPECT_NE(text.find("confirmed = false"), std::string::npos);
  EXPECT_NE(io::read_text_file(picture.string(), 1 << 24).find("class=\"seam\""),
            std::string::npos);
  // They are used from now on, and told to be proposals until somebody says otherwise.
  const ProgramRun read = pattern("--file " + name);
  EXPECT_EQ(read.exit_code, 0) << read.output;
  EXPECT_NE(read.output.find("nobody has confirmed"), std::string::npos) << read.output;
  for (const fs::path& there : {seams, picture}) {
    const fs::path other = there == seams ? picture : seams;
    fs::remove(other);
    const ProgramRun second = pattern("--file " + name + " --propose-seams");
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.output.find("there already"), std::string::npos) << second.output;
    EXPECT_FALSE(fs::exists(other)) << "both or none";
    if (there == seams) {
      EXPECT_EQ(io::read_text_file(seams.string(), 1 << 20), text);
    }
    io::write_text_file(other.string(), "x");
  }
  const ProgramRun sewn = pattern("--propose-seams --file " +
                                  file("p.json", io::garmentcode_text(kinds::draft_shirt({}))));
  EXPECT_EQ(sewn.exit_code, 2);
  EXPECT_NE(sewn.output.find("a file with seams"), std::string::npos) << sewn.output;
  EXPECT_EQ(pattern("--propose-seams").exit_code, 2);
}

TEST_F(PatternCommand, AScenarioChoosesSizeUnitsAndSeamsOfAFile) {
  file("tee.dxf", gerber_like_dxf());
  file("own.toml", "[[seam]]\nfirst = \"SLEEVE.e1\"\nsecond = \"SLEEVE.e3\"\nname = \"mine\"\n");
  const auto told = [&](const std::string& keys) {
    return pattern("--scenario " + file("case.toml", "[garment]\npattern = \"tee.dxf\"\n" + keys));
  };
  // Half of it is not sewn to the rest, which only the reader of both can tell.
  const ProgramRun run = told("size = \"42\"\nunits = \"mm\"\nseams = \"own.toml\"\n");
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_NE(run.output.find("no seam to the others at SLEEVE"), std::string::npos) << run.output;
  const ProgramRun size = told("size = \"44\"\n");
  EXPECT_EQ(size.exit_code, 2);
  EXPECT_NE(size.output.find("a size of the file"), std::string::npos) << size.output;
  const ProgramRun unsewn = told("");
  EXPECT_EQ(unsewn.exit_code, 2);
  EXPECT_NE(unsewn.output.find("it has no seams"), std::string::npos) << unsewn.output;
  EXPECT_NE(unsewn.output.find("--propose-seams"), std::string::npos) << unsewn.output;
}

TEST_F(PatternCommand, ComparesAPatternFileWithABody) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  for (pattern::Panel& panel : shirt.panels) panel.part.clear();
  shirt.kind = "pattern-file";
  for (pattern::Stitch& stitch : shirt.stitches) stitch.name.clear();
  std::string text = io::garmentcode_text(shirt);
  for (std::size_t at = 0; (at = text.find("\"front\"", at)) != std::string::npos;)
    text.replace(at, 7, "\"front part\"");
  const std::string name = file("p.json", text);
  const ProgramRun run =
      pattern("--file " + name + " --body " +
              file("body.json",
                   "{\"chest\": 0.9, \"waist\": 0.75, \"hip\": 1.0, \"hps_to_waist\": 0.43, "
                   "\"hps_to_hip\": 0.63, \"upper_arm\": 0.28}"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  for (const char* words : {"chest         0.9000", "waist         0.7500", "upper arm     0.2800"})
    EXPECT_NE(run.output.find(words), std::string::npos) << words << "\n" << run.output;
}

TEST_F(PatternCommand, NamesOfAFileReachTheTerminalHarmless) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  shirt.panels[0].name = "a\x1b[2Jb\nc";
  shirt.panels[1].edges[0].name = "hem\x1b]0;x\x07";
  shirt.stitches[0].name = "side\rx";
  const std::string text = io::garmentcode_text(shirt);
  const ProgramRun read = pattern("--file " + file("p.json", text));
  EXPECT_EQ(read.exit_code, 0) << read.output;
  EXPECT_NE(read.output.find("a\\x1b[2Jb\\nc"), std::string::npos) << read.output;
  // The same names in an error: a seam that is sewn twice.
  std::string twice = text;
  const std::size_t first = twice.find("\"stitches\": [") + 13;
  twice.insert(first, twice.substr(first, twice.find("}],", first) + 3 - first));
  const ProgramRun refused = pattern("--file " + file("q.json", twice));
  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  for (const std::string& output : {read.output, refused.output})
    for (const char c : output)
      ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << output;
  EXPECT_EQ(refused.output.rfind("error: ", 0), 0u) << refused.output;
}

}  // namespace
}  // namespace loosefit
