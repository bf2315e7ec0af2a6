#include "loosefit/pipeline/garment_maps.h"

#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/contact_share.h"

namespace loosefit::pipeline {
namespace {

CasePressure make_pressure(const DressedGarment& dressed, const maps::WornGarment& worn,
                           double gravity) {
  CasePressure made;
  if (dressed.drape.body_normal_force.empty()) return made;
  made.field =
      maps::contact_pressure(dressed.mesh, dressed.drape, dressed.body, dressed.material, gravity);
  made.overall = maps::compare_pressures(made.field, worn.regions);
  made.contact_share = maps::contact_share_of_pressed_area(
      dressed.mesh.triangles, dressed.drape.positions, made.field, dressed.body, dressed.material);
  for (body::Region region : body::all_regions()) {
    const maps::PressureAgreement here = maps::compare_pressures(made.field, worn.regions, region);
    if (here.contact_area > 0) made.regional[region] = here;
  }
  return made;
}

}  // namespace

const CaseMap* find_map(const std::vector<CaseMap>& maps, const std::string& array) {
  for (const CaseMap& entry : maps)
    if (entry.map.array == array) return &entry;
  return nullptr;
}

CaseMaps make_maps(const DressedGarment& dressed, const scenario::Scenario& scenario,
                   bool allow_unsettled) {
  CaseMaps made;
  made.worn = maps::relate(dressed.mesh, dressed.drape.positions, dressed.body);
  made.pressure = make_pressure(dressed, made.worn, scenario.simulation.gravity);
  for (maps::PerformanceMap& map :
       maps::compute_maps(dressed.mesh, dressed.drape, made.worn, scenario.output.maps,
                          {allow_unsettled, &made.pressure.field, &dressed.material}))
    made.maps.push_back(with_statistics(std::move(map), made.worn));
  made.wrinkles = maps::regional_wrinkles(dressed.mesh, made.worn);
  made.chest = maps::torso_girth(dressed.mesh, dressed.drape.positions, made.worn,
                                 maps::chest_height(dressed.body));
  if (!dressed.drape.body_normal_force.empty())
    made.load = maps::body_load(dressed.mesh, dressed.drape, made.worn, dressed.body,
                                dressed.material, scenario.simulation.gravity);
  made.strain_range = maps::strain_range(dressed.mesh, dressed.drape.positions, dressed.material);
  return made;
}

CaseMaps make_studied_maps(const CaseResult& draped, bool allow_unsettled) {
  return make_maps({draped.studied().mesh(), draped.studied().drape,
                    draped.scenario.studied().material.material, draped.body.body},
                   draped.scenario, allow_unsettled);
}

CaseMap with_statistics(maps::PerformanceMap map, const maps::WornGarment& worn) {
  CaseMap entry;
  entry.overall = maps::statistics(map.values, worn.areas);
  entry.regional = maps::regional_statistics(map.values, worn.areas, worn.regions);
  entry.map = std::move(map);
  return entry;
}

std::vector<maps::PerformanceMap> plain_maps(const std::vector<CaseMap>& maps) {
  std::vector<maps::PerformanceMap> plain;
  for (const CaseMap& entry : maps) plain.push_back(entry.map);
  return plain;
}

}  // namespace loosefit::pipeline
