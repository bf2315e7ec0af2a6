#pragma once
#include <string>
#include <vector>

#include "loosefit/drape/drape.h"
#include "loosefit/fabric/material.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit {

/// Words a scenario may use for maps.
const std::vector<std::string>& map_names();
/// The paper's three, made when nothing is said.
const std::vector<std::string>& default_map_names();

/// What to compute and from what.
struct MapOptions {
  bool allow_unsettled = false;             ///< make maps of a sealed drape all the same
  const PressureField* pressure = nullptr;  ///< needed by the map "pressure"
  const Material* material = nullptr;       ///< needed by the map "gap"
};

/// The sensor performance maps of one drape (the first three: Harms, Amft, Tröster 2012, section
/// 2.2; the others docs/theory/sensor_metrics.md 3 to 5):
///
/// | name              | arrays                                                              |
/// |-------------------|---------------------------------------------------------------------|
/// | strain            | strain_vertical, strain_warp, strain_weft, strain_max, strain_min,  |
/// |                   | slack [–]                                                           |
/// | distance          | distance_mm (point to surface), distance_particle_mm                |
/// | angular-deviation | angular_deviation_deg                                               |
/// | pressure          | pressure_kPa, pressure_membrane_kPa, pressure_difference_kPa        |
/// | orientation       | tilt_sagittal_deg, tilt_lateral_deg, twist_deg, rotation_deg        |
/// | gap               | gap_mm, contact [–]                                                 |
///
/// Strains: maps/strain.h; all but the first are means over the triangles round a vertex, slack the
/// share of slack ones. Distance is from the cloth's middle surface to the body surface; cloth that
/// lies on the skin therefore reads the contact offset, half the fabric's thickness. The particle
/// form measures to the nearest body vertex and is never below the exact one. Angular deviation is
/// the angle between the garment's vertex normal and the smooth body normal at the partner point
/// (maps/body_partner.h). Pressure is that of the contact forces, that of the membrane balance, and
/// the second minus the first (maps/pressure.h). Orientation: maps/orientation.h, of the grain
/// against the segment's long axis. Gap: maps/gap.h. \throws InvalidInput for an unknown name, for
/// "pressure" without a pressure field and "gap" without a material; Error for a drape that is not
/// settled.
std::vector<PerformanceMap> compute_maps(
    const Garment& garment, const Drape& drape, const WornGarment& worn,
    const std::vector<std::string>& names = default_map_names(), const MapOptions& options = {});

/// The same in one call.
std::vector<PerformanceMap> compute_maps(
    const Garment& garment, const Drape& drape, const Body& body,
    const std::vector<std::string>& names = default_map_names(), const MapOptions& options = {});

/// Angle between two unit vectors in degrees as atan2(|a × b|, a · b), exact also near zero.
double angle_deg(const Vec3& a, const Vec3& b);

/// \throws Error saying why, unless the certificate says settled and worn.
void require_settled(const Certificate& certificate);

}  // namespace loosefit
