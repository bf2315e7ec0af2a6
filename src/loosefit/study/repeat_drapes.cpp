#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/side_by_side.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/drapes_at_once.h"

namespace loosefit {
namespace {

using Samples = std::map<std::string, std::vector<double>>;

void gather(const CaseResult& result, Samples& samples) {
  for (const CaseMap& map : result.maps.maps)
    samples["maps." + map.map.array + ".area_mean"].push_back(map.overall.area_mean);
  for (const Site& site : result.sites)
    for (const auto& [array, value] : site.values)
      samples["sites." + site.name + "." + array].push_back(value.mean);
}

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  spread.count = static_cast<int>(values.size());
  for (double value : values) spread.mean += value / spread.count;
  double squares = 0;
  for (double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = spread.count > 1 ? std::sqrt(squares / (spread.count - 1)) : 0;
  return spread;
}

/// What one more drape has given.
struct Repeat {
  Samples samples;
  std::vector<std::string> warnings;
};

/// `budget`: times the time that one drape has, for it shares the threads with others.
Repeat drape_again(const CaseResult& result, int repeat, double budget, Progress& progress) {
  Repeat made;
  CaseResult other = result;  // same pattern and garment
  other.body = another_caller(result.body);
  DrapeOptions options = drape_options(result.scenario.simulation, repeat);
  options.time_budget *= budget;
  DrapeSession session(cloth_layers(result), options, progress);
  take_drape(put_on(session, other.body), other);
  const auto tell = [&](const std::string& what) {
    made.warnings.push_back(fmt::format("settle: repeat {} {}", repeat + 1, what));
  };
  for (std::size_t k = result.body.warnings.size(); k < other.body.warnings.size(); ++k)
    tell(other.body.warnings[k]);
  if (!other.drape.certificate.settled()) {
    tell(fmt::format("did not settle ({}); left out", other.drape.certificate.stop_reason));
    return made;
  }
  other.maps = make_maps(other, false);
  other.sites = same_sites(other, result.sites);
  gather(other, made.samples);
  return made;
}

}  // namespace

void repeat_drapes(CaseResult& result, Progress& progress) {
  const int repeats = result.scenario.simulation.repeats;
  if (repeats < 2) return;
  progress.stage("repeats");
  const int at_once = std::min(drapes_at_once(), repeats - 1);
  std::vector<Repeat> made(repeats);
  if (result.drape.certificate.settled()) gather(result, made[0].samples);
  std::vector<SideJob> jobs;
  for (int repeat = 1; repeat < repeats; ++repeat)
    jobs.push_back({fmt::format("repeat {}", repeat + 1), [&, repeat](Progress& own) {
                      made[repeat] = drape_again(result, repeat, at_once, own);
                    }});
  side_by_side(jobs, at_once, progress);
  Samples all;
  for (const Repeat& one : made) {
    for (const auto& [key, values] : one.samples)
      all[key].insert(all[key].end(), values.begin(), values.end());
    result.warnings.insert(result.warnings.end(), one.warnings.begin(), one.warnings.end());
  }
  for (const auto& [key, values] : all) result.repeats[key] = spread_of(values);
}

}  // namespace loosefit
