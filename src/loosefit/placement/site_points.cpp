#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/placement/ray.h"
#include "loosefit/placement/sites.h"

namespace loosefit {
namespace {

/// A preset that is no landmark: how to find it, empty when the body lacks what it needs.
using Locator = std::function<std::optional<Vec3>(const Body&)>;

std::optional<Vec3> place(const std::map<std::string, Vec3>& of, const std::string& name) {
  const auto found = of.find(name);
  return found == of.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

/// Outer side of a limb, `share` of the way between two joints.
Locator on_limb(const std::string& from, const std::string& to, double share, double side) {
  return [=](const Body& body) -> std::optional<Vec3> {
    const auto a = place(body.joints, from), b = place(body.joints, to);
    if (!a || !b) return std::nullopt;
    const Vec3 along = (*b - *a).normalized(), outward(side, 0, 0);
    return ray_exit(body.surface, *a + share * (*b - *a), outward - outward.dot(along) * along);
  };
}

/// On the trunk at the height of a landmark moved by `lift`, seen from the trunk's middle there in
/// the direction (side, −front).
Locator on_trunk(const std::string& landmark, double lift, double side, double front) {
  return [=](const Body& body) -> std::optional<Vec3> {
    const auto at = place(body.landmarks, landmark), back = place(body.landmarks, "back_waist");
    const auto breast = place(body.landmarks, "sternum");
    if (!at || !back || !breast) return std::nullopt;
    const Vec3 middle(0, 0.5 * (back->y() + breast->y()), at->z() + lift);
    return ray_exit(body.surface, middle, Vec3(side, -front, 0));
  };
}

const std::map<std::string, Locator>& locators() {
  static const std::map<std::string, Locator> all = [] {
    std::map<std::string, Locator> l;
    for (const double side : {1.0, -1.0}) {
      const std::string s = side > 0 ? "_L" : "_R";
      l["upper_arm" + s] = on_limb("shoulder" + s, "elbow" + s, 0.5, side);
      l["forearm" + s] = on_limb("elbow" + s, "wrist" + s, 0.5, side);
      l["wrist" + s] = on_limb("elbow" + s, "wrist" + s, 0.85, side);
      l["ecg" + s] = on_trunk("sternum", -0.06, 0.5 * side, 1);
      l["waist" + s] = on_trunk("back_waist", 0, side, 0);
    }
    l["heart"] = on_trunk("sternum", 0, 0.35, 1);
    l["abdomen"] = on_trunk("back_waist", -0.02, 0, 1);
    return l;
  }();
  return all;
}

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = {
      "upper_back",  "mid_back",    "lower_back", "scapula_L", "scapula_R", "sternum",
      "heart",       "ecg_L",       "ecg_R",      "abdomen",   "waist_L",   "waist_R",
      "upper_arm_L", "upper_arm_R", "forearm_L",  "forearm_R", "wrist_L",   "wrist_R"};
  return names;
}

/// Presets win over landmarks of the same name: the wrist of a sensor is above the bone.
std::optional<Vec3> find_point(const Body& body, const std::string& name) {
  const auto locator = locators().find(name);
  return locator != locators().end() ? locator->second(body) : place(body.landmarks, name);
}

}  // namespace

std::vector<std::string> site_landmarks(const Body& body) {
  std::vector<std::string> names;
  for (const std::string& preset : preset_names())
    if (find_point(body, preset)) names.push_back(preset);
  for (const auto& [name, point] : body.landmarks)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

Vec3 site_point(const Body& body, const std::string& landmark) {
  if (const auto point = find_point(body, landmark)) return *point;
  throw InvalidInput("unknown landmark '" + printable(landmark) + "'",
                     did_you_mean(landmark, site_landmarks(body)));
}

std::vector<SiteSpec> preset_sites(const Body& body) {
  std::vector<SiteSpec> sites;
  for (const std::string& preset : preset_names())
    if (find_point(body, preset)) sites.push_back({preset, "", Vec2::Zero(), preset});
  return sites;
}

}  // namespace loosefit
