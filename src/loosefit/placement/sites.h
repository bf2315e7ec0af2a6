#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/garment/attachment.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/worn_garment.h"
#include "loosefit/placement/address.h"
#include "loosefit/placement/address_garment.h"
#include "loosefit/placement/footprint.h"

namespace loosefit {

/// The sensor as a part of the garment: what lies under a disc or rectangle footprint.
struct SensorBoard {
  double mass = 0;              ///< [kg]
  double bending = 1e-3;        ///< rigidity added [N m]
  double membrane_factor = 10;  ///< in-plane stiffness multiplier, ≥ 1
};

/// Where a sensor is wanted, in one of three ways: a place in the pattern, a body landmark or
/// preset by name, or an anatomical address; and what it is.
struct SiteSpec {
  std::string name;
  std::string panel;                        ///< with `at`; wins over the other two
  Vec2 at = Vec2::Zero();                   ///< u (weft), v (warp) in the panel [m]
  std::string landmark = {};                ///< any of SitePoints::names
  std::optional<BodyAddress> anatomy = {};  ///< when neither panel nor landmark is given
  double angle = 0;  ///< of the sensor's axis in the pattern (FootprintShape)
  FootprintShape footprint = {};
  std::optional<SensorBoard> board = {};  ///< simulated as a stiff part
};

/// A place on the garment with what a sensor would meet there.
struct Site {
  std::string name;
  std::string panel;
  Vec2 at = Vec2::Zero();          ///< pattern coordinates [m]
  Vec3 position = Vec3::Zero();    ///< on the draped garment [m]
  Vec3 body_point = Vec3::Zero();  ///< the skin under it: its partner on the body [m]
  Region region = Region::chest;
  std::map<std::string, FootprintValue> values;  ///< by PerformanceMap::array
  GarmentPoint point = {};                       ///< the same as `panel` and `at`
  std::optional<BodyAddress> anatomy = {};       ///< of body_point; nothing without landmarks
  double angle = 0;                              ///< of the sensor's axis [rad]
  FootprintShape shape = {};
  Footprint footprint = {};  ///< the cloth under the sensor
  /// Direction of the body segment's long axis (towards the trunk, on the trunk upwards) in the
  /// pattern, as `angle`; 0, the grain, where the body has no such axis [rad].
  double segment_angle = 0;
  bool preset = false;            ///< not asked for by name: one of SitePoints::presets
  std::string not_covering = {};  ///< why there is no skin under it (off_skin); empty: there is
};

/// A place of the body that the garment does not cover.
struct UncoveredSite {
  std::string name;
  bool preset = false;
  std::string why;  ///< "the garment ends 243 mm away from it"
};

/// Named points of one body: its landmarks, those of address_landmarks(), and presets. Keeps a
/// reference to the body.
///
/// Presets: upper_back (T3), mid_back (T8), lower_back (L3), scapula_L/R, sternum, which are
/// landmarks, and those below, which lie where a ray from the limb's or trunk's axis leaves the
/// body, or at an anatomical address. A body has those whose parts it has.
///
/// | preset                  | where                                                            |
/// |-------------------------|------------------------------------------------------------------|
/// | heart                   | breast level, left of the breast bone                            |
/// | ecg_L/R                 | under the breast, half way to the side (disc of 10 mm)           |
/// | abdomen                 | front, waist level                                               |
/// | waist_L/R               | lateral, waist level                                             |
/// | chest_band, waist_band  | girth lines at the xiphoid and at the navel, for respiration     |
/// | upper_arm_L/R           | lateral, half way                                                |
/// | biceps_L/R              | front, a third from the cubital fossa (SENIAM; disc of 10 mm)    |
/// | forearm_L/R             | back of the forearm, half way                                    |
/// | forearm_distal_L/R      | back of the forearm, 30 % from the wrist (UNISEP's IMU)          |
/// | wrist_L/R               | back of the forearm, 15 % from the wrist                         |
/// | thigh_L/R, shank_L/R    | lateral, half way, and 20 % from the ankle (UNISEP's IMU)        |
class SitePoints {
 public:
  explicit SitePoints(const Body& body);
  /// Names that `at` knows: presets that this body has, then landmarks.
  std::vector<std::string> names() const;
  /// Surface point. Presets win over landmarks of the same name: the wrist of a sensor is above the
  /// bone. \throws InvalidInput, key "landmark", for an unknown name, with a did-you-mean.
  Vec3 at(const std::string& name) const;
  /// The presets that this body has, each with the footprint of its sensor.
  std::vector<SiteSpec> presets() const;
  const BodyAddresses& addresses() const { return addresses_; }

 private:
  std::optional<Vec3> find(const std::string& name) const;
  BodyAddresses addresses_;
};

/// Footprint of the sensor that a preset is made for; nothing for other names. Body-independent.
std::optional<FootprintShape> preset_footprint(const std::string& name);

/// Finds each site on the draped garment and averages every map over its footprint. A landmark or
/// anatomical address goes to the garment point over it (GarmentOverSkin). What the garment does
/// not cover goes into `uncovered`; without that a preset is left out, and a wished one is an
/// error. Every site has both addresses. \throws InvalidInput with a key as check_sites: unknown
/// panel or landmark, point outside its panel, bad anatomical address, skin that the garment does
/// not cover (with the nearest place that it does).
std::vector<Site> find_sites(const Garment& garment, const std::vector<Vec3>& positions,
                             const Body& body, const WornGarment& worn,
                             const std::vector<PerformanceMap>& maps,
                             const std::vector<SiteSpec>& wished, bool with_presets = true,
                             std::vector<UncoveredSite>* uncovered = nullptr);

/// The same sensors in another drape of the same garment (other posture, repeat): pattern place and
/// footprint are kept, everything that depends on drape and body is made anew.
std::vector<Site> revisit_sites(const std::vector<Site>& sites, const Garment& garment,
                                const std::vector<Vec3>& positions, const Body& body,
                                const WornGarment& worn, const std::vector<PerformanceMap>& maps);

/// What can be said of wished sites before the garment is draped: panel, place in it, landmark and
/// anatomical address. \throws InvalidInput with key `site[i].panel`, `.at`, `.landmark`,
/// `.segment`, `.side` or `.ratios`.
void check_sites(const Garment& garment, const Body& body, const std::vector<SiteSpec>& wished);

/// The boards of sites with a place in the pattern as attachments of the same name, disc or
/// rectangle as their footprint. \throws InvalidInput, key `site[i].footprint`, for a board under a
/// line; `site[i].board` for a site without a place in the pattern.
std::vector<Attachment> site_boards(const std::vector<SiteSpec>& sites);

}  // namespace loosefit
