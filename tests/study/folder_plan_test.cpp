#include "loosefit/study/folder_plan.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "support/study_on_disk.h"

namespace loosefit::study {
namespace {

struct CardOfAStudy : StudyOnDisk {
  fs::path card = base / "imu-uncalibrated.toml";

  void write_card(const std::string& pass) const {
    std::string text =
        io::read_text_file(LOOSEFIT_SOURCE_DIR "/data/scorecards/imu-uncalibrated.toml", 100000);
    text.replace(text.find("pass = 0.77"), 11, "pass = " + pass);
    io::write_text_file(card.string(), text);
  }
  StudyFolder finished_with_card() {
    fs::create_directories(base);
    write_card("0.5");
    std::string text = kStudy;
    text.replace(text.find("imu-uncalibrated"), 16, "imu-uncalibrated.toml");
    plan = make_plan(parse_study_file(text, (base / "x.toml").string()));
    return finished("a");
  }
};

// Scores of a card are judged with that card.
TEST_F(CardOfAStudy, StaysWhateverItsFileSays) {
  const StudyFolder folder = finished_with_card();
  const auto pass = [&] { return analyse(read_study_data(folder)).modalities.at(0).pass; };
  EXPECT_EQ(pass(), 0.5);
  write_card("0.9");
  EXPECT_EQ(pass(), 0.5);
  fs::remove(card);
  EXPECT_EQ(pass(), 0.5);
}

TEST_F(CardOfAStudy, OfAnEarlierProgramIsThatOfItsFile) {
  const StudyFolder folder = finished_with_card();
  const std::string file = (folder.path() / "plan.json").string();
  nlohmann::json json = nlohmann::json::parse(io::read_text_file(file, 1000000));
  json.erase("scorecard_texts");
  io::write_text_file(file, json.dump());
  write_card("0.9");
  EXPECT_EQ(scorecard(folder.read_plan(), 0).pass, 0.9);
  fs::remove(card);
  EXPECT_THROW(scorecard(folder.read_plan(), 0), IoError);
}

TEST_F(StudyOnDisk, TheReportNamesThePlanThatItIsOf) {
  const StudyFolder folder = finished("a");
  const auto digest = [&] {
    return nlohmann::json::parse(analysis_json(analyse(read_study_data(folder))))["plan_sha256"]
        .get<std::string>();
  };
  const std::string before = digest();
  EXPECT_EQ(before, plan_sha256(folder.read_plan()));
  EXPECT_EQ(digest(), before);
  std::string other = kStudy;
  other.replace(other.find("0.2]"), 4, "0.3]");
  folder.write_plan(make_plan(parse_study_file(other, "x.toml")));
  EXPECT_NE(digest(), before);
}

}  // namespace
}  // namespace loosefit::study
