#include "loosefit/study/case_stages.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

IntegratorKind integrator_kind(const std::string& word) {
  if (word == "semi-implicit-euler") return IntegratorKind::semi_implicit_euler;
  if (word == "implicit-euler") return IntegratorKind::implicit_euler;
  if (word == "quasi-static") return IntegratorKind::quasi_static;
  throw InvalidInput({"", 0, "simulation.integrator"}, "\"" + word + "\"",
                     "semi-implicit-euler, implicit-euler or quasi-static");
}

/// One garment of a case as its wearer has it on.
struct Worn {
  const Garment& garment;
  const Drape& drape;
  const Material& material;
  const Body& body;
};

std::vector<PerformanceMap> plain_maps(const std::vector<CaseMap>& maps) {
  std::vector<PerformanceMap> plain;
  for (const CaseMap& entry : maps) plain.push_back(entry.map);
  return plain;
}

CasePressure make_pressure(const Worn& of, const WornGarment& worn, const Scenario& scenario) {
  CasePressure made;
  if (of.drape.body_normal_force.empty()) return made;
  made.field =
      contact_pressure(of.garment, of.drape, of.body, of.material, scenario.simulation.gravity);
  made.overall = compare_pressures(made.field, worn.regions);
  for (Region region : all_regions()) {
    const PressureAgreement here = compare_pressures(made.field, worn.regions, region);
    if (here.contact_area > 0) made.regional[region] = here;
  }
  return made;
}

CaseMaps maps_of(const Worn& of, const Scenario& scenario, bool allow_unsettled) {
  CaseMaps made;
  made.worn = relate(of.garment, of.drape.positions, of.body);
  made.pressure = make_pressure(of, made.worn, scenario);
  for (PerformanceMap& map : compute_maps(of.garment, of.drape, made.worn, scenario.output.maps,
                                          {allow_unsettled, &made.pressure.field, &of.material}))
    made.maps.push_back(summed_up(std::move(map), made.worn));
  made.wrinkles = regional_wrinkles(of.garment, made.worn);
  made.chest = torso_girth(of.garment, of.drape.positions, made.worn, chest_height(of.body));
  return made;
}

}  // namespace

DrapeOptions drape_options(const ScenarioSimulation& simulation, int repeat) {
  return {.integrator = integrator_kind(simulation.integrator),
          .residual_tolerance = simulation.residual_tolerance,
          .gravity = simulation.gravity,
          .time_budget = simulation.time_budget,
          .max_iterations = simulation.max_iterations,
          .threads = simulation.threads,
          .seed = simulation.seed + static_cast<std::uint64_t>(repeat),
          .start_perturbation = simulation.start_perturbation};
}

CaseMap summed_up(PerformanceMap map, const WornGarment& worn) {
  CaseMap entry;
  entry.overall = statistics(map.values, worn.areas);
  entry.regional = regional_statistics(map.values, worn.areas, worn.regions);
  entry.map = std::move(map);
  return entry;
}

CaseMaps make_maps(const CaseResult& result, bool allow_unsettled) {
  return maps_of(
      {result.mesh(), result.drape, result.scenario.studied().material.material, result.body.body},
      result.scenario, allow_unsettled);
}

CaseMaps make_under_maps(const CaseResult& result, int layer, bool allow_unsettled) {
  const CaseUnder& under = result.under[layer];
  return maps_of({under.mesh(), under.drape, result.scenario.garments[layer].material.material,
                  result.body.body},
                 result.scenario, allow_unsettled);
}

std::vector<Site> make_sites(const CaseResult& result, std::vector<UncoveredSite>* uncovered) {
  std::vector<UncoveredSite> unused;
  return find_sites(result.mesh(), result.drape.positions, result.body.body, result.maps.worn,
                    plain_maps(result.maps.maps), result.scenario.sites,
                    result.scenario.output.preset_sites, uncovered ? uncovered : &unused);
}

void add_sites(CaseResult& result) {
  result.uncovered_sites.clear();
  result.sites = make_sites(result, &result.uncovered_sites);
  for (CaseState& s : result.wear.states)
    if (s.posture == 0 && s.counts())
      s.sites = revisit_sites(result.sites, result.mesh(), s.drape.positions, result.body.body,
                              s.worn, plain_maps(s.maps));
}

std::vector<Site> same_sites(const CaseResult& result, const std::vector<Site>& sites) {
  return revisit_sites(sites, result.mesh(), result.drape.positions, result.body.body,
                       result.maps.worn, plain_maps(result.maps.maps));
}

std::vector<std::string> collected_warnings(const CaseResult& result) {
  std::vector<std::string> all = result.warnings;
  const auto add = [&all](const std::string& stage, const std::vector<std::string>& warnings) {
    for (const std::string& text : warnings) all.push_back(stage + ": " + text);
  };
  add("body", result.body.warnings);
  add("pattern", result.pattern.warnings);
  add("material", result.scenario.studied().material.notes);
  for (std::size_t l = 0; l < result.under.size(); ++l) {
    add(fmt::format("pattern of under {}", l + 1), result.under[l].pattern.warnings);
    add(fmt::format("material of under {}", l + 1), result.scenario.garments[l].material.notes);
  }
  for (const UncoveredSite& site : result.uncovered_sites)
    if (!site.preset)
      all.push_back("placement: site " + site.name + " is not covered by the garment: " + site.why);
  const Certificate& certificate = result.drape.certificate;
  if (!certificate.settled())
    all.push_back(
        fmt::format("settle: not settled ({}): residual {:.2e}, intersections with the "
                    "body {}, with itself {}",
                    certificate.stop_reason, certificate.residual, certificate.intersections_body,
                    certificate.intersections_self));
  if (!certificate.worn()) all.push_back("not worn: " + join(certificate.worn_reasons, "; "));
  add("settle", result.repeat_warnings);
  if (result.scenario.simulation.repeats > 1 && result.repeats.empty())
    all.push_back("settle: no spread over repeats: it takes two drapes from different starts");
  const std::vector<std::string> wear = wear_warnings(result);
  all.insert(all.end(), wear.begin(), wear.end());
  return all;
}

}  // namespace loosefit
