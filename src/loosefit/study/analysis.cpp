#include "loosefit/study/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/placement/metric_names.h"
#include "loosefit/study/cautions.h"
#include "loosefit/study/unit_words.h"

namespace loosefit::study {
namespace {

/// Fewer draws than for scores: there are many correlations.
constexpr int kCorrelationDraws = 400;

std::vector<SiteScores> scores_at(const StudyData& data, const std::vector<SiteTable>& tables,
                                  int level) {
  std::vector<SiteScores> sites;
  for (const SiteTable& table : tables)
    sites.push_back({table.site, unit_scores(data, table, level)});
  return sites;
}

SensorConstraints constraints_of(const StudyData& data, const std::vector<SiteTable>& tables) {
  SensorConstraints constraints;
  const std::size_t n = tables.size();
  constraints.apart.assign(n, std::vector<char>(n, 0));
  constraints.excluded.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    constraints.excluded[i] =
        std::count(data.plan.not_at.begin(), data.plan.not_at.end(), tables[i].site) > 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double d = std::hypot(tables[i].x - tables[j].x, tables[i].y - tables[j].y,
                                  tables[i].z - tables[j].z);
      constraints.apart[i][j] = i != j && d < data.plan.spacing;
    }
  }
  return constraints;
}

/// Cases of each unit, for a bootstrap over units.
std::vector<std::vector<int>> cases_of_units(const StudyData& data) {
  std::vector<std::vector<int>> cases(data.units.size());
  for (std::size_t c = 0; c < data.unit_of_case.size(); ++c)
    cases[data.unit_of_case[c]].push_back(static_cast<int>(c));
  return cases;
}

Bounds correlation_interval(const std::vector<std::vector<int>>& cases,
                            const std::vector<double>& x, const std::vector<double>& y,
                            BootstrapOptions options) {
  options.resamples = std::min(options.resamples, kCorrelationDraws);
  return bootstrap(
      static_cast<int>(cases.size()),
      [&](const std::vector<int>& draw) {
        std::vector<double> a, b;
        for (const int unit : draw)
          for (const int c : cases[unit]) {
            a.push_back(x[c]);
            b.push_back(y[c]);
          }
        return rank_correlation(a, b);
      },
      options);
}

void add_sensitivity(const StudyData& data, const SiteTable& table, const std::string& quantity,
                     const std::vector<double>& y, const BootstrapOptions& options,
                     const std::vector<std::vector<int>>& units, std::vector<Sensitivity>& all) {
  const std::size_t cases = data.plan.cases.size();
  const auto count_units = [&](const auto& is_known) {
    return static_cast<int>(std::ranges::count_if(
        units, [&](const auto& of_unit) { return std::ranges::any_of(of_unit, is_known); }));
  };
  const int known = count_units([&](int c) { return !std::isnan(y[c]); });
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t c = 0; c < cases; ++c)
    for (const auto& [input, value] : data.inputs[c]) {
      std::vector<double>& column = columns[input];
      if (column.empty()) column.assign(cases, kNotKnown);
      column[c] = value;
    }
  for (const auto& [input, x] : columns) {
    const double value = rank_correlation(x, y);
    if (std::isnan(value)) continue;
    const int units_of_both =
        count_units([&](int c) { return !std::isnan(x[c]) && !std::isnan(y[c]); });
    Sensitivity row{table.site,   quantity, input, false, value, {kNotKnown, kNotKnown},
                    units_of_both};
    if (quantity == "score") row.interval = correlation_interval(units, x, y, options);
    all.push_back(row);
  }
  if (data.plan.design != "crossed") return;
  for (std::size_t k = 0; k < data.plan.axes.size(); ++k) {
    if (data.plan.axes[k].each_case || data.plan.axes[k].levels.size() < 2) continue;
    std::vector<int> group;
    for (const FolderCase& one : data.plan.cases) group.push_back(one.levels[k]);
    const double share = main_effect(group, y);
    if (!std::isnan(share))
      all.push_back({table.site,
                     quantity,
                     data.plan.axes[k].name,
                     true,
                     share,
                     {kNotKnown, kNotKnown},
                     known});
  }
}

ModalityAnalysis analyse_modality(const StudyData& data, const std::string& name,
                                  const placement::Scorecard& card,
                                  const BootstrapOptions& options) {
  ModalityAnalysis result;
  result.name = name;
  result.title = card.title;
  result.pass = card.pass;
  if (const auto untold = data.untold.find(name); untold != data.untold.end())
    for (const auto& [metric, cases] : untold->second)
      (cases == data.done ? result.untold : result.untold_in_part).push_back(metric);
  result.tellable = std::ranges::any_of(card.criteria, [&](const placement::Criterion& c) {
    return std::ranges::count(result.untold, c.metric) == 0;
  });
  result.rated = rated_units(data, name);
  const auto found = data.sites.find(name);
  if (found == data.sites.end()) return result;
  const std::vector<SiteTable>& tables = found->second;
  const int levels = static_cast<int>(data.level_bgm.size());
  BootstrapOptions by_chance = options, of_people = options;
  if (!varies_by_chance(data.plan)) by_chance.resamples = 0;
  // Without people units are cases, each at one fit: to draw them is to draw which fits there are.
  if (people_axis(data.plan) < 0) of_people.resamples = 0;
  for (int level = 0; level < levels; ++level) {
    result.rankings.push_back(
        rank_population(scores_at(data, tables, level), card.pass, by_chance));
    for (SitePopulation& site : result.rankings.back()) site.people = asked_units(data, level);
  }
  const std::vector<SiteScores> over_all = scores_at(data, tables, -1);
  if (levels > 1) result.rankings.push_back(rank_population(over_all, card.pass, of_people));
  result.sensors = choose_sensors(over_all, data.plan.sensors, constraints_of(data, tables));
  const std::vector<std::vector<int>> units = cases_of_units(data);
  result.metrics = metric_percentiles(data, tables, card, of_people);
  for (const SiteTable& table : tables) {
    if (const std::vector<LooseLevel> by_level = loose_levels(data, table); !by_level.empty())
      result.how_loose[table.site] = how_loose(by_level, card.pass, of_people);
    add_sensitivity(data, table, "score", table.by_case, by_chance, units, result.sensitivity);
    for (const placement::Criterion& criterion : card.criteria)
      if (const auto metric = table.metrics.find(criterion.metric); metric != table.metrics.end())
        add_sensitivity(data, table, criterion.metric, metric->second, by_chance, units,
                        result.sensitivity);
    int most = 0;
    for (const auto& [metric, count] : table.limiting)
      if (count > most) {
        most = count;
        result.limiting[table.site] = metric;
      }
  }
  return result;
}

ComfortLimit comfort_of(const StudyData& data) {
  ComfortLimit comfort;
  for (const double share : greatest_by_unit(data, data.uncomfortable_share, -1))
    comfort.units += !std::isnan(share);
  std::vector<double> known, worst;
  for (std::size_t level = 0; level < data.level_bgm.size(); ++level) {
    std::vector<double> shares =
        greatest_by_unit(data, data.uncomfortable_share, static_cast<int>(level));
    std::erase_if(shares, [](double s) { return std::isnan(s); });
    if (shares.empty()) {
      comfort.worst_share.push_back(kNotKnown);
      comfort.unknown.push_back(data.level_bgm[level]);
      continue;
    }
    known.push_back(data.level_bgm[level]);
    worst.push_back(robust_from_above(std::move(shares)));
    comfort.worst_share.push_back(worst.back());
  }
  comfort.limit = known.empty() ? kNotKnown : least_within(known, worst, kUncomfortableArea);
  return comfort;
}

/// Where and how loose most units pass, of those alike the better robust score; none where nobody
/// is rated.
struct Nearest {
  std::string site;
  const LoosePoint* point = nullptr;
};

Nearest nearest_of(const ModalityAnalysis& modality) {
  Nearest best;
  for (const auto& [name, answer] : modality.how_loose)
    if (const LoosePoint* point = most_passing(answer);
        point && (!best.point || std::pair(point->passing, point->robust) >
                                     std::pair(best.point->passing, best.point->robust)))
      best = {name, point};
  return best;
}

/// "nobody of the 1 rated of 3 passes anywhere". `cases_pass`: some case of theirs does.
std::string nobody_passes(const StudyData& data, int rated, bool cases_pass) {
  const UnitKind kind = unit_kind(data);
  const int all = static_cast<int>(data.units.size());
  const bool people = people_axis(data.plan) >= 0;
  const std::string units = people ? std::to_string(all) : counted(all, kind);
  return fmt::format("no site works: {} of the {} passes anywhere{}", people ? "nobody" : "none",
                     rated < all ? fmt::format("{} rated of {}", rated, units) : units,
                     cases_pass ? " in all that they went through" : "");
}

bool any_case_passes(const StudyData& data, const ModalityAnalysis& modality) {
  const auto found = data.sites.find(modality.name);
  return found != data.sites.end() &&
         std::ranges::any_of(found->second, [&](const SiteTable& table) {
           return std::ranges::any_of(table.by_case,
                                      [&](double score) { return score >= modality.pass; });
         });
}

/// "95 % score 0.61 or more", "the lowest score is 0.42"; of a robust score below 0, that it is cut
/// off.
std::string robust_in_words(const SitePopulation& site, UnitKind kind) {
  const double shown = std::clamp(site.p5, 0.0, 1.0);
  if (site.rated <= kWorstIsRobust)
    return site.p5 < 0 ? fmt::format("the lowest score is 0 ({:.2f} before it is cut off)", site.p5)
                       : fmt::format("the lowest score is {:.2f}", shown);
  const std::string share =
      kind == UnitKind::people ? "5 % or more" : "5 % or more of the " + column_name(kind);
  if (site.p5 < 0) return share + fmt::format(" score 0 ({:.2f} before it is cut off)", site.p5);
  if (kind == UnitKind::people) return fmt::format("95 % score {:.2f} or more", shown);
  return fmt::format("the 5th percentile of their scores is {:.2f}", shown);
}

std::string of_ranking(const StudyData& data, const ModalityAnalysis& modality) {
  const UnitKind kind = unit_kind(data);
  const std::vector<SitePopulation>& ranking = modality.rankings.back();
  if (std::ranges::none_of(ranking, [](const SitePopulation& s) { return s.passing > 0; }))
    return nobody_passes(data, modality.rated, any_case_passes(data, modality));
  const SitePopulation& first = ranking.front();
  std::string text =
      fmt::format("{} ranks first; {:.0f} % of {} {} there, {}", first.site, 100 * first.passing,
                  rated_of_all(first.rated, first.people, kind),
                  first.rated == 1 ? "passes" : "pass", robust_in_words(first, kind));
  if (first.passing > 0) return text;
  const auto most = std::ranges::max_element(ranking, {}, [](const SitePopulation& s) {
    return s.rated > 0 ? s.passing : -1;  // NaN where nobody is rated
  });
  return text + fmt::format("; most pass at {}: {:.0f} % of {}", most->site, 100 * most->passing,
                            rated_of_all(most->rated, most->people, kind));
}

/// " (rated there: 3 of 12)": at the fit that sets the limit, or of the two between which it lies
/// at that with fewer. Empty where all are.
std::string rated_at_limit(const StudyData& data, const HowLoose& answer) {
  const auto looser =
      std::ranges::find_if(answer.curve, [&](const LoosePoint& p) { return p.bgm > answer.limit; });
  if (looser == answer.curve.begin()) return "";
  auto sets = std::prev(looser);
  if (looser != answer.curve.end() && sets->bgm < answer.limit && looser->rated < sets->rated)
    sets = looser;
  const int asked = asked_units(data, static_cast<int>(sets - answer.curve.begin()));
  return sets->rated < asked ? fmt::format(" (rated there: {} of {})", sets->rated, asked) : "";
}

std::string of_looseness(const StudyAnalysis& analysis, const ModalityAnalysis& modality) {
  const StudyData& data = analysis.data;
  const UnitKind kind = unit_kind(data);
  const int all = static_cast<int>(data.units.size());
  const auto& [site, answer] = *std::max_element(
      modality.how_loose.begin(), modality.how_loose.end(), [](const auto& a, const auto& b) {
        return a.second.limit != b.second.limit ? a.second.limit < b.second.limit
                                                : a.second.interval.low < b.second.interval.low;
      });
  if (answer.limit > -std::numeric_limits<double>::infinity())
    return "loosest at " + site + ", " + in_words(answer, analysis.options) +
           rated_at_limit(data, answer) +
           (answer.people < all ? "; said of " + rated_of_all(answer.people, all, kind) : "");
  const Nearest nearest = nearest_of(modality);
  if (!nearest.point || nearest.point->passing == 0)
    return nobody_passes(data, modality.rated, any_case_passes(data, modality));
  const std::size_t level =
      static_cast<std::size_t>(nearest.point - modality.how_loose.at(nearest.site).curve.data());
  const int asked = asked_units(data, static_cast<int>(level));
  return fmt::format(
      "no site works {}; nearest is {}: {:.0f} % of {} {} at a BGM of {:.2f}",
      people_axis(data.plan) >= 0 ? for_most(modality.rated, kind) + " at any fit tried"
                                  : "in all cases of any fit tried",
      nearest.site, 100 * nearest.point->passing, rated_of_all(nearest.point->rated, asked, kind),
      nearest.point->rated == 1 ? "passes" : "pass", nearest.point->bgm);
}

}  // namespace

std::vector<LooseLevel> loose_levels(const StudyData& data, const SiteTable& site) {
  std::vector<LooseLevel> levels;
  if (looseness_axis(data.plan) < 0) return levels;
  bool rated = false;
  for (std::size_t level = 0; level < data.level_bgm.size(); ++level) {
    levels.push_back({data.level_bgm[level], unit_scores(data, site, static_cast<int>(level))});
    for (const double score : levels.back().scores) rated |= !std::isnan(score);
  }
  if (!rated) levels.clear();
  return levels;
}

StudyAnalysis analyse(StudyData data) {
  StudyAnalysis analysis;
  analysis.data = std::move(data);
  const StudyData& read = analysis.data;
  for (std::size_t m = 0; m < read.modalities.size(); ++m)
    analysis.modalities.push_back(
        analyse_modality(read, read.modalities[m], scorecard(read.plan, m), analysis.options));
  if (looseness_axis(read.plan) >= 0) analysis.comfort = comfort_of(read);
  return analysis;
}

std::string in_words(const ComfortLimit& comfort) {
  if (std::isnan(comfort.limit)) return "not known";
  std::string text = fmt::format("comfortable from a BGM of {:.2f} on", comfort.limit);
  if (comfort.limit == -kInfinity) text = "comfortable at all fits tried";
  if (comfort.limit == kInfinity) text = "not comfortable at any fit tried";
  std::vector<std::string> unknown;
  for (const double bgm : comfort.unknown) unknown.push_back(fmt::format("{:.2f}", bgm));
  return unknown.empty() ? text : text + "; not known at " + join(unknown);
}

std::string nothing_rated(const ModalityAnalysis& modality) {
  std::vector<std::string> needs;
  for (const std::string& metric : modality.untold)
    if (const placement::MetricName* name = placement::find_metric(metric);
        name && !name->needs.empty() && std::ranges::count(needs, name->needs) == 0)
      needs.push_back(name->needs);
  if (modality.tellable || needs.empty()) return "no site could be rated";
  return "needs " + join(needs, " and ") + ": nothing is rated";
}

std::vector<std::string> headlines(const StudyAnalysis& analysis) {
  const StudyData& data = analysis.data;
  std::vector<std::string> sentences;
  for (const ModalityAnalysis& modality : analysis.modalities)
    sentences.push_back(modality.name + ": " +
                        (modality.rated == 0          ? nothing_rated(modality)
                         : modality.how_loose.empty() ? of_ranking(data, modality)
                                                      : of_looseness(analysis, modality)));
  if (analysis.comfort && data.done > 0)
    sentences.push_back("comfort: " + for_most(analysis.comfort->units, unit_kind(data)) + " " +
                        in_words(*analysis.comfort));
  if (const std::string cautions = cautions_in_words(data); !cautions.empty())
    sentences.push_back(cautions);
  return sentences;
}

}  // namespace loosefit::study
