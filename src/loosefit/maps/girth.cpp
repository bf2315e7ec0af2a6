#include "loosefit/maps/girth.h"

#include <algorithm>
#include <limits>

#include "loosefit/base/error.h"

namespace loosefit::maps {

double GarmentGirth::hoop_strain() const {
  return flat > 0 ? draped / flat - 1 : std::numeric_limits<double>::quiet_NaN();
}

GarmentGirth torso_girth(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const WornGarment& worn, double level) {
  GarmentGirth girth{level};
  if (std::ranges::count(worn.panel_part, body::BodyPart::trunk_and_arms) > 0) return girth;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (worn.panel_part[garment.triangle_panel[t]] != body::BodyPart::trunk) continue;
    // A corner exactly on the plane counts as above: every triangle is cut in two edges or none.
    std::vector<Vec3> space;
    std::vector<Vec2> flat;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const Vec3 &a = positions[garment.triangles[t][k]],
                 &b = positions[garment.triangles[t][next]];
      if ((a.z() >= level) == (b.z() >= level)) continue;
      const double share = (level - a.z()) / (b.z() - a.z());
      const Vec2 &ua = garment.triangle_uv[t][k], &ub = garment.triangle_uv[t][next];
      space.push_back(a + share * (b - a));
      flat.push_back(ua + share * (ub - ua));
    }
    if (space.size() != 2) continue;
    girth.draped += (space[1] - space[0]).norm();
    girth.flat += (flat[1] - flat[0]).norm();
  }
  return girth;
}

double chest_height(const body::Body& body) {
  // The breast bone's landmark stands at chest level and moves with the posture.
  if (const auto sternum = body.landmarks.find("sternum"); sternum != body.landmarks.end())
    return sternum->second.z();
  if (const auto level = body.measured.find("chest_level"); level != body.measured.end())
    return level->second;
  throw InvalidInput("the body has no chest level, so no garment girth can be taken there");
}

}  // namespace loosefit::maps
