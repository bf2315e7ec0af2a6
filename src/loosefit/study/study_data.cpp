#include "loosefit/study/study_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/placement/metric_names.h"

namespace loosefit::study {
namespace {

/// Of a sampled looseness axis: enough for a curve, each with a fifth of the cases; of fewer values
/// each is one.
constexpr int kBins = 5;

/// Why a case that is done has no score.
std::string why_unscored(const CaseRecord& record) {
  for (const SampleRecord& sample : record.samples)
    if (!sample.reason.empty()) return sample.reason;
  if (record.drapes_counted == 0 && !record.left_out.empty()) return "no drape counts";
  if (record.sites.empty()) return "no site was found";
  if (std::ranges::none_of(record.sites, &std::string::empty, &SiteRecord::not_covered))
    return record.sites.front().site + ": " + record.sites.front().not_covered;
  for (const auto& [modality, metrics] : record.untold)
    if (!metrics.empty())
      return modality + " lacks " + placement::metric_with_need(metrics.front());
  return "no sample has a score";
}

/// Whether units of any table are rated.
void mark_rated(const StudyData& data, const std::vector<SiteTable>& tables,
                std::vector<char>& rated) {
  for (const SiteTable& table : tables)
    for (std::size_t c = 0; c < table.by_case.size(); ++c)
      if (!std::isnan(table.by_case[c])) rated[data.unit_of_case[c]] = 1;
}

/// Collects cases one by one.
class Collector {
 public:
  explicit Collector(const StudyFolder& folder) : folder_(folder) {
    data_.plan = folder.read_plan();
    data_.modalities = scorecard_names(data_.plan);
    const std::size_t cases = data_.plan.cases.size();
    data_.uncomfortable_share.assign(cases, kNotKnown);
    data_.inputs.resize(cases);
    data_.warnings.resize(cases);
  }

  StudyData all() {
    set_units();
    set_levels();
    for (std::size_t c = 0; c < data_.plan.cases.size(); ++c) add(c);
    return std::move(data_);
  }

 private:
  void set_units() {
    const int people = people_axis(data_.plan);
    if (people >= 0)
      for (const AxisLevel& level : data_.plan.axes[people].levels)
        data_.units.push_back(level.label);
    for (const FolderCase& one : data_.plan.cases) {
      data_.unit_of_case.push_back(people >= 0 ? one.levels[people] : one.number - 1);
      if (people < 0) data_.units.push_back("case " + std::to_string(one.number));
    }
  }

  void set_levels() {
    const int loose = looseness_axis(data_.plan);
    const std::size_t cases = data_.plan.cases.size();
    if (loose < 0) {
      data_.level_of_case.assign(cases, 0);
      data_.level_bgm = {kNotKnown};
      data_.level_labels = {""};
      return;
    }
    const Axis& axis = data_.plan.axes[loose];
    // Metres of ease are no BGM, and plans of earlier programs know nothing else.
    if (axis.kind == "ease")
      for (const FolderCase& one : data_.plan.cases)
        if (!one.looseness)
          throw InvalidInput(
              {(folder_.path() / "plan.json").string(), 0, "cases.looseness"},
              "nothing for case " + std::to_string(one.number), "a body-garment mobility",
              "loosefit study plan STUDY.toml -o " + folder_.path().string() + " writes it");
    if (axis.sampled) return set_bins(axis, loose);
    std::vector<int> order(axis.levels.size()), place(axis.levels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return *axis.levels[a].value < *axis.levels[b].value; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = static_cast<int>(i);
      data_.level_bgm.push_back(*axis.levels[order[i]].value);
      data_.level_labels.push_back(axis.levels[order[i]].label);
    }
    for (const FolderCase& one : data_.plan.cases)
      data_.level_of_case.push_back(place[one.levels[loose]]);
  }

  void set_bins(const Axis& axis, int loose) {
    const int cases = static_cast<int>(data_.plan.cases.size());
    // What every wearer has of the axis may be another BGM for each: ease in metres is.
    const auto value = [&](int c) {
      const FolderCase& one = data_.plan.cases[c];
      return one.looseness.value_or(*axis.levels[one.levels[loose]].value);
    };
    std::vector<int> order(cases);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return value(a) < value(b); });
    // Cases of one value stay together: in a crossed design they are of different people, and a bin
    // with some of them would be one of other people than the next.
    int distinct = 0;
    for (int i = 0; i < cases; ++i) distinct += i == 0 || value(order[i]) != value(order[i - 1]);
    data_.level_of_case.assign(cases, 0);
    std::vector<double> sums;
    std::vector<int> counts;
    int first = 0, last_share = -1;
    for (int i = 0; i < cases; ++i) {
      if (i > 0 && value(order[i]) != value(order[i - 1])) first = i;
      const int share = distinct <= kBins ? first : first * kBins / cases;
      if (share != last_share) sums.push_back(0), counts.push_back(0);
      last_share = share;
      data_.level_of_case[order[i]] = static_cast<int>(sums.size()) - 1;
      sums.back() += value(order[i]);
      ++counts.back();
    }
    for (std::size_t b = 0; b < sums.size(); ++b) {
      data_.level_bgm.push_back(sums[b] / counts[b]);
      data_.level_labels.push_back(fmt::format("about {:.2f}", data_.level_bgm.back()));
    }
  }

  void add(std::size_t c) {
    const FolderCase& one = data_.plan.cases[c];
    data_.drapes += one.drapes;
    for (std::size_t k = 0; k < data_.plan.axes.size(); ++k)
      for (const auto& [name, value] : data_.plan.axes[k].levels[one.levels[k]].inputs)
        data_.inputs[c][name] = value;
    const std::optional<CaseRecord> record = folder_.record(one.address);
    if (!record) {
      data_.troubles.push_back({one.number, label(data_.plan, one), "open", "not run yet"});
      return;
    }
    ++data_.ran;
    data_.warnings[c] = record->warnings;
    if (counted_.insert(one.address).second)  // it ran once, whatever its numbers
      data_.core_seconds += record->execution.seconds;
    data_.drapes_counted += record->drapes_counted;
    if (record->status != CaseStatus::done) {
      data_.troubles.push_back(
          {one.number, label(data_.plan, one), name(record->status), record->reason});
      return;
    }
    ++data_.done;
    for (const std::string& left_out : record->left_out)
      data_.troubles.push_back({one.number, label(data_.plan, one), "incomplete", left_out});
    if (is_scored(*record))
      ++data_.scored;
    else if (!data_.modalities.empty())
      data_.troubles.push_back(
          {one.number, label(data_.plan, one), "no scores", why_unscored(*record)});
    for (const auto& [modality, criteria] : record->untold)
      for (const std::string& metric : std::set(criteria.begin(), criteria.end()))
        ++data_.untold[modality][metric];
    if (const auto share = record->garment.find("uncomfortable_share");
        share != record->garment.end())
      data_.uncomfortable_share[c] = share->second;
    for (const SiteRecord& site : record->sites) {
      SiteTable& table = table_of(site.modality, site.site);
      if (std::isnan(table.x) && site.not_covered.empty()) {
        table.x = site.x;
        table.y = site.y;
        table.z = site.z;
      }
    }
    std::map<std::string, std::map<std::string, std::pair<double, int>>> sums;  // by site, metric
    for (const SampleRecord& sample : record->samples) {
      SiteTable& table = table_of(sample.modality, sample.site);
      double& lowest = table.by_case[c];
      if (std::isnan(lowest) || sample.margin < lowest) lowest = sample.margin;
      if (!std::isnan(sample.margin)) table.by_donning[c][sample.donning] = sample.margin;
      if (!std::isnan(sample.margin) && !sample.limiting.empty()) ++table.limiting[sample.limiting];
      for (const auto& [metric, value] : sample.metrics)
        if (std::isfinite(value)) {
          auto& [sum, count] = sums[sample.modality + "\n" + sample.site][metric];
          sum += value;
          ++count;
        }
    }
    for (const auto& [key, metrics] : sums) {
      const std::size_t end = key.find('\n');
      SiteTable& table = table_of(key.substr(0, end), key.substr(end + 1));
      for (const auto& [metric, sum] : metrics) {
        std::vector<double>& values = table.metrics[metric];
        if (values.empty()) values.assign(data_.plan.cases.size(), kNotKnown);
        values[c] = sum.first / sum.second;
      }
    }
  }

  SiteTable& table_of(const std::string& modality, const std::string& site) {
    std::vector<SiteTable>& tables = data_.sites[modality];
    for (SiteTable& table : tables)
      if (table.site == site) return table;
    SiteTable& table = tables.emplace_back();
    table.site = site;
    table.by_case.assign(data_.plan.cases.size(), kNotKnown);
    table.by_donning.resize(data_.plan.cases.size());
    return table;
  }

  const StudyFolder& folder_;
  StudyData data_;
  std::set<std::string> counted_;  ///< addresses
};

}  // namespace

StudyData read_study_data(const StudyFolder& folder) { return Collector(folder).all(); }

int rated_units(const StudyData& data) {
  std::vector<char> rated(data.units.size(), 0);
  for (const auto& [modality, tables] : data.sites) mark_rated(data, tables, rated);
  return static_cast<int>(std::count(rated.begin(), rated.end(), 1));
}

int rated_units(const StudyData& data, const std::string& modality) {
  std::vector<char> rated(data.units.size(), 0);
  if (const auto found = data.sites.find(modality); found != data.sites.end())
    mark_rated(data, found->second, rated);
  return static_cast<int>(std::count(rated.begin(), rated.end(), 1));
}

int asked_units(const StudyData& data, int level) {
  if (level < 0 || people_axis(data.plan) >= 0) return static_cast<int>(data.units.size());
  std::set<int> asked;
  for (std::size_t c = 0; c < data.unit_of_case.size(); ++c)
    if (data.level_of_case[c] == level) asked.insert(data.unit_of_case[c]);
  return static_cast<int>(asked.size());
}

bool is_sample(const StudyData& data) {
  const int people = people_axis(data.plan);
  return people >= 0 && data.plan.axes[people].sampled && !data.plan.axes[people].stratified;
}

std::vector<double> unit_scores(const StudyData& data, const SiteTable& site, int level) {
  std::vector<double> scores(data.units.size(), kNotKnown);
  for (std::size_t c = 0; c < site.by_case.size(); ++c) {
    if (level >= 0 && data.level_of_case[c] != level) continue;
    double& score = scores[data.unit_of_case[c]];
    if (const double s = site.by_case[c]; !std::isnan(s))
      score = std::isnan(score) ? s : std::min(score, s);
  }
  return scores;
}

std::vector<double> greatest_by_unit(const StudyData& data, const std::vector<double>& by_case,
                                     int level) {
  std::vector<double> greatest(data.units.size(), kNotKnown);
  for (std::size_t c = 0; c < by_case.size(); ++c) {
    if (level >= 0 && data.level_of_case[c] != level) continue;
    double& value = greatest[data.unit_of_case[c]];
    if (!std::isnan(by_case[c]))
      value = std::isnan(value) ? by_case[c] : std::max(value, by_case[c]);
  }
  return greatest;
}

}  // namespace loosefit::study
