#include "loosefit/study/how_loose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "loosefit/base/quantile.h"
#include "loosefit/placement/resample.h"
#include "loosefit/study/population_ranking.h"

namespace loosefit::study {
namespace {

double crossing(double b0, double b1, double v0, double v1, double level) {
  if (!std::isfinite(v1) || v0 == v1) return b0;  // no line there: the level that holds
  return b0 + (level - v0) / (v1 - v0) * (b1 - b0);
}

std::string bgm_text(double bgm) { return fmt::format("{:.2f}", bgm + 0.0); }

}  // namespace

Bounds limit_bounds(const std::vector<double>& bgm, const std::vector<double>& score, double pass) {
  const std::size_t end = bgm.size();
  const auto rated_from = [&](std::size_t k) {
    while (k < end && std::isnan(score[k])) ++k;
    return k;
  };
  for (std::size_t k = end; k-- > 0;) {
    if (!(score[k] >= pass)) continue;
    if (k + 1 == end) return {kInfinity, kInfinity};
    const std::size_t next = rated_from(k + 1);
    if (next == end) return {bgm[k], kInfinity};
    if (next > k + 1) return {bgm[k], bgm[next]};
    const double limit = crossing(bgm[k], bgm[next], score[k], score[next], pass);
    return {limit, limit};
  }
  const std::size_t first = rated_from(0);
  if (first == end) return {-kInfinity, kInfinity};
  return {-kInfinity, first == 0 ? -kInfinity : bgm[first]};
}

Bounds limit_bounds(const std::vector<LooseLevel>& levels, double pass,
                    const std::vector<int>& draw) {
  std::vector<double> bgm, robust;
  for (const LooseLevel& level : levels) {
    bgm.push_back(level.bgm);
    robust.push_back(robust_score(level.scores, draw));
  }
  return limit_bounds(bgm, robust, pass);
}

double least_within(const std::vector<double>& bgm, const std::vector<double>& value,
                    double bound) {
  std::size_t k = bgm.size();
  while (k > 0 && value[k - 1] <= bound) --k;
  if (k == 0) return -kInfinity;
  if (k == bgm.size()) return kInfinity;
  return crossing(bgm[k], bgm[k - 1], value[k], value[k - 1], bound);
}

HowLoose how_loose(const std::vector<LooseLevel>& levels, double pass,
                   const BootstrapOptions& options) {
  HowLoose answer;
  std::vector<double> bgm, robust;
  for (const LooseLevel& level : levels) {
    LoosePoint& point = answer.curve.emplace_back();
    std::vector<double> rated = level.scores;
    std::erase_if(rated, [](double s) { return std::isnan(s); });
    point.bgm = level.bgm;
    point.rated = static_cast<int>(rated.size());
    point.robust = robust_score(level.scores);
    point.median = median(rated);
    point.passing = rated.empty()
                        ? std::numeric_limits<double>::quiet_NaN()
                        : static_cast<double>(std::count_if(rated.begin(), rated.end(),
                                                            [&](double s) { return s >= pass; })) /
                              static_cast<double>(rated.size());
    bgm.push_back(level.bgm);
    robust.push_back(point.robust);
  }
  const Bounds limit = limit_bounds(bgm, robust, pass);
  answer.limit = limit.low;
  answer.at_most = limit.high;
  // The tight end of the stretch that ends at the limit.
  answer.tightest = -kInfinity;
  std::size_t last = robust.size();
  while (last > 0 && !(robust[last - 1] >= pass)) --last;
  std::size_t passing = last;  ///< the tightest so far
  for (std::size_t k = last; k-- > 0;) {
    if (std::isnan(robust[k])) continue;
    if (robust[k] >= pass) {
      passing = k;
      continue;
    }
    answer.tightest = k + 1 == passing
                          ? crossing(bgm[passing], bgm[k], robust[passing], robust[k], pass)
                          : bgm[passing];
    break;
  }
  const int people = levels.empty() ? 0 : static_cast<int>(levels.front().scores.size());
  for (int p = 0; p < people; ++p)
    answer.people += std::ranges::any_of(
        levels, [&](const LooseLevel& level) { return !std::isnan(level.scores[p]); });
  std::vector<double> low, high;
  std::vector<std::vector<double>> robusts(levels.size());
  if (people >= 2)
    for (const std::vector<int>& draw :
         placement::bootstrap_draws(people, options.resamples, options.seed)) {
      std::vector<double> now;
      for (std::size_t k = 0; k < levels.size(); ++k) {
        now.push_back(robust_score(levels[k].scores, draw));
        robusts[k].push_back(now.back());
      }
      const Bounds drawn = limit_bounds(bgm, now, pass);
      low.push_back(drawn.low);
      high.push_back(drawn.high);
    }
  answer.interval = {percentile_bounds(low, options.confidence).low,
                     percentile_bounds(high, options.confidence).high};
  for (std::size_t k = 0; k < levels.size(); ++k)
    answer.curve[k].robust_interval = percentile_bounds(robusts[k], options.confidence);
  return answer;
}

const LoosePoint* most_passing(const HowLoose& answer) {
  const LoosePoint* most = nullptr;
  for (const LoosePoint& point : answer.curve)
    if (point.rated > 0 &&
        (!most || std::pair(point.passing, point.robust) > std::pair(most->passing, most->robust)))
      most = &point;
  return most;
}

std::string limit_text(const Bounds& limit, const Bounds& tried) {
  const auto text = [](double bgm) { return fmt::format("{:.3f}", bgm + 0.0); };
  if (limit.low == kInfinity) return "beyond " + text(tried.high);
  if (limit.high == -kInfinity) return "nowhere";
  if (limit.low == limit.high) return text(limit.low);
  if (std::isfinite(limit.low))
    return std::isfinite(limit.high) ? text(limit.low) + " to " + text(limit.high)
                                     : "at least " + text(limit.low);
  return std::isfinite(limit.high) ? "at most " + text(limit.high) : "not known";
}

std::string in_words(const HowLoose& answer, const BootstrapOptions& options) {
  if (answer.curve.empty()) return "not tried";
  const std::string tight = bgm_text(answer.curve.front().bgm),
                    loose = bgm_text(answer.curve.back().bgm);
  const auto end = [&](double value) {
    if (value == kInfinity) return "beyond " + loose;
    if (value == -kInfinity) return std::string("nowhere");
    return bgm_text(value);
  };
  std::string text;
  if (answer.limit == kInfinity)
    text = "at least up to a BGM of " + loose + ", the loosest tried";
  else if (answer.at_most == -kInfinity)
    text = "at none of the fits tried (BGM " + tight + " to " + loose + ")";
  else if (answer.limit == -kInfinity)
    text = "at none of the fits at which anybody is rated";
  else if (answer.at_most == kInfinity)
    text = "at least up to a BGM of " + bgm_text(answer.limit) + ", beyond which nobody is rated";
  else if (answer.at_most > answer.limit)
    text = "at least up to a BGM of " + bgm_text(answer.limit) + ", short of " +
           bgm_text(answer.at_most) + "; nobody is rated between";
  else
    text = "up to a BGM of " + bgm_text(answer.limit);
  if (!std::isnan(answer.interval.low) && answer.people >= kFewestForInterval) {
    text += fmt::format(", {:.0f} % interval {} to {}", 100 * options.confidence,
                        end(answer.interval.low), end(answer.interval.high));
    if (answer.people <= kWorstIsRobust) text += fmt::format(" of {} people only", answer.people);
  }
  if (answer.tightest > -kInfinity && answer.limit > -kInfinity)
    text += "; it fails again tighter than " + bgm_text(answer.tightest);
  return text;
}

}  // namespace loosefit::study
