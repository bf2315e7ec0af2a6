#include "loosefit/body/floor_under.h"

#include <algorithm>

namespace loosefit::body {

std::optional<double> floor_under(const Body& body) {
  const auto& skin = body.surface.vertices;
  const auto& joints = body.joints;
  if (skin.empty() || body.segment.size() != skin.size()) return {};
  for (const char* name : {"neck", "ankle_L", "ankle_R"})
    if (!joints.count(name)) return {};
  const auto lowest = std::min_element(skin.begin(), skin.end(),
                                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  if (body.segment[lowest - skin.begin()] != Segment::foot) return {};
  const double ankles = std::max(joints.at("ankle_L").z(), joints.at("ankle_R").z());
  if (!(joints.at("neck").z() > ankles)) return {};
  return lowest->z();
}

}  // namespace loosefit::body
