#pragma once
#include <string>
#include <vector>

#include "loosefit/study/case_record.h"
#include "loosefit/study/how_loose.h"

namespace loosefit::study {

/// How much looser a garment may be in study B than in study A, at one site. The limits are those
/// that each study tells for itself: of all its people and cases.
struct LimitDifference {
  std::string modality, site;
  double limit_a = kNotKnown, limit_b = kNotKnown;  ///< as HowLoose::limit
  Bounds tried_a, tried_b;                          ///< tightest and loosest BGM
  int people_a = 0, people_b = 0;                   ///< that are rated at some fit
  /// Whether each draw takes the same people in both studies; otherwise each study is drawn by
  /// itself.
  bool paired = false;
  /// B − A; NaN unless both limits are numbers. Then the interval, too, is not known.
  double difference = kNotKnown;
  /// By bootstrap over people. A draw whose limit lies outside the fits tried counts as all that it
  /// may be, so ends may be infinite: the draws do not bound the difference on that side.
  Bounds interval = {kNotKnown, kNotKnown};
  double open_draws = kNotKnown;  ///< share of draws in which a limit is no number
  bool differs() const { return interval.low > 0 || interval.high < 0; }
};

/// `in_b`: for each person of `a` the index of the same one in `b`; empty: they are others.
/// \pre levels as for how_loose, of at least one level each
LimitDifference limit_difference(const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b,
                                 double pass, const std::vector<int>& in_b,
                                 const BootstrapOptions& options = {});

/// "B - A = +0.05, 90 % interval +0.02 to +0.08", "no number: A still passes at 0.30, the loosest
/// tried; B passes up to 0.18".
std::string in_words(const LimitDifference& limits, const BootstrapOptions& options = {});

/// "0.18", "beyond 0.30", "nowhere".
std::string limit_text(double limit, const Bounds& tried);
/// "+0.02 to +0.08", "open to +0.08"; "-" when nothing is known.
std::string limit_interval_text(const Bounds& interval);

}  // namespace loosefit::study
