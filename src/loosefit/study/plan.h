#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/scenario/scenario.h"
#include "loosefit/study/study_file.h"

namespace loosefit::study {

/// One case of a study: an ordinary scenario, and where it stands in the design.
struct PlannedCase {
  int number = 0;                   ///< from 1, in the order of the design
  std::vector<int> levels;          ///< per axis of the plan
  std::string address;              ///< content address: same address, same results
  std::string toml;                 ///< the resolved scenario
  int drapes = 1;                   ///< postures × donnings (or repeats)
  double edge_length = 0;           ///< [m]
  std::optional<double> looseness;  ///< BGM on the axis of looseness; nothing without one
  std::string wearer;               ///< digest of whose body it is, whatever the posture
  std::string wearing;  ///< digest of reference posture, postures and history of putting on
  bool several_postures = false, several_donnings = false;  ///< what some metrics need
};

/// All cases of a study, made before anything runs.
struct Plan {
  StudyFile study;  ///< its axes with the levels that were drawn
  std::vector<PlannedCase> cases;
  std::vector<std::string> cards;  ///< texts of the scorecards, one for each modality
  std::set<std::string> notes;     ///< on keys of scenarios that have no effect any more
  int drapes() const;
  std::string label(const PlannedCase& one) const;  ///< "person 3, fit 0.16"
};

/// Which level of each axis each case has. \param sizes number of levels per axis.
/// \throws InvalidInput for a paired design of axes of different lengths, and above 10⁶ cases.
std::vector<std::vector<int>> design_matrix(Design design, const std::vector<int>& sizes,
                                            int samples, std::uint64_t seed);

/// Composes and reads every scenario. \throws InvalidInput, with the case in words, for a scenario
/// that `loosefit run` would refuse, and for a site of `not_at` that no case has.
Plan make_plan(const StudyFile& study);

/// The scenario of one combination of levels.
scenario::Scenario compose(const StudyFile& study, const std::vector<int>& levels);

/// SHA-256 over all that results depend on: version of the program, resolved scenario with the
/// content of the files that it names in place of their paths, and the scorecards, as they are now.
/// Number of threads, pictures and the place of files do not matter.
std::string case_address(const scenario::Scenario& scenario,
                         const std::vector<std::string>& modalities);

/// Sixteen digits by which cases of two studies are told to have the same wearer (also when a scan
/// lies elsewhere), and to be worn in the same postures and put on alike.
std::string wearer_digest(const scenario::Scenario& scenario);
std::string wearing_digest(const scenario::Scenario& scenario);

/// Names of axes that change nothing: cases that differ in their levels alone, of which there are
/// some, are the same scenario.
std::vector<std::string> idle_axes(const Plan& plan);

/// In words: people of a file without a sex or an age, who take that of the base scenario.
std::vector<std::string> left_to_base(const Plan& plan);

/// Cases that are the same scenario as one before them, so have its results.
int same_as_others(const Plan& plan);

/// Drapes that a scenario asks for: postures times donnings or repeats.
int drapes_of(const scenario::Scenario& scenario);

/// Core seconds of each case by its address, by figures measured on an x86-64 core of 2.5 GHz
/// (docs/scaling.md); within a factor of two for shirts. Cases of one address run once.
std::map<std::string, double> estimated_work(const Plan& plan);

}  // namespace loosefit::study
