#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/address.h"
#include "loosefit/placement/site_spec.h"

namespace loosefit::placement {

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
/// | sacrum                  | middle of the PSIS, for an IMU of the pelvis                     |
/// | thigh_L/R, shank_L/R    | lateral, half way, and 20 % from the ankle (UNISEP's IMU)        |
/// | quadriceps_L/R          | front of the thigh, 65 % from the knee joint (disc of 10 mm)     |
/// | hamstring_L/R           | back of the thigh, lateral, 45 % (disc of 10 mm)                 |
/// | knee_L/R                | patella                                                          |
/// | calf_L/R                | back, medial, 70 % from the ankle (disc of 10 mm)                |
/// | tibialis_L/R            | front, lateral, 60 % from the ankle (disc of 10 mm)              |
///
/// Muscles of the leg as in SENIAM (Hermens et al. 2000): rectus femoris half way from ASIS to
/// patella, biceps femoris half way from the ischial tuberosity to the lateral epicondyle,
/// gastrocnemius medialis where it bulges most, tibialis anterior a third from the fibula's head
/// to the medial malleolus; in per cent of the limb, for the axes of an address.
class SitePoints {
 public:
  explicit SitePoints(const body::Body& body);
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

/// Names of all presets, whichever of them a body has.
std::vector<std::string> preset_names();

/// Footprint of the sensor that a preset is made for; nothing for other names. Body-independent.
std::optional<FootprintShape> preset_footprint(const std::string& name);

}  // namespace loosefit::placement
