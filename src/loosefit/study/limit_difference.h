#pragma once
#include <string>
#include <vector>

#include "loosefit/study/case_record.h"
#include "loosefit/study/how_loose.h"
#include "loosefit/study/population_ranking.h"

namespace loosefit::study {

/// How a draw takes the people of two studies: the same ones in both, those of each study by
/// itself, or not at all.
enum class PeopleDrawn { jointly, independently, none };
const char* name(PeopleDrawn drawn);

/// How much looser a garment may be in study B than in study A, at one site. The limits are those
/// that each study tells for itself: of all its people and cases.
struct LimitDifference {
  std::string modality, site;
  Bounds limit_a, limit_b;         ///< from HowLoose::limit to at_most
  Bounds tried_a, tried_b;         ///< tightest and loosest BGM
  int people_a = 0, people_b = 0;  ///< that are rated at some fit; 1 without an axis of people
  PeopleDrawn drawn = PeopleDrawn::none;
  /// B − A; NaN unless both limits are numbers.
  double difference = kNotKnown;
  Bounds bounds = {kNotKnown, kNotKnown};  ///< all that B − A may be; ends may be infinite
  /// By bootstrap over people. A draw whose limit is no number counts as all that it may be, so
  /// ends may be infinite: the draws do not bound the difference on that side. NaN without draws.
  Bounds interval = {kNotKnown, kNotKnown};
  double open_draws = kNotKnown;  ///< share of draws in which a limit is no number
  /// Never with few people: see kWorstIsRobust (population_ranking.h).
  bool differs() const;
};

/// `in_b`: for each person of `a` the index of the same one in `b`; empty: they are others.
/// \pre levels as for how_loose, of at least one level each
LimitDifference limit_difference(const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b,
                                 double pass, const std::vector<int>& in_b,
                                 const BootstrapOptions& options = {});

/// The same of studies of one wearer each, whose levels have a score per case: there is nobody to
/// draw, and no interval.
LimitDifference limit_difference_of_wearer(const std::vector<LooseLevel>& a,
                                           const std::vector<LooseLevel>& b, double pass);

/// "B - A = +0.050, 90 % interval +0.020 to +0.080", "B - A is at least +0.200: A passes up to
/// 0.100; B still passes at 0.300, the loosest tried", "no number: A …; B …".
std::string in_words(const LimitDifference& limits, const BootstrapOptions& options = {});

/// "+0.050", "at least +0.200", "at most -0.200", "+0.050 to +0.150"; "-" when nothing is known.
std::string difference_text(const LimitDifference& limits);
/// "+0.020 to +0.080", "open to +0.080"; "-" when nothing is known.
std::string limit_interval_text(const Bounds& interval);

}  // namespace loosefit::study
