#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "loosefit/study/study_folder.h"

namespace loosefit::study {

/// A case that gave no scores, or fewer than asked for. Statuses: open, failed, sealed, incomplete
/// (donnings are left out), no scores (it is done, but no sample of it is rated).
struct CaseTrouble {
  int number = 0;
  std::string label, status, reason;
};

/// Scores of one site for one modality.
struct SiteTable {
  std::string site;
  double x = kNotKnown, y = kNotKnown, z = kNotKnown;  ///< on the first wearer [m]
  std::vector<double> by_case;  ///< per case its lowest score over donnings, not clamped; NaN: none
  std::vector<std::map<int, double>> by_donning;       ///< per case those that are rated
  std::map<std::string, std::vector<double>> metrics;  ///< per case the mean over donnings
  std::map<std::string, int> limiting;                 ///< metric → in how many cases it limits
};

/// Results of a study by case, as the statistics need them. `units` are the people, or the cases of
/// a study without people; `levels` are those of the looseness axis (one without), in ascending
/// order of BGM; of a sampled one bins of equally many cases.
struct StudyData {
  FolderPlan plan;
  std::vector<std::string> modalities;
  std::map<std::string, std::vector<SiteTable>> sites;  ///< by modality
  /// By modality the criteria that cases cannot tell: how many of those that are done.
  std::map<std::string, std::map<std::string, int>> untold;
  std::vector<int> unit_of_case, level_of_case;  ///< indices
  std::vector<std::string> units;
  std::vector<double> level_bgm;  ///< NaN for the one level of a study without looseness
  std::vector<std::string> level_labels;
  std::vector<double> uncomfortable_share;            ///< per case, of the garment's area
  std::vector<std::map<std::string, double>> inputs;  ///< per case
  std::vector<CaseTrouble> troubles;
  std::vector<std::vector<std::string>> warnings;  ///< per case
  int ran = 0;                                     ///< cases that have ended, well or not
  int done = 0;                                    ///< cases at rest and worn
  int scored = 0;           ///< cases of which a sample is rated, by any modality
  double core_seconds = 0;  ///< that they have taken, those that are the same scenario once
  int drapes = 0, drapes_counted = 0;
};

/// Reads all results of a study. \throws as StudyFolder.
StudyData read_study_data(const StudyFolder& folder);

/// How many of `units` have a score at some site for some modality.
int rated_units(const StudyData& data);
/// The same for one modality.
int rated_units(const StudyData& data, const std::string& modality);

/// How many units could be rated at a level (−1: over all levels): all people, also those whom a
/// design gave no case there; without an axis of people the cases at that level.
int asked_units(const StudyData& data, int level);

/// Whether the units are a random sample of a population: people that were drawn, not spread evenly
/// or listed in a file, and not cases of one body.
bool is_sample(const StudyData& data);

/// Scores per unit of a site at a level (−1: over all levels): the least over the cases of that
/// unit; NaN where none is rated.
std::vector<double> unit_scores(const StudyData& data, const SiteTable& site, int level);

/// The greatest of a case quantity per unit at a level.
std::vector<double> greatest_by_unit(const StudyData& data, const std::vector<double>& by_case,
                                     int level);

}  // namespace loosefit::study
