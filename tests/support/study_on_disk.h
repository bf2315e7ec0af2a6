#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "loosefit/study/plan.h"
#include "loosefit/study/study_folder.h"
#include "support/scratch_folder.h"

// A study of four people in three fits on the disk, with results that are made up.
namespace loosefit::study {
namespace fs = std::filesystem;

inline constexpr const char* kStudy =
    "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
    "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 4 }\n"
    "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1, 0.2]\n";

inline CaseRecord made_up(const std::string& address, double score) {
  CaseRecord record;
  record.address = address;
  record.status = CaseStatus::done;
  record.residual = 0.1 / 3;
  record.drapes_asked = record.drapes_counted = 1;
  record.body = {{"chest", 0.9 + 1e-17}, {"odd", std::nan("")}};
  record.fit = {{"chest", 0.1}};
  record.garment = {{"uncomfortable_share", 0.0}};
  record.maps["distance_mm"] = {{"median", 3.25}};
  record.sites.push_back({"imu-uncalibrated", "scapula", "back", "back", 0.1, 0.2, 0, 0, 1, ""});
  SampleRecord sample;
  sample.modality = "imu-uncalibrated";
  sample.site = "scapula";
  sample.score = std::clamp(score, 0.0, 1.0);
  sample.margin = score;
  sample.limiting = "rotation_deg";
  sample.metrics = {{"rotation_deg", 10 - 5 * score}};
  record.samples.push_back(sample);
  record.versions = {{"loosefit", "0"}};
  record.execution = {12.5, 100, "somewhere"};
  return record;
}

struct StudyOnDisk : ::testing::Test {
  const support::ScratchFolder base;
  Plan plan = make_plan(parse_study_file(kStudy, "x.toml"));

  /// Score of a case: falls with the fit, rises with the person.
  static double score(const PlannedCase& one) {
    return 0.9 - 0.3 * one.levels[1] + 0.05 * one.levels[0];
  }
  StudyFolder planned(const std::string& name) const {
    const StudyFolder folder(base / name);
    folder.write_plan(plan);
    return folder;
  }
  void finish(const StudyFolder& folder, const PlannedCase& one) const {
    write_whole(folder.result_file(one.address), record_json(made_up(one.address, score(one))));
  }
  StudyFolder finished(const std::string& name) const {
    const StudyFolder folder = planned(name);
    for (const PlannedCase& one : plan.cases) finish(folder, one);
    return folder;
  }
};

}  // namespace loosefit::study
