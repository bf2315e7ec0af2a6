#include "loosefit/study/limit_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/placement/resample.h"

namespace loosefit::study {
namespace {

int rated_people(const std::vector<LooseLevel>& levels) {
  int rated = 0;
  for (std::size_t i = 0; i < levels.front().scores.size(); ++i)
    rated += std::ranges::any_of(
        levels, [&](const LooseLevel& level) { return !std::isnan(level.scores[i]); });
  return rated;
}

/// All that a limit may be as a BGM: one that is still reached at the loosest level is that or
/// more.
Bounds possible(const Bounds& limit, const Bounds& tried) {
  return {limit.low == kInfinity ? tried.high : limit.low,
          limit.high == -kInfinity ? tried.low : limit.high};
}

bool is_number(const Bounds& limit) { return std::isfinite(limit.low) && limit.low == limit.high; }

/// All that B − A may be.
Bounds possible_difference(const Bounds& limit_a, const Bounds& limit_b,
                           const LimitDifference& of) {
  const Bounds a = possible(limit_a, of.tried_a), b = possible(limit_b, of.tried_b);
  return {b.low - a.high, b.high - a.low};
}

/// Draws of the people of both studies.
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
    const Bounds in_a = limit_bounds(a, pass, draws.a[i]), in_b = limit_bounds(b, pass, draws.b[i]);
    open += !is_number(in_a) || !is_number(in_b);
    const Bounds difference = possible_difference(in_a, in_b, result);
    low.push_back(difference.low);
    high.push_back(difference.high);
  }
  result.interval = {percentile_bounds(low, confidence).low,
                     percentile_bounds(high, confidence).high};
  result.open_draws = static_cast<double>(open) / static_cast<double>(draws.a.size());
}

/// Limits of all people and cases, without an interval.
LimitDifference difference_of_all(const std::vector<LooseLevel>& a,
                                  const std::vector<LooseLevel>& b, double pass) {
  LimitDifference result;
  const auto of_all = [&](const std::vector<LooseLevel>& levels) {
    std::vector<int> all(levels.front().scores.size());
    std::iota(all.begin(), all.end(), 0);
    return limit_bounds(levels, pass, all);
  };
  result.limit_a = of_all(a);
  result.limit_b = of_all(b);
  result.tried_a = {a.front().bgm, a.back().bgm};
  result.tried_b = {b.front().bgm, b.back().bgm};
  result.bounds = possible_difference(result.limit_a, result.limit_b, result);
  if (is_number(result.limit_a) && is_number(result.limit_b))
    result.difference = result.limit_b.low - result.limit_a.low;
  return result;
}

std::string passes(const std::string& study, const Bounds& limit, const Bounds& tried) {
  const auto bgm = [](double value) { return fmt::format("{:.3f}", value + 0.0); };
  if (limit.low == kInfinity)
    return study + " still passes at " + bgm(tried.high) + ", the loosest tried";
  if (limit.high == -kInfinity)
    return study + " passes at none of the fits tried, " + bgm(tried.low) + " to " +
           bgm(tried.high);
  if (limit.low == limit.high) return study + " passes up to " + bgm(limit.low);
  if (limit.low == -kInfinity)
    return std::isinf(limit.high)
               ? "nobody is rated in " + study
               : study + " fails from " + bgm(limit.high) + " on, short of which nobody is rated";
  if (std::isinf(limit.high))
    return study + " passes at least up to " + bgm(limit.low) + ", beyond which nobody is rated";
  return study + " passes at least up to " + bgm(limit.low) + " and fails at " + bgm(limit.high) +
         ", between which nobody is rated";
}

std::string signed_text(double bgm) { return fmt::format("{:+.3f}", bgm + 0.0); }

std::string end_text(double end) { return std::isfinite(end) ? signed_text(end) : "open"; }

bool is_open(const Bounds& bounds) { return std::isinf(bounds.low) && std::isinf(bounds.high); }

}  // namespace

const char* name(PeopleDrawn drawn) {
  if (drawn == PeopleDrawn::none) return "none";
  return drawn == PeopleDrawn::jointly ? "jointly" : "independently";
}

bool LimitDifference::differs() const {
  return std::min(people_a, people_b) > kWorstIsRobust && (interval.low > 0 || interval.high < 0);
}

LimitDifference limit_difference(const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b,
                                 double pass, const std::vector<int>& in_b,
                                 const BootstrapOptions& options) {
  LimitDifference result = difference_of_all(a, b, pass);
  result.people_a = rated_people(a);
  result.people_b = rated_people(b);
  if (result.people_a < 2 || result.people_b < 2) return result;
  result.drawn = in_b.empty() ? PeopleDrawn::independently : PeopleDrawn::jointly;
  const PeopleDraws draws = draw_people(static_cast<int>(a.front().scores.size()),
                                        static_cast<int>(b.front().scores.size()), in_b, options);
  add_interval(a, b, pass, draws, options.confidence, result);
  return result;
}

LimitDifference limit_difference_of_wearer(const std::vector<LooseLevel>& a,
                                           const std::vector<LooseLevel>& b, double pass) {
  LimitDifference result = difference_of_all(a, b, pass);
  result.people_a = result.people_b = 1;
  return result;
}

std::string difference_text(const LimitDifference& limits) {
  if (!std::isnan(limits.difference)) return signed_text(limits.difference);
  const auto& [low, high] = limits.bounds;
  if (is_open(limits.bounds)) return "-";
  if (std::isinf(high)) return "at least " + signed_text(low);
  if (std::isinf(low)) return "at most " + signed_text(high);
  return signed_text(low) + " to " + signed_text(high);
}

std::string limit_interval_text(const Bounds& interval) {
  if (std::isnan(interval.low)) return "-";
  return end_text(interval.low) + " to " + end_text(interval.high);
}

std::string in_words(const LimitDifference& limits, const BootstrapOptions& options) {
  std::string text = "B - A = " + difference_text(limits);
  if (std::isnan(limits.difference))
    text = (is_open(limits.bounds) ? "no number" : "B - A is " + difference_text(limits)) + ": " +
           passes("A", limits.limit_a, limits.tried_a) + "; " +
           passes("B", limits.limit_b, limits.tried_b);
  if (std::isnan(limits.interval.low)) return text + ", no interval";
  text += fmt::format(", {:.0f} % interval {}", 100 * options.confidence,
                      limit_interval_text(limits.interval));
  if (limits.open_draws > 0)
    text += fmt::format("; in {:.1f} % of the draws a limit is no number", 100 * limits.open_draws);
  return text;
}

}  // namespace loosefit::study
