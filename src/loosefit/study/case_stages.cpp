#include "loosefit/study/case_stages.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
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

std::vector<PerformanceMap> plain_maps(const std::vector<CaseMap>& maps) {
  std::vector<PerformanceMap> plain;
  for (const CaseMap& entry : maps) plain.push_back(entry.map);
  return plain;
}

CasePressure make_pressure(const CaseResult& result, const WornGarment& worn) {
  CasePressure made;
  if (result.drape.body_normal_force.empty()) return made;
  made.field =
      contact_pressure(result.mesh(), result.drape, result.body.body,
                       result.scenario.material.material, result.scenario.simulation.gravity);
  made.overall = compare_pressures(made.field, worn.regions);
  for (Region region : all_regions()) {
    const PressureAgreement here = compare_pressures(made.field, worn.regions, region);
    if (here.contact_area > 0) made.regional[region] = here;
  }
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
  const Garment& garment = result.mesh();
  const std::vector<Vec3>& positions = result.drape.positions;
  CaseMaps made;
  made.worn = relate(garment, positions, result.body.body);
  made.pressure = make_pressure(result, made.worn);
  for (PerformanceMap& map :
       compute_maps(garment, result.drape, made.worn, result.scenario.output.maps,
                    {allow_unsettled, &made.pressure.field, &result.scenario.material.material}))
    made.maps.push_back(summed_up(std::move(map), made.worn));
  made.wrinkles = regional_wrinkles(garment, made.worn);
  made.chest = torso_girth(garment, positions, made.worn, chest_height(result.body.body));
  return made;
}

std::vector<Site> make_sites(const CaseResult& result) {
  return find_sites(result.mesh(), result.drape.positions, result.body.body, result.maps.worn,
                    plain_maps(result.maps.maps), result.scenario.sites,
                    result.scenario.output.preset_sites);
}

void add_sites(CaseResult& result) {
  result.sites = make_sites(result);
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
  add("material", result.scenario.material.notes);
  const Certificate& certificate = result.drape.certificate;
  if (!certificate.settled())
    all.push_back(
        fmt::format("settle: not settled ({}): residual {:.2e}, intersections with the "
                    "body {}, with itself {}",
                    certificate.stop_reason, certificate.residual, certificate.intersections_body,
                    certificate.intersections_self));
  const std::vector<std::string> wear = wear_warnings(result);
  all.insert(all.end(), wear.begin(), wear.end());
  return all;
}

}  // namespace loosefit
