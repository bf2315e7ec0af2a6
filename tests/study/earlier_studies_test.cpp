// Folders of studies as earlier versions left them: with grades of certificates and controls.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "loosefit/base/sha256.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/store.h"
#include "loosefit/study/study_data.h"
#include "support/study_on_disk.h"

namespace loosefit::study {
namespace {

using Json = nlohmann::json;

/// The text of a result as those versions wrote it, with a grade and, of some, a control.
std::string earlier_record(const CaseRecord& record, std::mt19937& random) {
  const std::string text = record_json(record);
  Json result = Json::parse(text).at("result");
  const auto draw = [&](int most) { return static_cast<int>(random() % (most + 1)); };
  result["grade"] = std::vector<std::string>{"A", "B", ""}[draw(2)];
  if (draw(1)) {
    result["control"] = {{"failed", draw(1) ? "the program crashed" : ""},
                         {"largest", {{"slip_mm", draw(100) / 7.0}, {"score", nullptr}}}};
    if (draw(1))
      result["control"]["scores"] = {{"kept", draw(9)}, {"lost", draw(9)}, {"gained", draw(9)}};
  }
  const std::string dumped = result.dump(1);
  return "{\"sha256\": \"" + sha256_hex(dumped) + "\",\n\"result\": " + dumped + "}\n";
}

TEST(EarlierStudies, ARecordIsReadWithoutItsGradeAndControl) {
  std::mt19937 random(3);
  for (int k = 0; k < 40; ++k) {
    const CaseRecord record = made_up("ab12", random() % 100 / 99.0);
    const CaseRecord read = parse_record(earlier_record(record, random), "x");
    EXPECT_EQ(record_json(read), record_json(record));
  }
}

TEST_F(StudyOnDisk, AFolderOfAnEarlierVersionKeepsAllThatIsInIt) {
  const StudyFolder folder = planned("a");
  // Controls in plan.json, or beside it; every case has its result, whether its control ran or not.
  const std::string file = (folder.path() / "plan.json").string();
  Json plan_json = Json::parse(io::read_text_file(file, 1000000));
  plan_json["controls"] = {plan.cases[2].address, plan.cases[7].address};
  io::write_text_file(file, plan_json.dump());
  const std::string beside = plan.cases[2].address + "\n";
  io::write_text_file((folder.path() / "controls.txt").string(), beside);
  std::mt19937 random(7);
  std::map<std::string, std::string> written;
  for (const PlannedCase& one : plan.cases) {
    written[one.address] = earlier_record(made_up(one.address, score(one)), random);
    fs::create_directories(folder.case_folder(one.address));
    io::write_text_file(folder.result_file(one.address).string(), written[one.address]);
  }
  const FolderPlan read = folder.read_plan();
  EXPECT_TRUE(folder.state(read).open.empty());
  EXPECT_EQ(folder.forget_failed(read), 0);
  // Its database has a column and two tables more.
  collect(folder, read);
  Database(folder.database(), Database::Mode::write)
      .run(
          "ALTER TABLE cases ADD COLUMN grade TEXT; UPDATE cases SET grade = 'B';"
          "CREATE TABLE controls (number INTEGER, metric TEXT, largest REAL);"
          "CREATE TABLE control_scores (number INTEGER, kept INTEGER, lost INTEGER, gained "
          "INTEGER);"
          "INSERT INTO controls VALUES (3, 'slip_mm', 0.25);"
          "INSERT INTO control_scores VALUES (3, 7, 2, 1)");
  Store(folder.database()).put(read, *folder.record(plan.cases[2].address));
  collect(folder, read);
  const Database database(folder.database(), Database::Mode::read);
  const auto count = [&](const std::string& what) {
    Statement row = database.prepare("SELECT COUNT(*) FROM " + what);
    row.step();
    return row.integer(0);
  };
  EXPECT_EQ(count("cases WHERE status = 'done' AND grade = 'B'"), 12);
  EXPECT_EQ(count("controls WHERE metric = 'slip_mm' AND largest = 0.25"), 1);
  EXPECT_EQ(count("control_scores WHERE kept = 7"), 1);
  EXPECT_EQ(count("samples WHERE score IS NOT NULL"), 12);
  EXPECT_EQ(read_study_data(folder).done, 12);
  // Nothing of it was touched.
  for (const auto& [address, text] : written)
    EXPECT_EQ(io::read_text_file(folder.result_file(address).string(), 1000000), text);
  EXPECT_EQ(io::read_text_file((folder.path() / "controls.txt").string(), 1000), beside);
}

}  // namespace
}  // namespace loosefit::study
