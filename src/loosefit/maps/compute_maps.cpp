#include "loosefit/maps/compute_maps.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/vertex_reader.h"

namespace loosefit::maps {
namespace {

/// \throws InvalidInput when the input lacks what the map is made of.
void require_input(const MapDefinition& map, const MapInput& input) {
  if (map.needs_forces && (!input.pressure || input.pressure->empty()))
    throw InvalidInput("the drape does not know the forces of its contact, which the map '" +
                           map.name + "' is made of",
                       "it was made by an earlier version: make it again");
  if (map.needs_material && !input.material)
    throw InvalidInput("the map '" + map.name + "' needs the material of the cloth");
  if (map.needs_postures && (!input.reference || !input.states || input.states->empty()))
    throw InvalidInput("the map '" + map.name + "' needs another posture");
}

}  // namespace

std::vector<PerformanceMap> make_maps(const MapDefinition& definition, const MapInput& input) {
  require_input(definition, input);
  VertexReader reader(input);
  std::vector<PerformanceMap> maps;
  for (const MapArray& array : definition.arrays)
    maps.push_back({array.style, reader.values(array)});
  return maps;
}

std::vector<PerformanceMap> make_maps(const std::string& name, const MapInput& input) {
  const MapDefinition* map = find_map(name);
  if (!map)
    throw InvalidInput("unknown map '" + printable(name) + "'", did_you_mean(name, map_names()));
  return make_maps(*map, input);
}

std::vector<PerformanceMap> slip_maps(const garment::Garment& garment,
                                      const DressedState& reference, const DressedState& now) {
  const std::vector<DressedState> states = {now};
  return make_maps("slip",
                   {garment, now.positions, now.worn, nullptr, nullptr, &reference, &states});
}

std::vector<PerformanceMap> orientation_error_maps(const garment::Garment& garment,
                                                   const DressedState& reference,
                                                   const std::vector<DressedState>& states) {
  return make_maps("orientation-error", {garment, reference.positions, reference.worn, nullptr,
                                         nullptr, &reference, &states});
}

void require_settled(const drape::Certificate& c) {
  if (c.holds()) return;
  if (c.settled())
    throw Error(
        "the garment is not worn (" + join(c.worn_reasons, "; ") + ") and maps of it would mislead",
        "--allow-unsettled makes maps all the same");
  throw Error(
      "the drape is not settled (residual " + shortest(c.residual) + ", intersections with body " +
          std::to_string(c.intersections_body) + ", with itself " +
          std::to_string(c.intersections_self) + "; stopped: " + c.stop_reason +
          ") and maps of it would mislead",
      "summary.json tells why in settle.unsettled; --allow-unsettled makes maps all the same");
}

std::vector<PerformanceMap> compute_maps(const garment::Garment& garment, const drape::Drape& drape,
                                         const WornGarment& worn,
                                         const std::vector<std::string>& names,
                                         const MapOptions& options) {
  for (const std::string& name : names)
    if (std::find(map_names().begin(), map_names().end(), name) == map_names().end())
      throw InvalidInput("unknown map '" + printable(name) + "'", did_you_mean(name, map_names()));
  if (!options.allow_unsettled) require_settled(drape.certificate);

  const MapInput input{garment, drape.positions, worn, options.material, options.pressure};
  std::vector<PerformanceMap> maps;
  const auto named = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const MapDefinition& map : map_catalogue()) {
    if (!named(map.name) && !named(map.made_with)) continue;
    if (map.needs_ease && garment.vertex_ease_cut.empty()) continue;
    for (PerformanceMap& array : make_maps(map, input)) maps.push_back(std::move(array));
  }
  return maps;
}

std::vector<PerformanceMap> compute_maps(const garment::Garment& garment, const drape::Drape& drape,
                                         const body::PosedBody& body,
                                         const std::vector<std::string>& names,
                                         const MapOptions& options) {
  if (!options.allow_unsettled) require_settled(drape.certificate);
  return compute_maps(garment, drape, relate(garment, drape.positions, body), names, options);
}

}  // namespace loosefit::maps
