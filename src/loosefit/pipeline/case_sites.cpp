#include "loosefit/pipeline/case_sites.h"

#include "loosefit/io/scorecard_file.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/placement/ranking_wearers.h"

namespace loosefit::pipeline {
namespace {

/// The sensor that sites are measured with; without [ranking] one that asks for nothing.
placement::Scorecard sensor_of(const scenario::Scenario& scenario) {
  const std::string& modality = scenario.ranking.modality;
  return modality.empty() ? placement::Scorecard{} : io::load_scorecard(modality);
}

}  // namespace

SiteStage find_case_sites(const CaseResult& mapped) {
  const CaseGarment& garment = mapped.studied();
  SiteStage made;
  made.sites =
      placement::find_sites(garment.mesh(), garment.drape.positions, mapped.body.body,
                            garment.maps.worn, plain_maps(garment.maps.maps), mapped.scenario.sites,
                            mapped.scenario.output.preset_sites, &made.uncovered);
  return made;
}

SiteStage make_sites(const CaseResult& mapped) {
  SiteStage made = find_case_sites(mapped);
  const CaseGarment& garment = mapped.studied();
  const garment::Garment& mesh = garment.mesh();
  const placement::SiteMeter meter(mesh, mapped.scenario.studied().material.material,
                                   worn_states(mapped));
  const placement::Scorecard sensor = sensor_of(mapped.scenario);
  const placement::RankingGround ground{mesh, garment.drape.positions, mapped.body.body,
                                        garment.maps.worn, meter};
  if (!mapped.scenario.ranking.modality.empty()) {
    give_sensor(ground, sensor, made.sites);
    made.sites = revisit_sites(made.sites, mesh, garment.drape.positions, mapped.body.body,
                               garment.maps.worn, plain_maps(garment.maps.maps));
  }
  const placement::SensorProbe probe(ground, sensor);
  std::vector<std::vector<placement::MetricValues>> in_states;  // per site, as worn_states
  for (placement::Site& site : made.sites) {
    site.samples = probe.at(site);
    in_states.push_back(probe.in_states(site));
  }
  std::size_t measured = 0;  // the reference state is the first
  for (const CaseState& state : mapped.wear.states) {
    std::vector<placement::Site>& here = made.in_states.emplace_back();
    if (!state.counts()) continue;
    here =
        revisit_sites(made.sites, mesh, state.drape().positions, mapped.body_in(state.id.posture),
                      state.maps.worn, plain_maps(state.maps.maps));
    ++measured;
    for (std::size_t i = 0; i < here.size(); ++i) here[i].samples = {in_states[i][measured]};
  }
  return made;
}

std::vector<placement::Site> sites_in_drape(const CaseResult& mapped, const drape::Drape& drape,
                                            const CaseMaps& maps, const body::PosedBody& body) {
  const garment::Garment& mesh = mapped.studied().mesh();
  std::vector<placement::Site> sites =
      revisit_sites(mapped.sites, mesh, drape.positions, body, maps.worn, plain_maps(maps.maps));
  const maps::PressureField& pressure = maps.pressure.field;
  const std::vector<placement::WornState> state = {
      {0, 0, drape.positions, body, maps.worn, pressure.empty() ? nullptr : &pressure}};
  const placement::SiteMeter meter(mesh, mapped.scenario.studied().material.material, state);
  const placement::RankingGround ground{mesh, drape.positions, body, maps.worn, meter};
  const placement::Scorecard sensor = sensor_of(mapped.scenario);
  const placement::SensorProbe probe(ground, sensor);
  for (placement::Site& site : sites) site.samples = probe.in_states(site);
  return sites;
}

}  // namespace loosefit::pipeline
