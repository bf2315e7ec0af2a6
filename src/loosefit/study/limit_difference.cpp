#include "loosefit/study/limit_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/placement/resample.h"

namespace loosefit::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int rated_people(const std::vector<LooseLevel>& levels) {
  int rated = 0;
  for (std::size_t i = 0; i < levels.front().scores.size(); ++i)
    rated += std::ranges::any_of(
        levels, [&](const LooseLevel& level) { return !std::isnan(level.scores[i]); });
  return rated;
}

/// All that a limit may be: one that is still reached at the loosest level is that or more.
Bounds possible(double limit, const Bounds& tried) {
  if (limit == kInfinity) return {tried.high, kInfinity};
  if (limit == -kInfinity) return {-kInfinity, tried.low};
  return {limit, limit};
}

/// PeopleDraws of the people of both studies.
struct PeopleDraws {
  std::vector<std::vector<int>> a, b;
};

PeopleDraws draw_people(int people_a, int people_b, const std::vector<int>& in_b,
                        const BootstrapOptions& options) {
  PeopleDraws draws;
  draws.a = placement::bootstrap_draws(people_a, options.resamples, options.seed);
  if (in_b.empty()) {
    // Of the seed of A, as many people would be drawn together by their numbers.
    draws.b = placement::bootstrap_draws(people_b, options.resamples, options.seed + 1);
    return draws;
  }
  draws.b = draws.a;
  for (std::vector<int>& draw : draws.b)
    for (int& person : draw) person = in_b[person];
  return draws;
}

void add_interval(const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b, double pass,
                  const PeopleDraws& draws, double confidence, LimitDifference& result) {
  std::vector<double> low, high;
  int open = 0;
  for (std::size_t i = 0; i < draws.a.size(); ++i) {
    const double in_a = greatest_passing(a, pass, draws.a[i]);
    const double in_b = greatest_passing(b, pass, draws.b[i]);
    open += std::isinf(in_a) || std::isinf(in_b);
    const Bounds of_a = possible(in_a, result.tried_a), of_b = possible(in_b, result.tried_b);
    low.push_back(of_b.low - of_a.high);
    high.push_back(of_b.high - of_a.low);
  }
  result.interval = {percentile_bounds(low, confidence).low,
                     percentile_bounds(high, confidence).high};
  result.open_draws = static_cast<double>(open) / static_cast<double>(draws.a.size());
}

std::string passes(const std::string& study, double limit, const Bounds& tried) {
  if (limit == kInfinity)
    return fmt::format("{} still passes at {:.2f}, the loosest tried", study, tried.high);
  if (limit == -kInfinity)
    return fmt::format("{} passes at none of the fits tried, {:.2f} to {:.2f}", study, tried.low,
                       tried.high);
  return fmt::format("{} passes up to {:.2f}", study, limit);
}

std::string end_text(double end) {
  return std::isfinite(end) ? fmt::format("{:+.3f}", end + 0.0) : "open";
}

}  // namespace

LimitDifference limit_difference(const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b,
                                 double pass, const std::vector<int>& in_b,
                                 const BootstrapOptions& options) {
  LimitDifference result;
  const int all_a = static_cast<int>(a.front().scores.size());
  const int all_b = static_cast<int>(b.front().scores.size());
  const auto everybody = [](int people) {
    std::vector<int> all(people);
    std::iota(all.begin(), all.end(), 0);
    return all;
  };
  result.limit_a = greatest_passing(a, pass, everybody(all_a));
  result.limit_b = greatest_passing(b, pass, everybody(all_b));
  result.tried_a = {a.front().bgm, a.back().bgm};
  result.tried_b = {b.front().bgm, b.back().bgm};
  result.people_a = rated_people(a);
  result.people_b = rated_people(b);
  result.paired = !in_b.empty();
  if (!std::isfinite(result.limit_a) || !std::isfinite(result.limit_b)) return result;
  result.difference = result.limit_b - result.limit_a;
  if (result.people_a >= 2 && result.people_b >= 2)
    add_interval(a, b, pass, draw_people(all_a, all_b, in_b, options), options.confidence, result);
  return result;
}

std::string limit_text(double limit, const Bounds& tried) {
  if (limit == kInfinity) return fmt::format("beyond {:.2f}", tried.high);
  if (limit == -kInfinity) return "nowhere";
  return fmt::format("{:.2f}", limit + 0.0);
}

std::string limit_interval_text(const Bounds& interval) {
  if (std::isnan(interval.low)) return "-";
  return end_text(interval.low) + " to " + end_text(interval.high);
}

std::string in_words(const LimitDifference& limits, const BootstrapOptions& options) {
  if (std::isnan(limits.difference))
    return "no number: " + passes("A", limits.limit_a, limits.tried_a) + "; " +
           passes("B", limits.limit_b, limits.tried_b);
  std::string text = fmt::format("B - A = {:+.3f}", limits.difference + 0.0);
  if (std::isnan(limits.interval.low)) return text + ", no interval";
  text += fmt::format(", {:.0f} % interval {}", 100 * options.confidence,
                      limit_interval_text(limits.interval));
  if (limits.open_draws > 0)
    text += fmt::format("; in {:.1f} % of the draws a limit is outside the fits tried",
                        100 * limits.open_draws);
  return text;
}

}  // namespace loosefit::study
