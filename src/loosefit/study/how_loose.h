#pragma once
#include <limits>
#include <string>
#include <vector>

#include "loosefit/study/bootstrap.h"

namespace loosefit::study {

/// Of limits: beyond all fits that were tried.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What the people of a study say at one looseness.
struct LooseLevel {
  double bgm = 0;              ///< body-garment mobility
  std::vector<double> scores;  ///< per person, not clamped; NaN: not rated
};

/// One point of the curve of robust score over looseness.
struct LoosePoint {
  double bgm = 0;
  int rated = 0;
  double robust = 0, median = 0, passing = 0;
  Bounds robust_interval;
};

/// The answer to "how loose may it be?".
struct HowLoose {
  /// Greatest BGM at which the robust score is known to pass; −∞: at none that was tried, +∞: still
  /// at the loosest.
  double limit = 0;
  double at_most = 0;   ///< it may be up to this (limit_bounds); equal where it is known
  Bounds interval;      ///< ends may be infinite, likewise
  double tightest = 0;  ///< BGM below the limit under which it fails again; −∞: nowhere
  int people = 0;       ///< rated at some level
  std::vector<LoosePoint> curve;
};

/// The greatest BGM that passes, as far as it is known; equal ends: it is. Between two neighbouring
/// levels of which the tighter passes and the looser fails it is where the straight line between
/// their scores meets `pass`; −∞ when none passes, +∞ when the loosest does. A level without a
/// score (NaN) tells nothing: the limit lies between the levels around it that have one; it may be
/// anything beyond where no looser one has.
/// \pre levels ascend in BGM
Bounds limit_bounds(const std::vector<double>& bgm, const std::vector<double>& score, double pass);

/// The same of the robust scores of a draw of people.
Bounds limit_bounds(const std::vector<LooseLevel>& levels, double pass,
                    const std::vector<int>& draw);

/// Smallest BGM from which on, up to the loosest, `value` is at most `bound`: interpolated
/// likewise. −∞: already at the tightest; +∞: not even at the loosest.
double least_within(const std::vector<double>& bgm, const std::vector<double>& value, double bound);

/// Where most people pass, of points alike that with the better robust score; none where nobody is
/// rated.
const LoosePoint* most_passing(const HowLoose& answer);

/// Levels in ascending order of BGM, the same people in all. The interval draws people, the same
/// ones at all levels, and finds the limit anew.
HowLoose how_loose(const std::vector<LooseLevel>& levels, double pass,
                   const BootstrapOptions& options = {});

/// "0.180", "nowhere", "beyond 0.300"; of bounds "at least 0.200", "0.100 to 0.300".
/// \param tried tightest and loosest BGM
std::string limit_text(const Bounds& limit, const Bounds& tried);

/// "up to a BGM of 0.18, 90 % interval 0.12 to 0.24", "at none of the fits tried (BGM 0.00 to
/// 0.30)", "at least up to a BGM of 0.30, the loosest tried", "at least up to a BGM of 0.20, beyond
/// which nobody is rated". Up to kWorstIsRobust people the interval says of how few; below
/// kFewestForInterval (population_ranking.h) it is left out.
std::string in_words(const HowLoose& answer, const BootstrapOptions& options = {});

}  // namespace loosefit::study
