#include "loosefit/maps/compute_maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/gap.h"
#include "loosefit/maps/orientation.h"
#include "loosefit/maps/strain.h"

namespace loosefit {
namespace {
// Fixed ranges, so that pictures of different garments and people can be compared.
constexpr double kStrainRange = 0.05;   // [–], both signs
constexpr double kDistanceRange = 40;   // [mm]
constexpr double kDeviationRange = 40;  // [deg]
constexpr double kPressureGap = 1;      // shown difference of the two estimates [kPa]

PerformanceMap strain_map(const std::string& array, const std::string& title, bool pictured,
                          std::vector<double> values) {
  const std::string map = pictured ? "strain" : "strain-" + array.substr(array.find('_') + 1);
  return {array, title, "–", -kStrainRange, kStrainRange, std::move(values), map, pictured, true};
}

void add_strain(const Garment& garment, const Drape& drape, std::vector<PerformanceMap>& maps) {
  const auto strains = triangle_strains(garment, drape.positions);
  const auto averaged = [&](double TriangleStrain::*part) {
    std::vector<double> values;
    for (const TriangleStrain& s : strains) values.push_back(s.*part);
    return to_vertices(garment, values);
  };
  maps.push_back(strain_map("strain_vertical", "Vertical strain", true,
                            vertical_strain(garment, drape.positions)));
  maps.push_back(
      strain_map("strain_warp", "Strain along warp", false, averaged(&TriangleStrain::warp)));
  maps.push_back(
      strain_map("strain_weft", "Strain along weft", false, averaged(&TriangleStrain::weft)));
  maps.push_back(
      strain_map("strain_max", "Greatest principal strain", false, averaged(&TriangleStrain::max)));
  maps.push_back(
      strain_map("strain_min", "Least principal strain", false, averaged(&TriangleStrain::min)));
  maps.push_back(
      {"slack", "Share of slack cloth", "–", 0, 1, slack_share(garment, strains), "slack", false});
}

void add_distance(const WornGarment& worn, std::vector<PerformanceMap>& maps) {
  PerformanceMap exact{"distance_mm", "Body-garment distance", "mm", 0, kDistanceRange, {},
                       "distance"};
  PerformanceMap particle{"distance_particle_mm",
                          "Distance to nearest body particle",
                          "mm",
                          0,
                          kDistanceRange,
                          {},
                          "distance-particle",
                          false};
  for (const BodyPartner& partner : worn.partners) {
    exact.values.push_back(1000 * partner.exact.distance);
    particle.values.push_back(1000 * partner.particle_distance);
  }
  maps.push_back(std::move(exact));
  maps.push_back(std::move(particle));
}

void add_angular_deviation(const WornGarment& worn, std::vector<PerformanceMap>& maps) {
  PerformanceMap map{"angular_deviation_deg", "Angular deviation", "deg", 0, kDeviationRange, {},
                     "angular-deviation"};
  for (std::size_t v = 0; v < worn.partners.size(); ++v)
    map.values.push_back(angle_deg(worn.normals[v], worn.partners[v].normal));
  maps.push_back(std::move(map));
}

void add_pressure(const PressureField* field, std::vector<PerformanceMap>& maps) {
  if (!field || field->empty())
    throw InvalidInput(
        "the drape does not know the forces of its contact, which the map "
        "'pressure' is made of",
        "it was made by an earlier version: make it again");
  constexpr double kTop = kPressureClasses[std::size(kPressureClasses) - 1] / 1000;
  // Below the classes, one more step for cloth that only hangs or clings: it must not look like
  // cloth that does not touch.
  std::vector<double> breaks = {0, 0.05};
  for (double bound : kPressureClasses) breaks.push_back(bound / 1000);
  PerformanceMap contact{"pressure_kPa", "Contact pressure", "kPa", 0, kTop, {}, "pressure"};
  PerformanceMap membrane{"pressure_membrane_kPa",
                          "Contact pressure from tension and curvature",
                          "kPa",
                          0,
                          kTop,
                          {},
                          "pressure-membrane",
                          false};
  PerformanceMap difference{"pressure_difference_kPa",
                            "Pressure by tension and curvature minus contact pressure",
                            "kPa",
                            -kPressureGap,
                            kPressureGap,
                            {},
                            "pressure-difference",
                            false,
                            true};
  contact.breaks = membrane.breaks = breaks;
  for (std::size_t v = 0; v < field->contact.size(); ++v) {
    contact.values.push_back(field->contact[v] / 1000);
    membrane.values.push_back(field->membrane[v] / 1000);
    difference.values.push_back((field->membrane[v] - field->contact[v]) / 1000);
  }
  maps.push_back(std::move(contact));
  maps.push_back(std::move(membrane));
  maps.push_back(std::move(difference));
}
void add_all(std::vector<PerformanceMap> more, std::vector<PerformanceMap>& maps) {
  for (PerformanceMap& map : more) maps.push_back(std::move(map));
}

void add_gap(const WornGarment& worn, const Material* material, std::vector<PerformanceMap>& maps) {
  if (!material)
    throw InvalidInput(
        "the map 'gap' needs the material: the gap begins at the cloth's inner face");
  add_all(gap_maps(worn, *material), maps);
}
}  // namespace

const std::vector<std::string>& map_names() {
  static const std::vector<std::string> names = {"strain",   "distance",    "angular-deviation",
                                                 "pressure", "orientation", "gap"};
  return names;
}

const std::vector<std::string>& default_map_names() {
  static const std::vector<std::string> names(map_names().begin(), map_names().begin() + 3);
  return names;
}

double angle_deg(const Vec3& a, const Vec3& b) {
  return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

void require_settled(const Certificate& c) {
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

std::vector<PerformanceMap> compute_maps(const Garment& garment, const Drape& drape,
                                         const WornGarment& worn,
                                         const std::vector<std::string>& names,
                                         const MapOptions& options) {
  for (const std::string& name : names)
    if (std::find(map_names().begin(), map_names().end(), name) == map_names().end())
      throw InvalidInput("unknown map '" + printable(name) + "'", did_you_mean(name, map_names()));
  if (!options.allow_unsettled) require_settled(drape.certificate);

  const auto asked = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<PerformanceMap> maps;
  if (asked("strain")) add_strain(garment, drape, maps);
  if (asked("distance")) add_distance(worn, maps);
  if (asked("angular-deviation")) add_angular_deviation(worn, maps);
  if (asked("pressure")) add_pressure(options.pressure, maps);
  if (asked("orientation")) add_all(orientation_maps(garment, drape.positions, worn), maps);
  if (asked("gap")) add_gap(worn, options.material, maps);
  return maps;
}

std::vector<PerformanceMap> compute_maps(const Garment& garment, const Drape& drape,
                                         const Body& body, const std::vector<std::string>& names,
                                         const MapOptions& options) {
  if (!options.allow_unsettled) require_settled(drape.certificate);
  return compute_maps(garment, drape, relate(garment, drape.positions, body), names, options);
}

}  // namespace loosefit
