#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/io/plain_files.h"
#include "loosefit/study/case_record.h"
#include "loosefit/study/folder_plan.h"
#include "loosefit/study/plan.h"
#include "loosefit/study/set_aside.h"

// The folder of a study:
//
//   study.toml                the study file as it was
//   plan.json                 axes with their levels, the cases in their order, and the scorecards
//                             as they were
//   cases/ab/<address>/       scenario.toml, and result.json once the case has run
//   study.sqlite              everything in tables (store.h), made from the above
//   study-report.html, …      what is made from that
//   slurm/                    of the Slurm executor
//   .lock                     held by the runner
namespace loosefit::study {

/// What of it is done.
struct FolderState {
  std::vector<std::string> open;  ///< addresses without a whole result, each once, in case order
  int open_cases = 0, done = 0, sealed = 0, failed = 0;  ///< cases, by their numbers
  int scored = 0;  ///< of the done ones, those with a rated sample
};

class StudyFolder {
 public:
  /// Does not touch the disk. \throws InvalidInput for an empty name.
  explicit StudyFolder(std::filesystem::path path);
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path case_folder(const std::string& address) const;
  std::filesystem::path scenario_file(const std::string& address) const;
  std::filesystem::path result_file(const std::string& address) const;
  std::filesystem::path database() const { return path_ / "study.sqlite"; }

  /// What keeps this user from bringing up the database of a study that is there: the folder,
  /// its database or its lock, which may only be read; nothing when all may be written.
  std::optional<std::filesystem::path> read_only_part() const;
  /// A folder that is there must be empty or a study. Changes nothing. \throws IoError,
  /// InvalidInput.
  void check_ours() const;
  /// Writes study.toml, plan.json and the scenarios that are not there as they are; a folder that
  /// is there must be empty or this study: one of its name, or with a case of it; where its
  /// plan.json cannot be read, one of the same study file. Results of earlier plans stay. A
  /// study.toml that somebody has changed and a plan.json that cannot be read are set aside.
  /// \throws IoError, InvalidInput.
  void write_plan(
      const Plan& plan, const SetAside& tell = [](const auto&) {}) const;
  /// \throws InvalidInput when the folder is no study.
  FolderPlan read_plan() const;
  /// The record of a case as it lies there; nothing when it has not run.
  std::optional<CaseRecord> record(const std::string& address) const;
  /// Reads all results of a plan.
  FolderState state(const FolderPlan& plan) const;
  /// Forgets the results of failed cases, which then run again. Returns how many.
  int forget_failed(const FolderPlan& plan) const;

 private:
  std::optional<FolderPlan> plan_before() const;
  void check_same_study(const Plan& plan, const std::optional<FolderPlan>& before) const;
  std::filesystem::path path_;
};

/// Held while a runner works on a study. \throws InvalidInput naming the other process when
/// another one holds it; IoError.
class StudyLock {
 public:
  explicit StudyLock(const StudyFolder& folder);
  ~StudyLock();
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// Writes a file so that it is there as a whole or not at all, whenever the machine stops: beside
/// it, to the disk, then renamed, and the folder to the disk. \throws IoError
void write_whole(const std::filesystem::path& file, const std::string& text);
/// Removes what writers of a file that were killed have left beside it; none may be at work.
void remove_left_overs(const std::filesystem::path& file);

}  // namespace loosefit::study
