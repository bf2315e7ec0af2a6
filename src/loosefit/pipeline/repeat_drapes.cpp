#include "loosefit/pipeline/repeat_drapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/drape_side_by_side.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/put_on_garments.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/pipeline/site_values.h"

namespace loosefit::pipeline {
namespace {

using Samples = std::map<std::string, double>;

/// What one drape has; places that a map leaves undefined have nothing.
Samples samples_of(const std::vector<CaseMap>& maps, const std::vector<placement::Site>& sites) {
  Samples samples;
  const auto take = [&](const std::string& key, double value) {
    if (std::isfinite(value)) samples[key] = value;
  };
  for (const CaseMap& map : maps) take(map_spread_key(map.map.array), map.overall.area_mean);
  for (const placement::Site& site : sites)
    for (const auto& [name, value] : site_values(site))
      if (!name.ends_with("_worst")) take(site_spread_key(site.name, name), value);
  return samples;
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

/// What one drape has given; no samples when it did not settle or is not worn.
struct Repeat {
  std::optional<Samples> samples;
  std::vector<std::string> warnings;
};

Repeat drape_again(const CaseResult& result, int repeat, int sharing, Progress& progress) {
  // Put on once more, from another start.
  const scenario::Scenario& scenario = result.scenario;
  CaseBody body = clone_wearer(result.body);
  drape::DrapeOptions options = drape_options(scenario.simulation, repeat);
  options.drapes_at_once = sharing;
  const CaseDonning how{.movements = drawn_movements(scenario.donning, options.seed)};
  std::vector<drape::Drape> drapes =
      put_on_garments(scenario, result.garments, body, how, options, progress).drapes;

  // Left out with the reason unless it is settled and worn.
  Repeat made;
  const auto warn = [&](const std::string& what) {
    made.warnings.push_back(fmt::format("repeat {} {}", repeat + 1, what));
  };
  for (const std::string& warning : warnings_since(result.body, body)) warn(warning);
  if (drapes.back().report.was_tried(drape::RecoveryKind::another_start))
    warn("was put on once more, shifted a little");
  if (const drape::Certificate& c = drapes.back().certificate; !c.settled()) {
    warn(fmt::format("did not settle ({}); left out", c.stop_reason));
    return made;
  }
  drapes = check_worn(std::move(drapes), body.body, result);
  const drape::Drape& drape = drapes.back();
  if (!drape.certificate.worn()) {
    warn(fmt::format("is not worn ({}); left out", join(drape.certificate.worn_reasons, "; ")));
    return made;
  }

  // The same maps, and the same sensors where they are sewn.
  const garment::Garment& mesh = result.studied().mesh();
  const CaseMaps maps =
      make_maps({mesh, drape, scenario.studied().material.material, body.body}, scenario, false);
  made.samples = samples_of(maps.maps, sites_in_drape(result, drape, maps, body.body));
  return made;
}

CaseRepeats gathered(const std::vector<Repeat>& made) {
  CaseRepeats repeats;
  std::map<std::string, std::vector<double>> all;
  std::size_t drapes = 0;
  for (const Repeat& one : made) {
    repeats.warnings.insert(repeats.warnings.end(), one.warnings.begin(), one.warnings.end());
    if (!one.samples) continue;
    ++drapes;
    for (const auto& [key, value] : *one.samples) all[key].push_back(value);
  }
  if (drapes < 2) return repeats;
  for (const auto& [key, values] : all)
    if (values.size() == drapes) repeats.spread[key] = spread_of(values);
  return repeats;
}

}  // namespace

CaseRepeats repeat_drapes(const CaseResult& result, int at_once, Progress& progress) {
  const int repeats = result.scenario.simulation.repeats;
  if (repeats < 2) return {};
  progress.stage("repeats");
  std::vector<Repeat> made(repeats);
  if (result.certificate().holds())
    made.front().samples = samples_of(
        result.studied().maps.maps,
        sites_in_drape(result, result.studied().drape, result.studied().maps, result.body.body));
  std::vector<DrapeJob> jobs;
  for (int repeat = 1; repeat < repeats; ++repeat)
    jobs.push_back({fmt::format("repeat {}", repeat + 1),
                    [&, repeat](int sharing, Progress& own) {
                      made[repeat] = drape_again(result, repeat, sharing, own);
                    },
                    [&, repeat](const std::string& why) {
                      made[repeat].warnings = {
                          fmt::format("repeat {} could not be draped: {}", repeat + 1, why)};
                    }});
  drape_side_by_side(jobs, at_once, progress);
  return gathered(made);
}

CaseRepeats known_repeats(const CaseResult& result) {
  std::set<std::string> known;
  for (const CaseMap& map : result.studied().maps.maps) known.insert(map_spread_key(map.map.array));
  for (const placement::Site& site : result.sites)
    for (const auto& entry : site_values(site))
      known.insert(site_spread_key(site.name, entry.first));
  CaseRepeats repeats = result.repeats;
  std::erase_if(repeats.spread, [&](const auto& entry) { return !known.contains(entry.first); });
  return repeats;
}

std::string map_spread_key(const std::string& array) { return "maps." + array + ".area_mean"; }

std::string site_spread_key(const std::string& site, const std::string& array) {
  return "sites." + site + "." + array;
}

}  // namespace loosefit::pipeline
