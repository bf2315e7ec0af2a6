#pragma once
#include <limits>
#include <map>
#include <vector>

#include "loosefit/body/body_partner.h"
#include "loosefit/body/posed_body.h"
#include "loosefit/maps/orientation.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/maps/skin_partner.h"
#include "loosefit/placement/catalogue_metrics.h"
#include "loosefit/placement/footprint.h"

namespace loosefit::placement {

/// The cloth under one sensor and the direction of the sensor's axis.
struct SensorPatch {
  Footprint footprint;          ///< the same patch of cloth in every state
  int panel = 0;                ///< that `direction` is meant in: the site's own
  Vec2 direction = Vec2(0, 1);  ///< unit, weft and warp
  /// Of a line through several panels (a girth): the direction in each sample's own panel, in place
  /// of `direction`. Empty otherwise.
  std::vector<Vec2> sample_directions;
};

/// A garment worn in one posture after one donning; all but the body is only referred to.
struct WornState {
  int posture = 0, donning = 0;  ///< indices of the study
  const std::vector<Vec3>& positions;
  body::PosedBody body;
  const maps::WornGarment& worn;
  const maps::PressureField* pressure = nullptr;  ///< null where the drape does not know its forces
};

/// What a sensor meets in one state. NaN: not known or not defined.
struct SiteState {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  int posture = 0, donning = 0;
  /// Mean frame [s a n] of the cloth in the footprint in space, the rotation that fits the frames
  /// of its parts best (Kabsch 1976); a is the image of the sensor's direction. NaN for a footprint
  /// without a common orientation, as one that goes round the body.
  Mat3 garment_frame = Mat3::Constant(kUnknown);
  /// Against the mean body frame under the footprint (closest points;
  /// docs/theory/sensor_metrics.md 3.2) [rad]. Without a segment axis there only the angular
  /// deviation is known.
  maps::Orientation orientation{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  /// Relative rotation R = F_bᵀ F_g with the frame of the skin that lay under the footprint in the
  /// reference state and has moved with the body since.
  Mat3 on_skin = Mat3::Constant(kUnknown);
  maps::Slip slip{kUnknown, kUnknown, kUnknown};  ///< of the footprint's mean against that skin [m]
  /// What the sensor reads of the arrays of the catalogue, in SI units, in the order of
  /// footprint_readings() (catalogue_metrics.h).
  std::vector<double> readings = {};
};

/// The skin under a sensor in its reference state: the partners of the footprint's samples.
struct SkinUnderSensor {
  const body::Body* body = nullptr;  ///< reference body
  std::vector<body::SkinPoint> points;
  std::vector<Vec3> offsets;   ///< of the cloth against them (offset_on_skin)
  bool has_direction = false;  ///< the frames carry the segment's long axis
};

/// Measures sensors in one state. Keeps references to everything the state refers to.
class StateMeter {
 public:
  StateMeter(const garment::Garment& garment, const fabric::Material& material,
             const WornState& state);
  const WornState& state() const { return state_; }

  /// What lies under the sensor now, to be the reference of other states.
  SkinUnderSensor skin_under(const SensorPatch& patch) const;

  /// All of SiteState; what needs a reference only with one, for which this state may itself serve.
  /// \throws InvalidInput when the reference is of another wearer or another footprint.
  SiteState measure(const SensorPatch& patch, const SkinUnderSensor* reference = nullptr) const;

 private:
  struct Sample;
  std::vector<Sample> sampled(const SensorPatch& patch) const;
  Mat3 cloth_frame(const SensorPatch& patch, const std::vector<Sample>& samples) const;
  void add_orientation(const std::vector<Sample>& samples, SiteState& site) const;
  void add_change(const SkinUnderSensor& reference, const std::vector<Sample>& samples,
                  SiteState& site) const;
  void add_readings(const SensorPatch& patch, const std::vector<Sample>& samples,
                    SiteState& site) const;
  std::vector<double> sample_values(const maps::MapArray& array, const SensorPatch& patch,
                                    const std::vector<Sample>& samples) const;

  const garment::Garment& garment_;
  fabric::Material material_;
  WornState state_;
  std::vector<maps::ClothStrain> strains_;  ///< of every triangle
  /// Vertex fields [SI] of those arrays that are read of the whole garment, as far as known.
  std::map<const maps::MapArray*, std::vector<double>> fields_;
};

}  // namespace loosefit::placement
