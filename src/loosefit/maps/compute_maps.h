#pragma once
#include <string>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/maps/catalogue.h"

namespace loosefit::maps {

/// What to compute and from what.
struct MapOptions {
  bool allow_unsettled = false;                ///< make maps of a sealed drape all the same
  const PressureField* pressure = nullptr;     ///< needed by the map "pressure"
  const fabric::Material* material = nullptr;  ///< needed by maps of strain and "gap"
};

/// The sensor performance maps of one drape in the order of the catalogue (maps/catalogue.h), which
/// says what each is. \throws InvalidInput for an unknown name, for "pressure" without a pressure
/// field, for maps of strain and "gap" without a material; Error for a drape that is not settled.
std::vector<PerformanceMap> compute_maps(
    const garment::Garment& garment, const drape::Drape& drape, const WornGarment& worn,
    const std::vector<std::string>& names = default_map_names(), const MapOptions& options = {});

/// The same in one call.
std::vector<PerformanceMap> compute_maps(
    const garment::Garment& garment, const drape::Drape& drape, const body::PosedBody& body,
    const std::vector<std::string>& names = default_map_names(), const MapOptions& options = {});

/// All arrays of one map. \throws InvalidInput when the input lacks what it is made of, or for an
/// unknown name.
std::vector<PerformanceMap> make_maps(const MapDefinition& definition, const MapInput& input);
std::vector<PerformanceMap> make_maps(const std::string& name, const MapInput& input);

/// The map "slip" of `now` against the reference.
std::vector<PerformanceMap> slip_maps(const garment::Garment& garment,
                                      const DressedState& reference, const DressedState& now);
/// The map "orientation-error" over `states` against the reference.
std::vector<PerformanceMap> orientation_error_maps(const garment::Garment& garment,
                                                   const DressedState& reference,
                                                   const std::vector<DressedState>& states);

/// \throws Error saying why, unless the certificate says settled and worn.
void require_settled(const drape::Certificate& certificate);

}  // namespace loosefit::maps
