#include "loosefit/placement/site_points.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/stumps.h"
#include "loosefit/placement/ray.h"

namespace loosefit::placement {
namespace {

constexpr double kElectrodeRadius = 0.010;  // [m] (docs/theory/sensor_metrics.md 1)

/// How to find a preset that is no landmark: empty when the body lacks what it needs.
using Locator = std::function<std::optional<Vec3>(const BodyAddresses&)>;

std::optional<Vec3> place(const std::map<std::string, Vec3>& of, const std::string& name) {
  const auto found = of.find(name);
  return found == of.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

Locator at_landmark(const std::string& landmark) {
  return [=](const BodyAddresses& addresses) { return place(addresses.landmarks(), landmark); };
}

/// Seen from the middle of the trunk at the height of a landmark, `right` and `front` as told.
Locator on_trunk(const std::string& landmark, double right, double front) {
  return [=](const BodyAddresses& addresses) -> std::optional<Vec3> {
    const auto at = place(addresses.landmarks(), landmark);
    const auto trunk = trunk_axes(addresses.body());
    if (!at || !trunk) return std::nullopt;
    return ray_exit(addresses.body().surface, trunk->middle_at(*at),
                    right * trunk->right + front * trunk->front);
  };
}

Locator on_limb(BodySegment segment, int side, double x, double y, double z) {
  return [=](const BodyAddresses& addresses) -> std::optional<Vec3> {
    if (!addresses.axes(segment, side)) return std::nullopt;
    try {
      return addresses.skin({segment, side, Vec3(x, y, z)}).point;
    } catch (const InvalidInput&) {  // a body with joints but without that piece of skin
      return std::nullopt;
    }
  };
}

FootprintShape disc(double radius) {
  FootprintShape shape;
  shape.radius = radius;
  return shape;
}

FootprintShape girth() {
  FootprintShape shape;
  shape.kind = FootprintShape::Kind::girth;
  return shape;
}

struct Preset {
  std::string name;
  Locator locate = {};  ///< empty: the landmark of that name
  FootprintShape footprint = {};
};

std::vector<Preset> make_presets() {
  std::vector<Preset> presets;
  for (const char* name :
       {"upper_back", "mid_back", "lower_back", "scapula_L", "scapula_R", "sternum"})
    presets.push_back({name});
  presets.push_back({"heart", on_trunk("sternum", -0.35, 1)});
  for (const int side : {1, -1})
    presets.push_back({side > 0 ? "ecg_L" : "ecg_R", on_trunk("xiphoid", -0.5 * side, 1),
                       disc(kElectrodeRadius)});
  presets.push_back({"abdomen", on_trunk("back_waist", 0, 1)});
  presets.push_back({"waist_L", on_trunk("back_waist", -1, 0)});
  presets.push_back({"waist_R", on_trunk("back_waist", 1, 0)});
  presets.push_back({"chest_band", on_trunk("xiphoid", 0, 1), girth()});
  presets.push_back({"waist_band", on_trunk("front_waist", 0, 1), girth()});
  presets.push_back({"sacrum", at_landmark("psis")});
  // Seen from the limb's axis: from medial (0) to lateral (100), from behind (0) to the front.
  const auto both = [&](const char* name, BodySegment segment, double lateral, double front,
                        double z, FootprintShape footprint = {}) {
    for (const int side : {1, -1})
      presets.push_back({std::string(name) + (side > 0 ? "_L" : "_R"),
                         on_limb(segment, side, side > 0 ? 100 - lateral : lateral, front, z),
                         footprint});
  };
  both("upper_arm", BodySegment::upper_arm, 100, 50, 50);
  both("biceps", BodySegment::upper_arm, 50, 100, 100.0 / 3, disc(kElectrodeRadius));
  both("forearm", BodySegment::forearm, 100, 50, 50);
  both("forearm_distal", BodySegment::forearm, 100, 50, 30);
  both("wrist", BodySegment::forearm, 100, 50, 15);
  both("thigh", BodySegment::thigh, 100, 50, 50);
  both("quadriceps", BodySegment::thigh, 50, 100, 65, disc(kElectrodeRadius));
  both("hamstring", BodySegment::thigh, 75, 0, 45, disc(kElectrodeRadius));
  for (const std::string side : {"_L", "_R"})
    presets.push_back({"knee" + side, at_landmark("patella" + side)});
  both("calf", BodySegment::lower_leg, 25, 0, 70, disc(kElectrodeRadius));
  both("tibialis", BodySegment::lower_leg, 75, 100, 60, disc(kElectrodeRadius));
  both("shank", BodySegment::lower_leg, 100, 50, 20);
  return presets;
}

const std::vector<Preset>& all_presets() {
  static const std::vector<Preset> kPresets = make_presets();
  return kPresets;
}

}  // namespace

SitePoints::SitePoints(const body::Body& body) : addresses_(body) {}

std::optional<Vec3> SitePoints::find(const std::string& name) const {
  for (const Preset& preset : all_presets())
    if (preset.name == name && preset.locate) return preset.locate(addresses_);
  return place(addresses_.landmarks(), name);
}

std::vector<std::string> SitePoints::names() const {
  std::vector<std::string> names;
  for (const Preset& preset : all_presets())
    if (find(preset.name)) names.push_back(preset.name);
  for (const auto& [name, point] : addresses_.landmarks())
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

Vec3 SitePoints::at(const std::string& name) const {
  if (const auto point = find(name)) return *point;
  throw InvalidInput(
      InputPlace{"", 0, "landmark"}, '"' + printable(name) + '"',
      "a landmark or preset of this body" + body::ends_in_words(addresses_.body().joints),
      did_you_mean(name, names()));
}

std::vector<SiteSpec> SitePoints::presets() const {
  std::vector<SiteSpec> sites;
  for (const Preset& preset : all_presets()) {
    if (!find(preset.name)) continue;
    SiteSpec site;
    site.name = site.landmark = preset.name;
    site.footprint = preset.footprint;
    sites.push_back(site);
  }
  return sites;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : all_presets()) names.push_back(preset.name);
  return names;
}

std::optional<FootprintShape> preset_footprint(const std::string& name) {
  for (const Preset& preset : all_presets())
    if (preset.name == name) return preset.footprint;
  return std::nullopt;
}

}  // namespace loosefit::placement
