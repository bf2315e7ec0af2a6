#include "loosefit/study/untold_modalities.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"

namespace loosefit::study {
namespace {

std::vector<std::string> told(const std::string& text) {
  std::vector<std::string> words;
  for (const UntoldModality& untold :
       untold_modalities(make_plan(parse_study_file(text, "study.toml"))))
    words.push_back(untold_text(untold));
  return words;
}

// coe_rms_deg and slip_mm compare postures; pressure, size and gap need one alone.
TEST(UntoldModalities, AreThoseOfWhichNoCaseHasThePosturesOrDonnings) {
  const auto head = [](const std::string& modalities) {
    return "[study]\nmodalities = [" + modalities + "]\n";
  };
  const std::string bends = "[scenario.postures]\nlist = [\"standing\", \"slouch\"]\n";
  EXPECT_EQ(told(head("\"imu-inclination\"")),
            std::vector<std::string>{"imu-inclination: no case can tell coe_rms_deg (several "
                                     "postures): nothing will be rated"});
  EXPECT_EQ(told(head("\"emg\", \"imu-inclination\"")).at(0),
            "emg: no case can tell slip_mm (several postures): scores leave that out and are upper "
            "bounds");
  EXPECT_TRUE(told(head("\"ecg\", \"imu-inclination\"") + bends).empty());
  EXPECT_TRUE(told(head("\"temperature\"")).empty());
  // One case that has them is enough.
  const std::string one =
      "[[axis]]\nname = \"p\"\n"
      "postures = [[\"standing\"], [\"standing\", \"slouch\"]]\n";
  EXPECT_TRUE(told(head("\"imu-inclination\"") + one).empty());
  // A donning more is no posture.
  EXPECT_EQ(told(head("\"imu-inclination\"") + "[scenario.donning]\nrepeats = 2\n").size(), 1u);
}

// Each level of an axis of donnings is one donning: none compares two.
TEST(UntoldModalities, OfDonningsNeedRepeatsInOneCase) {
  namespace fs = std::filesystem;
  const support::ScratchFolder scratch;
  const fs::path card = scratch / "again.toml";
  io::write_text_file(card.string(),
                      "title = \"t\"\nabout = \"a\"\n[footprint]\nradius = 0.01\n[[criterion]]\n"
                      "metric = \"donning_coe_deg\"\nunit = \"deg\"\ngood = 2.0\nfail = 15.0\n"
                      "reason = \"r\"\nsource = \"s\"\n");
  const std::string head = "[study]\nmodalities = [\"" + card.string() + "\"]\n";
  const std::string bends = "[scenario.postures]\nlist = [\"standing\", \"slouch\"]\n";
  const std::vector<std::string> nothing = {
      card.stem().string() +
      ": no case can tell donning_coe_deg (several donnings): nothing will be rated"};
  EXPECT_EQ(told(head + bends), nothing);
  EXPECT_EQ(told(head + bends + "[[axis]]\nname = \"on\"\ndonnings = 3\n"), nothing);
  EXPECT_TRUE(told(head + bends + "[scenario.donning]\nrepeats = 2\n").empty());
}

}  // namespace
}  // namespace loosefit::study
