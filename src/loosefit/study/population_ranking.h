#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/study/bootstrap.h"

// What the people of a study say of sites. A person's score at a site is the least over all that
// the person went through there; it is not clamped (placement::Score::margin), so that
// scores beyond good and below fail still differ. NaN: not rated.
namespace loosefit::study {

/// Share of people that may fall below the robust score.
inline constexpr double kRobustPeople = 0.05;
/// Up to so many people the 5th percentile is the least of their scores. The bootstrap of a least
/// value is not consistent: of limits without a difference a quarter would be told to differ.
inline constexpr int kWorstIsRobust = 20;
/// Of fewer people no interval is told in words, and no correlation (judgement).
inline constexpr int kFewestForInterval = 8;

/// Scores of one site, one per person; sites of one ranking have the same people in the same order.
struct SiteScores {
  std::string site;
  std::vector<double> scores;
};

/// Order statistics of the people that are rated; `draw` as of a bootstrap, else all.
double robust_score(const std::vector<double>& scores);
double robust_score(const std::vector<double>& scores, const std::vector<int>& draw);

/// Of n > 0 ascending values of people the one that the robust score is of descending ones: the
/// ⌈0.05 n⌉-th greatest, so that of 20 people it is the worst.
std::size_t robust_index_from_above(std::size_t n);
/// That one of values in any order; what is shown as their 95th percentile. NaN without values.
double robust_from_above(std::vector<double> values);

struct SitePopulation {
  std::string site;
  int rated = 0, people = 0;
  double median = 0, p5 = 0, p95 = 0;  ///< p5 is the robust score
  double passing = 0;                  ///< share of rated people with a score of at least `pass`
  Bounds median_interval, robust_interval, rank_interval;
  int rank = 0;  ///< 1 is best; sites tied with the best of a rank share it; 0: not rated
  /// Share of draws in which it comes first: probability to be the best. NaN, as are all figures:
  /// nobody is rated there, or there are no draws.
  double first = 0;
  std::vector<std::string> tied_with;
};

/// Ranks sites by robust score, then median, rated ones first; intervals, probability to be first
/// and ties (either order in more than a fifth of the draws; placement/rank.h) from one bootstrap
/// over people; without draws sites are tied that are equal. \throws InvalidInput when sites have
/// different numbers of people.
std::vector<SitePopulation> rank_population(const std::vector<SiteScores>& sites, double pass,
                                            const BootstrapOptions& options = {});

/// Sensors chosen one after another.
struct SensorChoice {
  std::string site;
  double mean = 0;    ///< over people, of the best score among those chosen so far, in [0, 1]
  double robust = 0;  ///< its 5th percentile
};

/// Which sites may not be taken together, and which not at all.
struct SensorConstraints {
  std::vector<std::vector<char>> apart;  ///< [i][j] = 1: too near to each other; may be empty
  std::vector<char> excluded;            ///< may be empty
};

/// Chooses up to k sites for mean over people of the best score among them: greedy, which for a
/// monotone submodular function is within 1 − 1/e of the best choice where k alone constrains it
/// (Nemhauser, Wolsey and Fisher 1978). Ties go to the earlier site; ends when nothing is gained.
/// A person who is not rated at a site has 0 there; who is rated at none is left out.
std::vector<SensorChoice> choose_sensors(const std::vector<SiteScores>& sites, int k,
                                         const SensorConstraints& constraints = {});

}  // namespace loosefit::study
