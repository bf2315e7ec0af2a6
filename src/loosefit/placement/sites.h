#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/attachment.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/maps/worn_garment.h"
#include "loosefit/placement/address.h"
#include "loosefit/placement/address_garment.h"
#include "loosefit/placement/footprint.h"
#include "loosefit/placement/metric_names.h"
#include "loosefit/placement/site_spec.h"

namespace loosefit::placement {

/// A place on the garment with what a sensor would meet there.
struct Site {
  std::string name;
  std::string panel;
  Vec2 at = Vec2::Zero();          ///< pattern coordinates [m]
  Vec3 position = Vec3::Zero();    ///< on the draped garment [m]
  Vec3 body_point = Vec3::Zero();  ///< the skin under it: its partner on the body [m]
  body::Region region = body::Region::chest;
  std::map<std::string, FootprintValue> map_values;  ///< by PerformanceMap::array
  GarmentPoint point = {};                           ///< the same as `panel` and `at`
  std::optional<BodyAddress> anatomy = {};           ///< of body_point; nothing without landmarks
  double angle = 0;                                  ///< of the sensor's axis [rad]
  FootprintShape shape = {};
  Footprint footprint = {};  ///< the cloth under the sensor
  /// Direction of the body segment's long axis (towards the trunk, on the trunk upwards) in the
  /// pattern, as `angle`; 0, the grain, where the body has no such axis [rad].
  double segment_angle = 0;
  bool preset = false;            ///< not asked for by name: one of SitePoints::presets
  std::string not_covering = {};  ///< why there is no skin under it (off_skin); empty: there is
  /// What its sensor meets, by metric_vocabulary(): of a case's site one entry per donning that
  /// counts, of a site in one state one entry. Empty where nobody has measured it.
  std::vector<MetricValues> samples = {};

  /// Median over the samples that know a metric.
  MetricValues metrics() const;
};

/// A place of the body that the garment does not cover.
struct UncoveredSite {
  std::string name;
  bool preset = false;
  std::string why;  ///< "the garment ends 243 mm away from it"
};

/// Finds each site on the draped garment and averages every map over its footprint. A landmark or
/// anatomical address goes to the garment point over it (GarmentOverSkin), then by the site's shift
/// along the cloth, which turns its angle along with it at seams. What the garment does not cover,
/// and what is shifted over its edge, goes into `uncovered`; without that a preset is left out, and
/// a wished one is an error, as one with a board always is. Every site has both addresses. Lines
/// are passed over. \throws InvalidInput with a key as check_sites: unknown
/// panel or landmark, point outside its panel, bad anatomical address, skin that the garment does
/// not cover (with the nearest place that it does); key `site[i].shift` over its edge.
std::vector<Site> find_sites(const garment::Garment& garment, const std::vector<Vec3>& positions,
                             const body::PosedBody& body, const maps::WornGarment& worn,
                             const std::vector<maps::PerformanceMap>& maps,
                             const std::vector<SiteSpec>& wished, bool with_presets = true,
                             std::vector<UncoveredSite>* uncovered = nullptr);

/// The same sensors in another drape of the same garment (other posture, repeat): pattern place and
/// footprint are kept, everything that depends on drape and body is made anew.
std::vector<Site> revisit_sites(const std::vector<Site>& sites, const garment::Garment& garment,
                                const std::vector<Vec3>& positions, const body::PosedBody& body,
                                const maps::WornGarment& worn,
                                const std::vector<maps::PerformanceMap>& maps);

/// What can be said of wished sites before the garment is draped: panel, place in it, landmark and
/// anatomical address. \throws InvalidInput with key `site[i].panel`, `.at`, `.landmark`,
/// `.segment`, `.side` or `.ratios`.
void check_sites(const garment::Garment& garment, const body::Body& body,
                 const std::vector<SiteSpec>& wished);

/// A site with `panel` and `at`, told by where its shift leads; its angle is that of the same axis
/// there. \throws InvalidInput as pattern_point; key "shift" over the edge.
SiteSpec without_shift(const SiteSpec& site, const garment::Garment& garment);

/// The boards of sites with a place in the pattern as attachments of the same name, disc or
/// rectangle as their footprint. \throws InvalidInput, key `site[i].footprint`, for a board under a
/// line; `site[i].board` for a site without a place in the pattern, or one that is shifted from it.
std::vector<garment::Attachment> site_boards(const std::vector<SiteSpec>& sites);

}  // namespace loosefit::placement
