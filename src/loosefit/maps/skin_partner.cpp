#include "loosefit/maps/skin_partner.h"

#include <cmath>
#include <limits>
#include <string>

#include "loosefit/base/error.h"

namespace loosefit::maps {

std::vector<body::SkinPoint> skin_partners(const DressedState& reference) {
  const std::vector<Vec3>& axes = reference.body.axes();
  std::vector<body::SkinPoint> partners;
  partners.reserve(reference.worn.partners.size());
  for (const body::BodyPartner& partner : reference.worn.partners)
    partners.push_back(body::skin_point(reference.body, axes, partner.exact));
  return partners;
}

Vec3 offset_on_skin(const body::SkinPoint& partner, const body::Body& body, const Vec3& position) {
  return body::frame_of(partner, body).axes.transpose() *
         (position - body::position_of(partner, body));
}

Slip slip_of(const Vec3& change, bool has_direction) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!has_direction) return {kNan, kNan, change.head<2>().norm()};
  return {change.x(), change.y(), change.head<2>().norm()};
}

void require_fit(const garment::Garment& garment, const DressedState& state) {
  const auto n = static_cast<std::size_t>(garment.vertex_count);
  if (state.positions.size() == n && state.worn.partners.size() == n) return;
  throw InvalidInput("a dressed state: found " + std::to_string(state.positions.size()) +
                     " positions and " + std::to_string(state.worn.partners.size()) +
                     " partners, expected " + std::to_string(n) + ", as many as garment vertices");
}

std::vector<Slip> vertex_slips(const garment::Garment& garment, const DressedState& reference,
                               const DressedState& now) {
  require_fit(garment, reference);
  require_fit(garment, now);
  body::require_same_wearer(reference.body, now.body);
  const std::vector<body::SkinPoint> partners = skin_partners(reference);
  std::vector<Slip> slips;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    const Vec3 change = offset_on_skin(partners[v], now.body, now.positions[v]) -
                        offset_on_skin(partners[v], reference.body, reference.positions[v]);
    slips.push_back(slip_of(change, partners[v].has_direction));
  }
  return slips;
}

}  // namespace loosefit::maps
