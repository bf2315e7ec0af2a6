#pragma once
#include <string>
#include <variant>
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/maps/cloth_strain.h"
#include "loosefit/maps/orientation.h"
#include "loosefit/maps/orientation_error.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/skin_partner.h"
#include "loosefit/maps/strain.h"

namespace loosefit::maps {

/// The worn garment that maps are made of; only referred to.
struct MapInput {
  const garment::Garment& garment;
  const std::vector<Vec3>& positions;
  const WornGarment& worn;
  const fabric::Material* material = nullptr;
  const PressureField* pressure = nullptr;
  const DressedState* reference = nullptr;            ///< of maps over postures
  const std::vector<DressedState>* states = nullptr;  ///< in those postures; slip: one
};

/// The cloth over a place of the skin.
struct ClothOverSkin {
  const body::BodyPartner& partner;
  double distance;                   ///< of the smooth cloth to the partner [m]
  const Vec3& normal;                ///< of the cloth, unit
  const fabric::Material* material;  ///< null only where MapDefinition::needs_material is false
  double padding = 0;                ///< of boards on the inside there [m]
};

// How a quantity is read off the worn cloth, in SI units. The same function gives the value at a
// vertex and at a sample of a sensor's footprint.

/// Of the cloth of one triangle; `direction` is that of the sensor in the pattern (unit, weft and
/// warp), at a vertex the grain. At a vertex: mean over its triangles by flat area.
using ReadCloth = double (*)(const ClothStrain& cloth, const Vec2& direction);
/// Of one place and the skin under it.
using ReadOverSkin = double (*)(const ClothOverSkin& at);
/// Of a vertex field of the whole garment; at a sample linear over the triangle.
using ReadField = std::vector<double> (*)(const MapInput& input);
/// Of the cloth's orientation against the body: at a vertex, or of a footprint as a rigid piece.
using ReadOrientation = double (*)(const Orientation& orientation);
/// Of the slip since the reference posture: of a vertex, or of a footprint's mean.
using ReadSlip = double (*)(const Slip& slip);
/// Of the calibrated orientation error over postures: of a vertex, or of a footprint.
using ReadError = double (*)(const ErrorSummary& error);
using MapReading =
    std::variant<ReadCloth, ReadOverSkin, ReadField, ReadOrientation, ReadSlip, ReadError>;

/// How the samples under a sensor become one number of one state.
enum class OverFootprint {
  mean,     ///< area mean
  highest,  ///< the 5 % of the footprint that are highest start here
  rigid,    ///< the footprint counts as one rigid piece (MapArray::rigid)
};

/// How the numbers of all states become one metric of a site (placement/site_metrics.h).
enum class OverStates {
  reference,        ///< mean over donnings in the reference posture
  reference_angle,  ///< the same, as a mean direction: −179° and 179° make 180°
  mean,
  least,
  greatest,
  swing,            ///< range over the postures of a donning, mean over donnings
  least_posture,    ///< least, where a donning has several postures
  contact_duty,     ///< share of states above kInContact, where a donning has several postures
  greatest_change,  ///< greatest over all states but the references
  error_rms,        ///< of all states but the references, each against its own reference
  error_p95,
  error_of_donnings,  ///< RMS over pairs of donnings, in the reference posture
  /// Of the state with the greatest error the turn about one axis of the sensor, with its sign.
  turn_across,
  turn_along,
  turn_normal,
};

/// A metric by which a site is judged, made of one array; its unit is the array's.
struct SiteMetric {
  std::string name;   ///< "gap_worst_mm"
  std::string words;  ///< "gap to the skin, worst 5 % of the footprint"
  OverFootprint footprint = OverFootprint::mean;
  OverStates states = OverStates::mean;
  /// With OverFootprint::rigid: read in place of MapArray::rigid; null for that one.
  ReadOrientation rigid = nullptr;
};

/// One array of a map and all that is known of it.
struct MapArray {
  MapArrayStyle style;
  std::string meaning;  ///< what it is, a sentence or more
  std::string formula = {};
  std::string source = {};  ///< author and year, or the page of docs/theory
  MapReading read;
  /// SI value → unit of the array.
  double (*in_unit)(double) = [](double value) { return value; };
  /// Of a footprint as one rigid piece; null where that has no meaning.
  ReadOrientation rigid = nullptr;
  /// The value depends on the sensor's direction: samples on other panels, where that direction is
  /// not known, do not count.
  bool along_sensor = false;
  std::vector<SiteMetric> metrics = {};
};

/// A sensor performance map: what a user asks for by name, and the arrays that it makes.
struct MapDefinition {
  std::string name;  ///< user's word: "strain"
  std::vector<MapArray> arrays;
  bool by_default = false;      ///< made when nothing is asked for
  bool needs_material = false;  ///< the law of the cloth, or its thickness
  bool needs_forces = false;    ///< contact forces of the drape
  bool needs_postures = false;  ///< made of several postures, not asked for by name
  bool needs_ease = false;      ///< girths of a draft; not made of garments without them
  std::string made_with = {};   ///< the map that asks for this one, too; "": only its own name
};

// Values of MapArray::in_unit.
inline double millimetres(double metres) { return 1000 * metres; }
inline double kilopascals(double pascals) { return pascals / 1000; }
inline double in_degrees(double angle) { return degrees(angle); }

}  // namespace loosefit::maps
