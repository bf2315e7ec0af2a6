#include "loosefit/drape/cleft_cover.h"

#include <cmath>

#include "loosefit/geometry/convex_hull.h"

namespace loosefit::drape {
namespace {

constexpr double kNarrow = 0.008;               ///< width of a cleft [m]
constexpr double kBelow = 0.15, kAbove = 0.05;  ///< of the crotch, where it is looked for [m]
constexpr double kAside = 0.06, kBeforeBehind = 0.15;
/// It reaches into the flesh [m], so that nothing between its surface and the skin counts as free.
constexpr double kInside = 0.02;
constexpr int kFew = 16;  ///< points that make no cleft yet

}  // namespace

geometry::TriangleMesh cleft_cover(const body::PosedBody& body) {
  const auto crotch = body->landmarks.find("crotch");
  if (crotch == body->landmarks.end()) return {};
  const auto& skin = body->surface.vertices;
  if (body->normals.size() != skin.size()) return {};
  std::vector<Vec3> sides;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Vec3 off = skin[i] - crotch->second;
    if (std::abs(off.x()) > kAside || std::abs(off.y()) > kBeforeBehind || off.z() > kAbove ||
        off.z() < -kBelow)
      continue;
    // Half of the cleft away from the skin there is other skin nearer than that.
    if (body.tree().signed_distance(skin[i] + kNarrow / 2 * body->normals[i]) < kNarrow / 4)
      for (const double depth : {0.0, kInside})
        sides.emplace_back(skin[i] - depth * body->normals[i]);
  }
  if (static_cast<int>(sides.size()) < kFew) return {};
  return geometry::convex_hull(sides);
}

}  // namespace loosefit::drape
