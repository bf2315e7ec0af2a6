#include "loosefit/report/slip_arrows.h"

#include <cmath>
#include <set>
#include <tuple>

#include "loosefit/body/body_frame.h"

namespace loosefit::report {

SlipArrows slip_arrows(const garment::Garment& garment, const maps::DressedState& reference,
                       const maps::DressedState& now, double spacing, double least) {
  maps::require_fit(garment, reference);
  maps::require_fit(garment, now);
  body::require_same_wearer(reference.body, now.body);
  // One vertex per square of the flat pattern, the first that falls into it.
  std::set<std::tuple<int, long, long>> taken;
  const std::vector<body::SkinPoint> partners = maps::skin_partners(reference);
  SlipArrows arrows;
  for (int v = 0; v < garment.vertex_count; ++v) {
    const Vec2 square = (garment.vertex_uv[v] / spacing).array().floor();
    if (!taken.emplace(garment.vertex_panel[v], std::lround(square.x()), std::lround(square.y()))
             .second)
      continue;
    Vec3 change = maps::offset_on_skin(partners[v], now.body, now.positions[v]) -
                  maps::offset_on_skin(partners[v], reference.body, reference.positions[v]);
    change.z() = 0;
    if (change.norm() < least) continue;
    const Vec3 slip = body::frame_of(partners[v], now.body).axes * change;
    arrows.from.push_back(now.positions[v] - slip);
    arrows.to.push_back(now.positions[v]);
  }
  return arrows;
}

}  // namespace loosefit::report
