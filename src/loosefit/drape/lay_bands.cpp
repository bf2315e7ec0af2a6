#include "loosefit/drape/lay_bands.h"

#include <algorithm>
#include <set>

#include "loosefit/drape/limb_lines.h"

namespace loosefit::drape {
namespace {

Polyline limb_of(const BandRing& band, PanelRole role, const std::vector<int>& leg,
                 const LimbLines& lines) {
  // Limb lines begin in the chest, those of legs go through the hips.
  const auto beyond = [&](Limb limb, std::ptrdiff_t first) {
    return Polyline({lines[limb].begin() + first, lines[limb].end()});
  };
  if (role == PanelRole::left_arm) return beyond(kLeftArm, 1);
  if (role == PanelRole::right_arm) return beyond(kRightArm, 1);
  const auto all_of_leg = [&](int side) {
    return !leg.empty() && std::all_of(band.sewn_to().begin(), band.sewn_to().end(),
                                       [&](int k) { return leg[k] == side; });
  };
  if (all_of_leg(1)) return beyond(kLeftLeg, 2);
  if (all_of_leg(-1)) return beyond(kRightLeg, 2);
  return trunk_line(lines);
}

}  // namespace

Polyline trunk_line(const LimbLines& lines) {
  return Polyline({lines[kLeftLeg][1], lines[kHead][1], lines[kHead][2]});
}

std::map<int, BandRing> find_bands(const garment::OpenSeams& open,
                                   const std::vector<PanelRole>& roles) {
  std::map<int, BandRing> bands;
  for (std::size_t k = 0; k < roles.size(); ++k) {
    if (roles[k] == PanelRole::limb) continue;
    auto band = BandRing::find(open, static_cast<int>(k));
    if (!band) continue;
    const bool at_trunk = std::any_of(band->sewn_to().begin(), band->sewn_to().end(),
                                      [&](int o) { return roles[o] == PanelRole::trunk; });
    const bool sleeve = roles[k] != PanelRole::trunk && at_trunk && !band->is_narrow();
    if (!sleeve) bands.emplace(static_cast<int>(k), std::move(*band));
  }
  return bands;
}

void lay_bands(const garment::OpenSeams& open, const std::map<int, BandRing>& bands,
               const std::vector<PanelRole>& roles, const std::vector<int>& leg,
               const body::PosedBody& body, std::vector<Vec3>& x) {
  const LimbLines lines = limb_lines(body.body());
  std::set<int> waiting;
  for (const auto& [k, band] : bands) waiting.insert(k);
  for (bool laid = true; laid;) {
    laid = false;
    for (auto it = waiting.begin(); it != waiting.end();) {
      const BandRing& band = bands.at(*it);
      const bool ready = std::none_of(band.sewn_to().begin(), band.sewn_to().end(),
                                      [&](int k) { return waiting.count(k) > 0; });
      if (!ready) {
        ++it;
        continue;
      }
      band.place(open, limb_of(band, roles[*it], leg, lines), body, x);
      it = waiting.erase(it);
      laid = true;
    }
  }
}

}  // namespace loosefit::drape
