#include "loosefit/study/measure_case.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/placement/ranking_wearers.h"

namespace loosefit::study {
namespace {

std::string state_name(const pipeline::CaseResult& result, const pipeline::CaseState& state) {
  const std::string posture =
      result.wear.postures.empty() ? "reference" : result.wear.postures[state.id.posture];
  return posture + ", donning " + std::to_string(state.id.donning + 1);
}

/// Why a state does not count.
std::string why(const pipeline::CaseState& state) {
  if (!state.left_out.empty()) return state.left_out;
  const drape::Certificate certificate = state.certificate();
  return certificate.settled() ? "not worn: " + join(certificate.worn_reasons, "; ")
                               : "not settled: " + certificate.stop_reason;
}

/// Donnings (from 0) of which every state counts.
std::set<int> whole_donnings(const pipeline::CaseResult& result) {
  std::set<int> whole{0};
  for (std::size_t d = 1; d < result.wear.donnings.size(); ++d) whole.insert(static_cast<int>(d));
  for (const pipeline::CaseState& state : result.wear.states)
    if (!state.counts()) whole.erase(state.id.donning);
  return whole;
}

/// The donnings of samples, in their order: those with a state that counts.
std::vector<int> sampled_donnings(const std::vector<placement::WornState>& states) {
  std::set<int> donnings;
  for (const placement::WornState& state : states) donnings.insert(state.donning);
  return {donnings.begin(), donnings.end()};
}

void add_garment(const pipeline::CaseResult& result, CaseRecord& record) {
  const pipeline::CaseGarment& studied = result.studied();
  for (const pipeline::StationEase& station :
       pipeline::station_eases(studied.pattern, result.scenario.studied().spec))
    record.fit[station.name] = station.cut;
  const pipeline::CaseMaps& maps = studied.maps;
  if (!maps.pressure.field.empty()) {
    record.garment["mean_pressure_kPa"] = maps.pressure.overall.contact_mean / 1000;
    record.garment["uncomfortable_share"] = maps::pressure_class_shares(maps.pressure.field).back();
  }
  if (maps.load) record.garment["force_over_weight"] = maps.load->force_over_weight();
  for (const pipeline::CaseMap& map : maps.maps)
    record.maps[map.map.array] = {{"p5", map.overall.p5},
                                  {"median", map.overall.median},
                                  {"p95", map.overall.p95},
                                  {"area_mean", map.overall.area_mean}};
}

SampleRecord sample_of(const placement::MetricValues& metrics, const placement::Scorecard& card) {
  SampleRecord sample;
  sample.modality = card.name;
  sample.metrics = metrics;
  const placement::Score score = placement::score(metrics, card);
  sample.bound = score.bound;
  sample.reason = score.reason;
  if (score.q) {
    sample.score = *score.q;
    sample.margin = score.margin;
  }
  if (score.limiting >= 0) sample.limiting = card.criteria[score.limiting].metric;
  return sample;
}

}  // namespace

placement::Scorecard tellable(const placement::Scorecard& card, bool several_postures,
                              bool several_donnings) {
  placement::Scorecard part = card;
  std::erase_if(part.criteria, [&](const placement::Criterion& criterion) {
    const placement::MetricName* metric = placement::find_metric(criterion.metric);
    const std::string needs = metric ? metric->needs : "";
    const bool lacks = (needs.find("postures") != std::string::npos && !several_postures) ||
                       (needs.find("donnings") != std::string::npos && !several_donnings);
    if (lacks) part.left_out.push_back(criterion.metric);
    return lacks;
  });
  return part;
}

CaseRecord measure_case(const pipeline::CaseResult& result,
                        const std::vector<placement::Scorecard>& scorecards) {
  CaseRecord record;
  const drape::Certificate& certificate = result.certificate();
  record.status = certificate.holds() ? CaseStatus::done : CaseStatus::sealed;
  if (!certificate.settled())
    record.reason = "not settled: " + certificate.stop_reason;
  else if (!certificate.worn())
    record.reason = "not worn: " + join(certificate.worn_reasons, "; ");
  record.residual = certificate.residual;
  record.vertices = static_cast<int>(result.studied().mesh().vertex_count);
  record.triangles = static_cast<int>(result.studied().mesh().triangles.size());
  record.drapes_asked = 1 + static_cast<int>(result.wear.states.size());
  record.drapes_counted = certificate.holds();
  for (const pipeline::CaseState& state : result.wear.states)
    if (state.counts())
      ++record.drapes_counted;
    else
      record.left_out.push_back(state_name(result, state) + ": " + why(state));
  record.warnings = result.warnings;
  record.versions = versions();
  for (const auto& [measure, value] : result.body.body->measured) record.body[measure] = value;
  if (!certificate.holds()) return record;
  add_garment(result, record);

  const pipeline::CaseGarment& studied = result.studied();
  const std::vector<placement::WornState> states = pipeline::worn_states(result);
  const placement::SiteMeter meter(studied.mesh(), result.scenario.studied().material.material,
                                   states);
  const std::vector<placement::RankingWearer> wearers = {
      {"", {studied.mesh(), studied.drape.positions, result.body.body, studied.maps.worn, meter}}};
  const pipeline::SiteStage found = pipeline::find_case_sites(result);
  const std::vector<int> donnings = sampled_donnings(states);
  const std::set<int> whole = whole_donnings(result);
  for (const placement::Scorecard& whole_card : scorecards) {
    const placement::Scorecard card = tellable(whole_card, result.scenario.postures.size() > 1,
                                               result.scenario.donning.repeats > 1);
    if (!card.left_out.empty()) record.untold[card.name] = card.left_out;
    const placement::Wearers measured(wearers, card);
    std::vector<std::string> no_line;
    const std::vector<placement::Site> all =
        placement::sites_with_sensor(wearers.front().ground, found.sites, card, no_line);
    const std::vector<std::string> not_covering = measured.not_covering(all);
    for (const placement::UncoveredSite& site : found.uncovered)
      record.sites.push_back({.modality = card.name,
                              .site = site.name,
                              .region = "",
                              .panel = "",
                              .not_covered = site.why});
    for (std::size_t i = 0; i < all.size(); ++i) {
      const placement::Site& site = all[i];
      record.sites.push_back({card.name, site.name, body::name(site.region), site.panel,
                              site.at.x(), site.at.y(), site.position.x(), site.position.y(),
                              site.position.z(), not_covering[i]});
      if (!not_covering[i].empty() || card.criteria.empty()) continue;
      const placement::WearerSamples samples = measured.at(std::vector{site}).front();
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const int donning = k < donnings.size() ? donnings[k] : static_cast<int>(k);
        if (!whole.count(donning)) continue;
        SampleRecord sample = sample_of(samples[k], card);
        sample.site = site.name;
        sample.donning = donning + 1;
        record.samples.push_back(std::move(sample));
      }
    }
  }
  return record;
}

}  // namespace loosefit::study
