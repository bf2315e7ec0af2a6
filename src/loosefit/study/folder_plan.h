#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/scorecard.h"
#include "loosefit/study/axis.h"

namespace loosefit::study {

/// One case as plan.json keeps it.
struct FolderCase {
  int number = 0;
  std::vector<int> levels;  ///< per axis
  std::string address;
  int drapes = 1;
  double edge_length = 0;
  std::optional<double> looseness;  ///< as PlannedCase; absent in plans of earlier programs
  std::string wearer, wearing;      ///< as PlannedCase; empty in plans of earlier programs
};

/// plan.json: what a study is made of, without its study file.
struct FolderPlan {
  std::string name, version, file_sha256;
  std::uint64_t seed = 1;
  std::string design;
  std::vector<std::string> modalities;
  std::vector<std::string> cards;  ///< as of Plan; empty in plans of earlier programs
  std::string looseness;
  int sensors = 3;
  double spacing = 0.05;
  std::vector<std::string> not_at;
  std::vector<Axis> axes;  ///< without patches and keys
  std::vector<FolderCase> cases;
};

/// Names of the scorecards, wherever their files are.
std::vector<std::string> scorecard_names(const FolderPlan& plan);
/// A scorecard as it was when the study was planned, whatever its file says now; as the file is
/// where an earlier program made the plan. \throws as parse_scorecard, load_scorecard.
placement::Scorecard scorecard(const FolderPlan& plan, std::size_t modality);
/// Of the study file and the cases: tells the report of this plan from that of another.
std::string plan_sha256(const FolderPlan& plan);
/// The axis of people in a plan; −1: none.
int people_axis(const FolderPlan& plan);
/// Whether people, listed or drawn, or draws of anything else tell its cases apart: else cases are
/// values that were chosen, of which drawing with replacement says nothing.
bool varies_by_chance(const FolderPlan& plan);
/// The axis that answers how loose it may be; −1: none.
int looseness_axis(const FolderPlan& plan);
/// "person 3, fit 0.16"
std::string label(const FolderPlan& plan, const FolderCase& one);

}  // namespace loosefit::study
