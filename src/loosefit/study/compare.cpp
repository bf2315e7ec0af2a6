#include "loosefit/study/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/io/csv.h"
#include "loosefit/study/counterparts.h"

namespace loosefit::study {
namespace {

template <class Items, class Name>
int find(const Items& items, const Name& is) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (is(items[i])) return static_cast<int>(i);
  return -1;
}

struct Scores {
  std::vector<double> a, b;  ///< by unit; NaN: not rated in both
  std::vector<char> asked;   ///< whether a unit has cases in both studies
};

/// Lowest score of some cases in a donning; NaN where none is rated.
double lowest(const SiteTable& site, const std::vector<int>& cases, int donning) {
  double least = kNotKnown;
  for (const int c : cases)
    if (const auto at = site.by_donning[c].find(donning); at != site.by_donning[c].end())
      least = std::isnan(least) ? at->second : std::min(least, at->second);
  return least;
}

std::set<int> donnings_of(const SiteTable& site, const std::vector<int>& cases) {
  std::set<int> donnings;
  for (const int c : cases)
    for (const auto& [donning, score] : site.by_donning[c]) donnings.insert(donning);
  return donnings;
}

Scores paired_scores(const SiteTable& a, const SiteTable& b, const CommonCases& common, int level) {
  const std::size_t n = common.units.size();
  Scores scores{std::vector<double>(n, kNotKnown), std::vector<double>(n, kNotKnown),
                std::vector<char>(n, 0)};
  for (const Counterparts& group : common.groups) {
    if (group.level != level) continue;
    scores.asked[group.unit] = 1;
    double &x = scores.a[group.unit], &y = scores.b[group.unit];
    for (const int donning : donnings_of(a, group.a)) {
      const double in_a = lowest(a, group.a, donning), in_b = lowest(b, group.b, donning);
      if (std::isnan(in_b)) continue;
      x = std::isnan(x) ? in_a : std::min(x, in_a);
      y = std::isnan(y) ? in_b : std::min(y, in_b);
    }
  }
  return scores;
}

PairedDifference difference(const Scores& scores, double pass, const BootstrapOptions& options) {
  PairedDifference result;
  std::vector<double> differences;
  for (std::size_t unit = 0; unit < scores.a.size(); ++unit) {
    const double x = scores.a[unit], y = scores.b[unit];
    if (std::isnan(x) || std::isnan(y)) {
      result.not_rated += scores.asked[unit];
      continue;
    }
    differences.push_back(std::clamp(y, 0.0, 1.0) - std::clamp(x, 0.0, 1.0));
    result.better += differences.back() > 0;
    result.passing_a += x >= pass;
    result.passing_b += y >= pass;
  }
  result.pairs = static_cast<int>(differences.size());
  if (differences.empty()) return result;
  const double n = result.pairs;
  result.better /= n;
  result.passing_a /= n;
  result.passing_b /= n;
  const auto mean = [&](const std::vector<int>& draw) {
    double sum = 0;
    for (const int i : draw) sum += differences[i];
    return sum / static_cast<double>(draw.size());
  };
  for (const double d : differences) result.mean += d / n;
  result.median = median(differences);
  result.interval = bootstrap(result.pairs, mean, options);
  return result;
}

/// Adds how loose both studies say that it may be at a site.
void add_limits(const StudyData& a, const SiteTable& in_a, const StudyData& b,
                const SiteTable& in_b, const std::string& modality, double pass,
                const BootstrapOptions& options, StudyComparison& comparison) {
  const std::vector<LooseLevel> of_a = loose_levels(a, in_a), of_b = loose_levels(b, in_b);
  if (of_a.empty() != of_b.empty())
    comparison.notes.push_back(modality + ", " + in_a.site + ": how loose it may be is told in " +
                               (of_a.empty() ? b : a).plan.name + " alone");
  if (of_a.empty() || of_b.empty()) return;
  LimitDifference one = people_axis(a.plan) < 0 || people_axis(b.plan) < 0
                            ? limit_difference_of_wearer(of_a, of_b, pass)
                            : limit_difference(of_a, of_b, pass, same_people(a, b), options);
  one.modality = modality;
  one.site = in_a.site;
  comparison.limits.push_back(std::move(one));
}

/// What has to be known of limits before they are compared.
void note_limits(const StudyData& a, const StudyData& b, StudyComparison& comparison) {
  if (comparison.limits.empty()) return;
  if (a.plan.looseness != b.plan.looseness)
    comparison.notes.push_back("limits are of " + a.plan.looseness + " in " + a.plan.name +
                               " and of " + b.plan.looseness + " in " + b.plan.name);
  if (comparison.paired_a < comparison.cases_a || comparison.paired_b < comparison.cases_b)
    comparison.notes.push_back(
        "limits are of all cases of each study, also of those without a counterpart: they may "
        "differ for that alone");
  const bool few = std::ranges::any_of(comparison.limits, [](const LimitDifference& one) {
    return one.drawn != PeopleDrawn::none && std::min(one.people_a, one.people_b) <= kWorstIsRobust;
  });
  if (few)
    comparison.notes.push_back(
        fmt::format("the limit of few people is that of the worst of them: with up to {} people "
                    "about one row in four would differ without any difference (half with 3), so "
                    "none is marked",
                    kWorstIsRobust));
}

/// What scores of both studies were made by, where it is not the same.
void note_origins(const StudyData& a, const StudyData& b, StudyComparison& comparison) {
  if (a.plan.version != b.plan.version)
    comparison.notes.push_back(a.plan.name + " is of Loosefit " + a.plan.version + ", " +
                               b.plan.name + " of " + b.plan.version +
                               ": differences may be those of the programs");
  if (a.plan.cards.empty() || b.plan.cards.empty()) return;  // plans of earlier programs
  for (std::size_t m = 0; m < a.modalities.size(); ++m) {
    const int other = find(b.modalities, [&](const auto& name) { return name == a.modalities[m]; });
    if (other >= 0 && a.plan.cards[m] != b.plan.cards[other])
      comparison.notes.push_back(a.modalities[m] +
                                 ": its scorecard is not the same in both studies, so scores "
                                 "differ for that alone; what passes is what that of A says");
  }
}

}  // namespace

StudyComparison compare_studies(const StudyData& a, const StudyData& b,
                                const BootstrapOptions& options) {
  BootstrapOptions by_chance = options;
  if (!varies_by_chance(a.plan) || !varies_by_chance(b.plan)) by_chance.resamples = 0;
  StudyComparison comparison;
  comparison.name_a = a.plan.name;
  comparison.name_b = b.plan.name;
  const CommonCases common = common_cases(a, b);
  comparison.cases_a = static_cast<int>(a.plan.cases.size());
  comparison.cases_b = static_cast<int>(b.plan.cases.size());
  comparison.paired_a = common.paired_a;
  comparison.paired_b = common.paired_b;
  comparison.notes = common.notes;
  comparison.of_people = people_axis(a.plan) >= 0;
  const auto in_one_alone = [&](const std::string& what, const StudyData& data) {
    comparison.notes.push_back(what + ": in " + data.plan.name + " alone");
  };
  for (const std::string& modality : b.modalities)
    if (std::count(a.modalities.begin(), a.modalities.end(), modality) == 0)
      in_one_alone(modality, b);
  for (std::size_t m = 0; m < a.modalities.size(); ++m) {
    const std::string& modality = a.modalities[m];
    if (std::count(b.modalities.begin(), b.modalities.end(), modality) == 0) {
      in_one_alone(modality, a);
      continue;
    }
    const auto in_a = a.sites.find(modality), in_b = b.sites.find(modality);
    if (in_a == a.sites.end() || in_b == b.sites.end()) {
      const bool neither = in_a == a.sites.end() && in_b == b.sites.end();
      comparison.notes.push_back(modality + (neither ? " has results in neither study"
                                                     : " has results in one study alone"));
      continue;
    }
    const auto same_site = [](const SiteTable& site) {
      return [&](const SiteTable& s) { return s.site == site.site; };
    };
    for (const SiteTable& site : in_b->second)
      if (find(in_a->second, same_site(site)) < 0) in_one_alone(modality + ", " + site.site, b);
    const double pass = scorecard(a.plan, m).pass;
    for (const SiteTable& site : in_a->second) {
      const int other = find(in_b->second, same_site(site));
      if (other < 0) {
        in_one_alone(modality + ", " + site.site, a);
        continue;
      }
      for (std::size_t k = 0; k < a.level_labels.size(); ++k) {
        PairedDifference one = difference(
            paired_scores(site, in_b->second[other], common, static_cast<int>(k)), pass, by_chance);
        one.modality = modality;
        one.site = site.site;
        one.level = a.level_labels[k];
        if (one.pairs > 0) comparison.differences.push_back(std::move(one));
      }
      add_limits(a, site, b, in_b->second[other], modality, pass, options, comparison);
    }
  }
  if (comparison.differences.empty())
    throw InvalidInput("the studies " + printable(a.plan.name) + " and " + printable(b.plan.name) +
                           " have no site and fit in common where both are rated",
                       join(comparison.notes, "; "));
  note_limits(a, b, comparison);
  note_origins(a, b, comparison);
  return comparison;
}

namespace {

/// One person alone has no interval.
std::string interval_text(const Bounds& interval) {
  if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) return "-";
  return fmt::format("{:>+8.3f} to {:>+6.3f}", interval.low, interval.high);
}

std::string limits_text(const std::vector<LimitDifference>& limits, bool of_people) {
  if (limits.empty()) return "";
  std::string text = fmt::format(
      "how loose may it be? Greatest BGM at which {} pass, as each study says, B - A\n"
      "{:<20} {:<18} {:>14} {:>14} {:>16}  {:<16} {:>11}  {}\n",
      of_people ? "95 % of people" : "the cases", "modality", "site", "A", "B", "B - A",
      "90 % interval", "people A, B", "draws");
  for (const LimitDifference& one : limits)
    text += fmt::format(
        "{:<20} {:<18} {:>14} {:>14} {:>16}  {:<16} {:>11}  {}{}\n", one.modality, one.site,
        limit_text(one.limit_a, one.tried_a), limit_text(one.limit_b, one.tried_b),
        difference_text(one), limit_interval_text(one.interval),
        fmt::format("{}, {}", one.people_a, one.people_b),
        one.drawn == PeopleDrawn::none ? "none"
        : one.open_draws > 0 ? fmt::format("{:.1f} % without a number", 100 * one.open_draws)
                             : "all with a number",
        one.differs() ? " *" : "");
  const auto are_drawn = [&](PeopleDrawn drawn) {
    return std::ranges::any_of(limits,
                               [&](const LimitDifference& one) { return one.drawn == drawn; });
  };
  if (are_drawn(PeopleDrawn::jointly))
    text += "intervals of limits: people are drawn jointly, the same ones in A and B\n";
  if (are_drawn(PeopleDrawn::independently))
    text +=
        "intervals of limits: people are drawn independently in A and B: they are not the same\n";
  if (are_drawn(PeopleDrawn::none))
    text += "limits without draws have no interval: they are of one person, or not of people\n";
  if (std::ranges::any_of(limits, &LimitDifference::differs))
    text += "* zero is not within the interval\n";
  return text;
}

/// The words of study-report.json; nothing for a limit that is a number.
std::string limit_words(const Bounds& limit, const Bounds& tried) {
  if (std::isfinite(limit.low) && limit.low == limit.high) return "";
  return std::isfinite(limit.low) || limit.low < 0 ? limit_text(limit, tried)
                                                   : "beyond the loosest";
}

std::string limit_field(const Bounds& limit, const Bounds& tried) {
  const std::string words = limit_words(limit, tried);
  return words.empty() ? io::csv_field(limit.low) : io::csv_field(words);
}

/// An end that is open is infinite, one that is not known empty.
std::string end_field(double end) {
  if (std::isinf(end)) return end > 0 ? "inf" : "-inf";
  return io::csv_field(end);
}

}  // namespace

std::string comparison_text(const StudyComparison& comparison) {
  std::string text =
      fmt::format("{} (B) against {} (A), scores of the same {}, B - A\n", comparison.name_b,
                  comparison.name_a, comparison.of_people ? "people" : "cases");
  text += fmt::format("paired: {} of {} cases of A with {} of {} of B\n", comparison.paired_a,
                      comparison.cases_a, comparison.paired_b, comparison.cases_b);
  text += fmt::format("{:<20} {:<18} {:<12} {:>8} {:>8} {:>18} {:>7} {:>13}\n", "modality", "site",
                      "fit", comparison.of_people ? "people" : "cases", "mean", "90 % interval",
                      "better", "passing A, B");
  for (const PairedDifference& d : comparison.differences)
    text += fmt::format(
        "{:<20} {:<18} {:<12} {:>8} {:>+8.3f} {:>18} {:>5.0f} % "
        "{:>5.0f}, {:.0f} %{}\n",
        d.modality, d.site, d.level,
        d.not_rated > 0 ? fmt::format("{} of {}", d.pairs, d.pairs + d.not_rated)
                        : std::to_string(d.pairs),
        d.mean, interval_text(d.interval), 100 * d.better, 100 * d.passing_a, 100 * d.passing_b,
        d.differs() ? " *" : "");
  const auto has_interval = [](const PairedDifference& d) {
    return std::isfinite(d.interval.low) && std::isfinite(d.interval.high);
  };
  text +=
      std::ranges::any_of(comparison.differences, has_interval)
          ? fmt::format(
                "* zero is not within the interval; of 20 such rows without any difference "
                "2 would be so; rows of fewer than {} are not marked\n",
                kFewestForInterval)
          : "without intervals: one person or case alone, or values that were chosen, which are no "
            "sample\n";
  text += limits_text(comparison.limits, comparison.of_people);
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text;
}

std::string comparison_csv(const StudyComparison& comparison) {
  std::string text = io::csv_line({"modality", "site", "level", "people", "mean_difference",
                                   "median_difference", "interval_low", "interval_high",
                                   "share_better", "passing_a", "passing_b", "people_not_rated"});
  for (const PairedDifference& d : comparison.differences)
    text += io::csv_line({io::csv_field(d.modality), io::csv_field(d.site), io::csv_field(d.level),
                          std::to_string(d.pairs), io::csv_field(d.mean), io::csv_field(d.median),
                          io::csv_field(d.interval.low), io::csv_field(d.interval.high),
                          io::csv_field(d.better), io::csv_field(d.passing_a),
                          io::csv_field(d.passing_b), std::to_string(d.not_rated)});
  return text;
}

std::string limits_csv(const StudyComparison& comparison) {
  std::string text = io::csv_line({"modality", "site", "limit_a_bgm", "limit_b_bgm",
                                   "difference_bgm", "interval_low", "interval_high", "differs",
                                   "people_a", "people_b", "people_drawn", "open_draws", "words"});
  for (const LimitDifference& one : comparison.limits)
    text +=
        io::csv_line({io::csv_field(one.modality), io::csv_field(one.site),
                      limit_field(one.limit_a, one.tried_a), limit_field(one.limit_b, one.tried_b),
                      io::csv_field(one.difference), end_field(one.interval.low),
                      end_field(one.interval.high), one.differs() ? "true" : "false",
                      std::to_string(one.people_a), std::to_string(one.people_b), name(one.drawn),
                      io::csv_field(one.open_draws), io::csv_field(in_words(one))});
  return text;
}

std::string comparison_json(const StudyComparison& comparison) {
  using Json = nlohmann::json;
  // JSON has neither NaN, the bounds of one pair, nor infinity, an interval that is open.
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json rows = Json::array();
  for (const PairedDifference& d : comparison.differences)
    rows.push_back({{"modality", d.modality},
                    {"site", d.site},
                    {"level", d.level},
                    {"people", d.pairs},
                    {"people_not_rated", d.not_rated},
                    {"mean_difference", number(d.mean)},
                    {"median_difference", number(d.median)},
                    {"interval", {number(d.interval.low), number(d.interval.high)}},
                    {"differs", d.differs()},
                    {"share_better", d.better},
                    {"passing_a", d.passing_a},
                    {"passing_b", d.passing_b}});
  const auto limit = [](const Bounds& value, const Bounds& tried) {
    const std::string words = limit_words(value, tried);
    return words.empty() ? Json(value.low) : Json(words);
  };
  Json limits = Json::array();
  for (const LimitDifference& one : comparison.limits)
    limits.push_back({{"modality", one.modality},
                      {"site", one.site},
                      {"limit_a_bgm", limit(one.limit_a, one.tried_a)},
                      {"limit_b_bgm", limit(one.limit_b, one.tried_b)},
                      {"difference_bgm", number(one.difference)},
                      {"interval", {number(one.interval.low), number(one.interval.high)}},
                      {"differs", one.differs()},
                      {"people_a", one.people_a},
                      {"people_b", one.people_b},
                      {"people_drawn", name(one.drawn)},
                      {"open_draws", number(one.open_draws)},
                      {"words", in_words(one)}});
  return Json({{"a", comparison.name_a},
               {"b", comparison.name_b},
               {"cases_a", comparison.cases_a},
               {"cases_b", comparison.cases_b},
               {"paired_a", comparison.paired_a},
               {"paired_b", comparison.paired_b},
               {"differences", rows},
               {"limits", limits},
               {"notes", comparison.notes}})
      .dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace loosefit::study
