#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit {

/// Where a sensor is wanted: a place in the pattern, or a body landmark or preset by name.
struct SiteSpec {
  std::string name;
  std::string panel;       ///< with `at`; empty for a landmark
  Vec2 at = Vec2::Zero();  ///< u (weft), v (warp) in the panel [m]
  std::string landmark;    ///< any of site_landmarks(body)
};

/// A map's values in a sensor's footprint.
struct FootprintValue {
  double mean = 0;   ///< area mean over the disc
  double worst = 0;  ///< the 5 % of the disc's area that are highest start here
};

/// A place on the garment with what a sensor would meet there.
struct Site {
  std::string name;
  std::string panel;
  Vec2 at = Vec2::Zero();          ///< pattern coordinates [m]
  Vec3 position = Vec3::Zero();    ///< on the draped garment [m]
  Vec3 body_point = Vec3::Zero();  ///< its partner on the body [m]
  Region region = Region::chest;
  std::map<std::string, FootprintValue> values;  ///< by PerformanceMap::array
};

/// Radius over which a sensor averages: an IMU board [m] (sensor-metrics, section 1).
inline constexpr double kFootprintRadius = 0.012;

/// Names a SiteSpec may use on this body: its landmarks and the presets below.
std::vector<std::string> site_landmarks(const Body& body);

/// Surface point of a landmark or preset. Presets beyond the landmarks lie where a ray from the
/// limb's or trunk's axis leaves the body: upper_arm_L/R (lateral, half way), forearm_L/R and
/// wrist_L/R (outer, 50 and 85 %), heart (left of the breast bone), ecg_L/R (under the breast),
/// abdomen, waist_L/R.
/// \throws InvalidInput for an unknown name, with a did-you-mean.
Vec3 site_point(const Body& body, const std::string& landmark);

/// The presets that this body has: upper_back, mid_back, lower_back, scapula_L/R, sternum, heart,
/// ecg_L/R, abdomen, waist_L/R, upper_arm_L/R, forearm_L/R, wrist_L/R.
std::vector<SiteSpec> preset_sites(const Body& body);

/// Finds each site on the draped garment and averages every map over a disc of `radius` on the
/// cloth. A landmark goes to the nearest garment point that faces the same way; a preset site that
/// the garment does not cover (farther than kCoverReach) is left out, a wished one is an error.
/// \throws InvalidInput naming the site: unknown panel or landmark, point outside its panel,
/// landmark that the garment does not cover.
std::vector<Site> find_sites(const Garment& garment, const std::vector<Vec3>& positions,
                             const Body& body, const WornGarment& worn,
                             const std::vector<PerformanceMap>& maps,
                             const std::vector<SiteSpec>& wished, bool with_presets = true,
                             double radius = kFootprintRadius);

/// What can be said of wished sites before the garment is draped: panel, place in it and landmark.
/// \throws InvalidInput with key `site[i].panel`, `site[i].at` or `site[i].landmark`.
void check_sites(const Garment& garment, const Body& body, const std::vector<SiteSpec>& wished);

inline constexpr double kCoverReach = 0.15;  ///< [m]

}  // namespace loosefit
