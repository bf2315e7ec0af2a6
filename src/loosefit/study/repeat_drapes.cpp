#include <fmt/format.h>

#include <cmath>

#include "loosefit/drape/drape_session.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"

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

}  // namespace

void repeat_drapes(CaseResult& result, Progress& progress) {
  const ScenarioSimulation& simulation = result.scenario.simulation;
  if (simulation.repeats < 2) return;
  Samples samples;
  if (result.drape.certificate.settled()) gather(result, samples);
  for (int repeat = 1; repeat < simulation.repeats; ++repeat) {
    CaseResult other = result;  // same body, pattern and garment
    DrapeSession session(cloth_layers(result), drape_options(simulation, repeat), progress);
    take_drape(put_on(session, other.body), other);
    if (!other.drape.certificate.settled()) {
      result.warnings.push_back(fmt::format("settle: repeat {} did not settle ({}); left out",
                                            repeat + 1, other.drape.certificate.stop_reason));
      continue;
    }
    progress.stage("maps");
    other.maps = make_maps(other, false);
    progress.stage("placement");
    other.sites = same_sites(other, result.sites);
    gather(other, samples);
  }
  for (const auto& [key, values] : samples) result.repeats[key] = spread_of(values);
}

}  // namespace loosefit
