#include "loosefit/study/population_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/placement/rank.h"
#include "loosefit/placement/resample.h"

namespace loosefit::study {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> rated(const std::vector<double>& scores) {
  std::vector<double> values;
  for (const double s : scores)
    if (!std::isnan(s)) values.push_back(s);
  return values;
}

std::vector<double> rated(const std::vector<double>& scores, const std::vector<int>& draw) {
  std::vector<double> values;
  for (const int i : draw)
    if (!std::isnan(scores[i])) values.push_back(scores[i]);
  return values;
}

struct Key {
  double robust = kNaN, median = kNaN;
};

Key key_of(std::vector<double> values) {
  if (values.empty()) return {};
  return {quantile(values, kRobustPeople), median(std::move(values))};
}

/// Whether a is better: by robust score, then median; what is not rated comes last.
bool better(const Key& a, const Key& b) {
  if (std::isnan(a.robust) || std::isnan(b.robust))
    return !std::isnan(a.robust) && std::isnan(b.robust);
  if (a.robust != b.robust) return a.robust > b.robust;
  return a.median > b.median;
}

}  // namespace

std::size_t robust_index_from_above(std::size_t n) {
  return n - 1 - quantile_index(n, kRobustPeople);
}

double robust_from_above(std::vector<double> values) {
  if (values.empty()) return kNaN;
  std::ranges::sort(values);
  return values[robust_index_from_above(values.size())];
}

double robust_score(const std::vector<double>& scores) { return key_of(rated(scores)).robust; }

double robust_score(const std::vector<double>& scores, const std::vector<int>& draw) {
  return key_of(rated(scores, draw)).robust;
}

std::vector<SitePopulation> rank_population(const std::vector<SiteScores>& sites, double pass,
                                            const BootstrapOptions& options) {
  if (sites.empty()) return {};
  const std::size_t people = sites.front().scores.size(), n = sites.size();
  for (const SiteScores& site : sites)
    if (site.scores.size() != people)
      throw InvalidInput("sites of a study have different numbers of people");
  std::vector<Key> keys;
  for (const SiteScores& site : sites) keys.push_back(key_of(rated(site.scores)));
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return better(keys[a], keys[b]); });
  // The same people are drawn for all sites.
  std::vector<std::vector<double>> medians(n), robusts(n), ranks(n);
  std::vector<std::vector<double>> before(n, std::vector<double>(n, 0.0));
  std::vector<double> first(n, 0.0);
  int draws = 0;
  if (people >= 2)
    for (const std::vector<int>& draw :
         placement::bootstrap_draws(static_cast<int>(people), options.resamples, options.seed)) {
      ++draws;
      std::vector<Key> now;
      for (const SiteScores& site : sites) now.push_back(key_of(rated(site.scores, draw)));
      for (std::size_t i = 0; i < n; ++i) {
        medians[i].push_back(now[i].median);
        robusts[i].push_back(now[i].robust);
        double rank = 1;
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i) continue;
          const bool behind = better(now[j], now[i]), ahead = better(now[i], now[j]);
          rank += behind ? 1 : ahead ? 0 : 0.5;
          before[i][j] += ahead ? 1 : behind ? 0 : 0.5;
        }
        ranks[i].push_back(rank);
      }
      double best = static_cast<double>(n) + 1;
      for (std::size_t i = 0; i < n; ++i)
        if (!std::isnan(now[i].robust)) best = std::min(best, ranks[i].back());
      int shared = 0;
      for (std::size_t i = 0; i < n; ++i) shared += ranks[i].back() == best;
      for (std::size_t i = 0; i < n; ++i)
        if (ranks[i].back() == best) first[i] += 1.0 / shared;
    }
  const double tie_share = placement::RankOptions{}.tie_share;
  const auto tied = [&](int a, int b) {
    if (std::isnan(keys[a].robust) || std::isnan(keys[b].robust)) return false;
    if (draws == 0) return !better(keys[a], keys[b]) && !better(keys[b], keys[a]);
    return before[a][b] > tie_share * draws && before[b][a] > tie_share * draws;
  };
  std::vector<SitePopulation> ranked;
  int leader = -1, rank = 0;
  for (std::size_t place = 0; place < n; ++place) {
    const int i = order[place];
    SitePopulation& site = ranked.emplace_back();
    const std::vector<double> values = rated(sites[i].scores);
    site.site = sites[i].site;
    site.rated = static_cast<int>(values.size());
    site.people = static_cast<int>(people);
    site.median = keys[i].median;
    site.p5 = keys[i].robust;
    site.p95 = robust_from_above(values);
    site.passing = values.empty()
                       ? kNaN
                       : static_cast<double>(std::count_if(values.begin(), values.end(),
                                                           [&](double s) { return s >= pass; })) /
                             static_cast<double>(values.size());
    site.median_interval = percentile_bounds(medians[i], options.confidence);
    site.robust_interval = percentile_bounds(robusts[i], options.confidence);
    site.rank_interval = {kNaN, kNaN};
    site.first = kNaN;
    if (values.empty()) continue;
    site.rank_interval = percentile_bounds(ranks[i], options.confidence);
    if (draws > 0) site.first = first[i] / draws;
    if (leader < 0 || !tied(leader, i)) {
      leader = i;
      rank = static_cast<int>(place) + 1;
    }
    site.rank = rank;
    for (const int j : order)
      if (j != i && tied(i, j)) site.tied_with.push_back(sites[j].site);
  }
  return ranked;
}

std::vector<SensorChoice> choose_sensors(const std::vector<SiteScores>& sites, int k,
                                         const SensorConstraints& constraints) {
  std::vector<SensorChoice> chosen;
  if (sites.empty() || sites.front().scores.empty()) return chosen;
  // Who is rated nowhere counts neither as passing nor as failing.
  std::vector<std::size_t> rated;
  for (std::size_t p = 0; p < sites.front().scores.size(); ++p)
    if (std::ranges::any_of(sites, [p](const SiteScores& s) { return !std::isnan(s.scores[p]); }))
      rated.push_back(p);
  const std::size_t people = rated.size();
  const auto score = [&](std::size_t site, std::size_t p) {
    const double s = sites[site].scores[rated[p]];
    return std::isnan(s) ? 0.0 : std::clamp(s, 0.0, 1.0);
  };
  std::vector<double> best(people, 0.0);
  std::vector<char> out(sites.size(), 0);
  if (!constraints.excluded.empty()) out = constraints.excluded;
  double reached = 0;
  while (static_cast<int>(chosen.size()) < k) {
    int taken = -1;
    double most = reached;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (out[i]) continue;
      double sum = 0;
      for (std::size_t p = 0; p < people; ++p) sum += std::max(best[p], score(i, p));
      if (sum > most) {
        most = sum;
        taken = static_cast<int>(i);
      }
    }
    if (taken < 0) break;
    reached = most;
    for (std::size_t p = 0; p < people; ++p) best[p] = std::max(best[p], score(taken, p));
    out[taken] = 1;
    if (!constraints.apart.empty())
      for (std::size_t j = 0; j < sites.size(); ++j)
        if (constraints.apart[taken][j]) out[j] = 1;
    chosen.push_back(
        {sites[taken].site, reached / static_cast<double>(people), quantile(best, kRobustPeople)});
  }
  return chosen;
}

}  // namespace loosefit::study
