#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "loosefit/base/side_by_side.h"
#include "loosefit/base/text.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"
#include "loosefit/study/check_worn.h"
#include "loosefit/study/spread_keys.h"

namespace loosefit {
namespace {

using Samples = std::map<std::string, std::vector<double>>;

/// What a drape has; places that a map leaves undefined have nothing.
void gather(const CaseResult& result, Samples& samples) {
  const auto take = [&](const std::string& key, double value) {
    if (std::isfinite(value)) samples[key].push_back(value);
  };
  for (const CaseMap& map : result.maps.maps) take(map_key(map.map.array), map.overall.area_mean);
  for (const Site& site : result.sites)
    for (const auto& [array, value] : site.values) take(site_key(site.name, array), value.mean);
}

/// Of two values or more.
Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  spread.count = static_cast<int>(values.size());
  for (double value : values) spread.mean += value / spread.count;
  double squares = 0;
  for (double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / (spread.count - 1));
  return spread;
}

/// What one drape has given; nothing when it did not settle or is not worn.
struct Repeat {
  std::optional<Samples> samples;
  std::vector<std::string> warnings;
};

/// `budget`: times the time that one drape has, for it shares the threads with others.
Repeat drape_again(const CaseResult& result, int repeat, double budget, Progress& progress) {
  Repeat made;
  CaseResult other;
  other.scenario = result.scenario;
  other.body = another_caller(result.body);
  other.pattern = result.pattern;
  other.garment = result.garment;
  other.under = result.under;
  DrapeOptions options = drape_options(result.scenario.simulation, repeat);
  options.time_budget *= budget;
  DrapeSession session(cloth_layers(result), options, progress);
  take_drape(put_on(session, other.body), other);
  const auto tell = [&](const std::string& what) {
    made.warnings.push_back(fmt::format("repeat {} {}", repeat + 1, what));
  };
  for (const std::string& warning : warnings_since(result.body, other.body)) tell(warning);
  if (!other.drape.certificate.settled()) {
    tell(fmt::format("did not settle ({}); left out", other.drape.certificate.stop_reason));
    return made;
  }
  check_worn(other);
  if (!other.drape.certificate.worn()) {
    tell(fmt::format("is not worn ({}); left out",
                     join(other.drape.certificate.worn_reasons, "; ")));
    return made;
  }
  other.maps = make_maps(other, false);
  other.sites = same_sites(other, result.sites);
  gather(other, made.samples.emplace());
  return made;
}

void add_spread(const std::vector<Repeat>& made, CaseResult& result) {
  Samples all;
  std::size_t drapes = 0;
  for (const Repeat& one : made) {
    result.repeat_warnings.insert(result.repeat_warnings.end(), one.warnings.begin(),
                                  one.warnings.end());
    if (!one.samples) continue;
    ++drapes;
    for (const auto& [key, values] : *one.samples)
      all[key].insert(all[key].end(), values.begin(), values.end());
  }
  if (drapes < 2) return;
  for (const auto& [key, values] : all)
    if (values.size() == drapes) result.repeats[key] = spread_of(values);
}

}  // namespace

void repeat_drapes(CaseResult& result, int at_once, Progress& progress) {
  const int repeats = result.scenario.simulation.repeats;
  if (repeats < 2) return;
  progress.stage("repeats");
  at_once = std::min(at_once, repeats - 1);
  std::vector<Repeat> made(repeats);
  if (result.drape.certificate.holds()) gather(result, made[0].samples.emplace());
  std::vector<SideJob> jobs;
  for (int repeat = 1; repeat < repeats; ++repeat)
    jobs.push_back({fmt::format("repeat {}", repeat + 1), [&, repeat](Progress& own) {
                      made[repeat] = drape_again(result, repeat, at_once, own);
                    }});
  side_by_side(jobs, at_once, progress);
  add_spread(made, result);
}

void keep_known_repeats(CaseResult& result) {
  std::set<std::string> known;
  for (const CaseMap& map : result.maps.maps) known.insert(map_key(map.map.array));
  for (const Site& site : result.sites)
    for (const auto& [array, value] : site.values) known.insert(site_key(site.name, array));
  std::erase_if(result.repeats, [&](const auto& entry) { return !known.contains(entry.first); });
}

}  // namespace loosefit
