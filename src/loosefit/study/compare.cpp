#include "loosefit/study/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/scorecard_file.h"

namespace loosefit::study {
namespace {

template <class Items, class Name>
int find(const Items& items, const Name& is) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (is(items[i])) return static_cast<int>(i);
  return -1;
}

/// What is known of a person: the inputs of the axis of people.
std::map<std::string, double> measures_of(const StudyData& data, int unit) {
  const int axis = people_axis(data.plan);
  std::map<std::string, double> measures;
  if (axis < 0) return measures;
  const std::string prefix = data.plan.axes[axis].name + ".";
  for (const auto& [name, value] : data.plan.axes[axis].levels[unit].inputs)
    measures[name.substr(std::min(name.size(), prefix.size()))] = value;
  return measures;
}

struct Pairs {
  std::vector<int> a, b;  ///< units
};

Pairs paired_units(const StudyData& a, const StudyData& b) {
  Pairs pairs;
  for (std::size_t i = 0; i < a.units.size(); ++i) {
    const int j = find(b.units, [&](const std::string& name) { return name == a.units[i]; });
    if (j < 0) continue;
    if (measures_of(a, static_cast<int>(i)) != measures_of(b, j))
      throw InvalidInput("\"" + printable(a.units[i]) + "\" of " + printable(a.plan.name) +
                             " measures otherwise in " + printable(b.plan.name),
                         "draw the people of both studies from the same statistics with the same "
                         "seed and axis name, or give both the same CSV file");
    pairs.a.push_back(static_cast<int>(i));
    pairs.b.push_back(j);
  }
  if (pairs.a.empty())
    throw InvalidInput("the studies " + printable(a.plan.name) + " and " + printable(b.plan.name) +
                       " have nobody in common");
  return pairs;
}

PairedDifference difference(const std::vector<double>& a, const std::vector<double>& b,
                            const Pairs& pairs, double pass, const BootstrapOptions& options) {
  PairedDifference result;
  std::vector<double> differences;
  for (std::size_t p = 0; p < pairs.a.size(); ++p) {
    const double x = a[pairs.a[p]], y = b[pairs.b[p]];
    if (std::isnan(x) || std::isnan(y)) continue;
    differences.push_back(std::clamp(y, 0.0, 1.0) - std::clamp(x, 0.0, 1.0));
    result.better += y > x;
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

}  // namespace

StudyComparison compare_studies(const StudyData& a, const StudyData& b,
                                const BootstrapOptions& options) {
  StudyComparison comparison;
  comparison.name_a = a.plan.name;
  comparison.name_b = b.plan.name;
  const Pairs pairs = paired_units(a, b);
  const std::size_t alone = a.units.size() + b.units.size() - 2 * pairs.a.size();
  if (alone > 0) comparison.notes.push_back(fmt::format("{} people are in one study alone", alone));
  for (std::size_t m = 0; m < a.modalities.size(); ++m) {
    const std::string& modality = a.modalities[m];
    const auto in_a = a.sites.find(modality), in_b = b.sites.find(modality);
    if (in_a == a.sites.end() || in_b == b.sites.end()) {
      const bool neither = in_a == a.sites.end() && in_b == b.sites.end();
      comparison.notes.push_back(modality + (neither ? " has results in neither study"
                                                     : " has results in one study alone"));
      continue;
    }
    const double pass = io::load_scorecard(a.plan.modalities[m]).pass;
    for (const SiteTable& site : in_a->second) {
      const int other = find(in_b->second, [&](const SiteTable& s) { return s.site == site.site; });
      if (other < 0) {
        comparison.notes.push_back(modality + ", " + site.site + ": in " + a.plan.name + " alone");
        continue;
      }
      for (std::size_t k = 0; k < a.level_labels.size(); ++k) {
        const int level =
            find(b.level_labels, [&](const std::string& l) { return l == a.level_labels[k]; });
        if (level < 0) continue;
        PairedDifference one =
            difference(unit_scores(a, site, static_cast<int>(k)),
                       unit_scores(b, in_b->second[other], level), pairs, pass, options);
        one.modality = modality;
        one.site = site.site;
        one.level = a.level_labels[k];
        if (one.pairs > 0) comparison.differences.push_back(std::move(one));
      }
    }
  }
  if (comparison.differences.empty())
    throw InvalidInput("the studies " + printable(a.plan.name) + " and " + printable(b.plan.name) +
                           " have no site and fit in common where both are rated",
                       join(comparison.notes, "; "));
  return comparison;
}

std::string comparison_text(const StudyComparison& comparison) {
  std::string text = fmt::format("{} (B) against {} (A), scores of the same people, B - A\n",
                                 comparison.name_b, comparison.name_a);
  text += fmt::format("{:<20} {:<18} {:<12} {:>6} {:>8} {:>18} {:>7} {:>13}\n", "modality", "site",
                      "fit", "people", "mean", "90 % interval", "better", "passing A, B");
  for (const PairedDifference& d : comparison.differences)
    text += fmt::format(
        "{:<20} {:<18} {:<12} {:>6} {:>+8.3f} {:>+8.3f} to {:>+6.3f} {:>5.0f} % "
        "{:>5.0f}, {:.0f} %{}\n",
        d.modality, d.site, d.level, d.pairs, d.mean, d.interval.low, d.interval.high,
        100 * d.better, 100 * d.passing_a, 100 * d.passing_b, d.differs() ? " *" : "");
  text +=
      "* zero is not within the interval; of 20 such rows without any difference 2 would be so\n";
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text;
}

std::string comparison_csv(const StudyComparison& comparison) {
  std::string text =
      io::csv_line({"modality", "site", "level", "people", "mean_difference", "median_difference",
                    "interval_low", "interval_high", "share_better", "passing_a", "passing_b"});
  for (const PairedDifference& d : comparison.differences)
    text += io::csv_line({io::csv_field(d.modality), io::csv_field(d.site), io::csv_field(d.level),
                          std::to_string(d.pairs), io::csv_field(d.mean), io::csv_field(d.median),
                          io::csv_field(d.interval.low), io::csv_field(d.interval.high),
                          io::csv_field(d.better), io::csv_field(d.passing_a),
                          io::csv_field(d.passing_b)});
  return text;
}

std::string comparison_json(const StudyComparison& comparison) {
  using Json = nlohmann::json;
  // JSON has no NaN: the bounds of one pair.
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json rows = Json::array();
  for (const PairedDifference& d : comparison.differences)
    rows.push_back({{"modality", d.modality},
                    {"site", d.site},
                    {"level", d.level},
                    {"people", d.pairs},
                    {"mean_difference", number(d.mean)},
                    {"median_difference", number(d.median)},
                    {"interval", {number(d.interval.low), number(d.interval.high)}},
                    {"differs", d.differs()},
                    {"share_better", d.better},
                    {"passing_a", d.passing_a},
                    {"passing_b", d.passing_b}});
  return Json({{"a", comparison.name_a},
               {"b", comparison.name_b},
               {"differences", rows},
               {"notes", comparison.notes}})
      .dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace loosefit::study
