#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/study/how_loose.h"
#include "loosefit/study/metric_percentiles.h"
#include "loosefit/study/population_ranking.h"
#include "loosefit/study/study_data.h"

namespace loosefit::study {

/// How a result depends on what varies.
struct Sensitivity {
  std::string site, quantity;  ///< "score", or a metric
  std::string input;           ///< "fit", "person.chest", or an axis
  bool main_effect = false;    ///< share of variance by an axis; else rank correlation
  double value = kNotKnown;
  Bounds interval = {kNotKnown, kNotKnown};  ///< of correlations of scores
  int units = 0;  ///< that have a value of the quantity, and of the input of a correlation
};

/// What a study says of one kind of sensor.
struct ModalityAnalysis {
  std::string name, title;
  double pass = 0.5;
  std::vector<std::string> untold;  ///< criteria that no case can tell: scores are bounds
  /// Those that some cases alone cannot tell: the scores of these are bounds, those of others none.
  std::vector<std::string> untold_in_part;
  bool tellable = true;  ///< some criterion is told; else nothing can be rated
  int rated = 0;         ///< units that have a score at some site
  /// Per level of looseness, and last over all of them where there are several.
  std::vector<std::vector<SitePopulation>> rankings;
  std::vector<std::vector<MetricPercentiles>> metrics;  ///< by level as `rankings`
  std::map<std::string, HowLoose> how_loose;            ///< by site; empty without looseness
  std::vector<SensorChoice> sensors;                    ///< over all levels
  std::vector<Sensitivity> sensitivity;
  std::map<std::string, std::string> limiting;  ///< by site: the metric that limits most cases
};

/// From which BGM on a garment is comfortable for 95 % of the units: at most kUncomfortableArea of
/// its area presses with more than 4 kPa (maps/pressure.h, kPressureClasses).
struct ComfortLimit {
  /// −∞: already at the tightest tried; +∞: not at the loosest; NaN: not known anywhere.
  double limit = kNotKnown;
  std::vector<double> worst_share;  ///< per level: the 95th percentile over units; NaN: not known
  std::vector<double> unknown;      ///< BGM of the levels of which nothing is known
  int units = 0;                    ///< of which it is known at some level
};
inline constexpr double kUncomfortableArea = 0.01;

struct StudyAnalysis {
  StudyData data;
  std::vector<ModalityAnalysis> modalities;
  std::optional<ComfortLimit> comfort;  ///< with looseness
  BootstrapOptions options;
};

/// Scores of the people at a site by looseness; none without an axis of looseness, or when nobody
/// is rated at any level of it.
std::vector<LooseLevel> loose_levels(const StudyData& data, const SiteTable& site);

/// All statistics of a study (docs/studies.md 5). \throws as scorecard.
StudyAnalysis analyse(StudyData data);

/// "comfortable from a BGM of 0.05 on"
std::string in_words(const ComfortLimit& comfort);

/// Why a modality without a score has none: "needs several postures: nothing is rated", "no site
/// could be rated".
std::string nothing_rated(const ModalityAnalysis& modality);

/// One sentence per modality: the site that may be loosest, or ranks first; where none works, the
/// nearest, or that nobody passes anywhere. Then the comfort limit, in studies of looseness, and
/// how many cases carry warnings (cautions.h).
std::vector<std::string> headlines(const StudyAnalysis& analysis);

}  // namespace loosefit::study
