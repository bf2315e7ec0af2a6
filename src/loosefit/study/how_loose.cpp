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

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double crossing(double b0, double b1, double v0, double v1, double level) {
  if (!std::isfinite(v1) || v0 == v1) return b0;  // nothing known beyond: the level that holds
  return b0 + (level - v0) / (v1 - v0) * (b1 - b0);
}

std::string number(double bgm) { return fmt::format("{:.2f}", bgm + 0.0); }

}  // namespace

double greatest_passing(const std::vector<double>& bgm, const std::vector<double>& score,
                        double pass) {
  for (std::size_t k = bgm.size(); k-- > 0;)
    if (score[k] >= pass)
      return k + 1 == bgm.size() ? kInfinity
                                 : crossing(bgm[k], bgm[k + 1], score[k], score[k + 1], pass);
  return -kInfinity;
}

double greatest_passing(const std::vector<LooseLevel>& levels, double pass,
                        const std::vector<int>& draw) {
  std::vector<double> bgm, robust;
  for (const LooseLevel& level : levels) {
    bgm.push_back(level.bgm);
    robust.push_back(robust_score(level.scores, draw));
  }
  return greatest_passing(bgm, robust, pass);
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
  answer.limit = greatest_passing(bgm, robust, pass);
  // The tight end of the stretch that ends at the limit.
  answer.tightest = -kInfinity;
  std::size_t last = robust.size();
  while (last > 0 && !(robust[last - 1] >= pass)) --last;
  for (std::size_t k = last; k-- > 0;)
    if (!(robust[k] >= pass)) {
      answer.tightest = crossing(bgm[k + 1], bgm[k], robust[k + 1], robust[k], pass);
      break;
    }
  const int people = levels.empty() ? 0 : static_cast<int>(levels.front().scores.size());
  std::vector<double> limits;
  std::vector<std::vector<double>> robusts(levels.size());
  if (people >= 2)
    for (const std::vector<int>& draw :
         placement::bootstrap_draws(people, options.resamples, options.seed)) {
      std::vector<double> now;
      for (std::size_t k = 0; k < levels.size(); ++k) {
        now.push_back(robust_score(levels[k].scores, draw));
        robusts[k].push_back(now.back());
      }
      limits.push_back(greatest_passing(bgm, now, pass));
    }
  answer.interval = percentile_bounds(limits, options.confidence);
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

std::string in_words(const HowLoose& answer, const BootstrapOptions& options) {
  if (answer.curve.empty()) return "not tried";
  const std::string tight = number(answer.curve.front().bgm),
                    loose = number(answer.curve.back().bgm);
  const auto end = [&](double value) {
    if (value == kInfinity) return "beyond " + loose;
    if (value == -kInfinity) return std::string("nowhere");
    return number(value);
  };
  std::string text;
  if (answer.limit == kInfinity)
    text = "at least up to a BGM of " + loose + ", the loosest tried";
  else if (answer.limit == -kInfinity)
    text = "at none of the fits tried (BGM " + tight + " to " + loose + ")";
  else
    text = "up to a BGM of " + number(answer.limit);
  if (!std::isnan(answer.interval.low))
    text += fmt::format(", {:.0f} % interval {} to {}", 100 * options.confidence,
                        end(answer.interval.low), end(answer.interval.high));
  if (answer.tightest > -kInfinity && answer.limit > -kInfinity)
    text += "; it fails again tighter than " + number(answer.tightest);
  return text;
}

}  // namespace loosefit::study
