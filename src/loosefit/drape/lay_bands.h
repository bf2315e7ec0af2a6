#pragma once
#include <map>
#include <vector>

#include "loosefit/drape/band_ring.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/panel_roles.h"

namespace loosefit::drape {

/// The middle of the trunk: from the hips over the neck.
Polyline trunk_line(const LimbLines& lines);

/// The bands in one piece of a garment, by panel of open.garment. A tube that is sewn to the trunk
/// along an armhole is a sleeve, not a band, unless it is narrow.
std::map<int, BandRing> find_bands(const garment::OpenSeams& open,
                                   const std::vector<PanelRole>& roles);

/// Lays them as rings round the limb of what they are sewn to, one after the other, since a band
/// may be sewn to a band: round the arm, round the leg where all that they are sewn to is of one,
/// else round the trunk from the hips over the neck.
/// \param leg of each panel: +1 left, −1 right, 0 across the middle; empty for a garment without
///        legs \param x vertices of open.garment, those of all other panels arranged [m]
void lay_bands(const garment::OpenSeams& open, const std::map<int, BandRing>& bands,
               const std::vector<PanelRole>& roles, const std::vector<int>& leg,
               const body::PosedBody& body, std::vector<Vec3>& x);

}  // namespace loosefit::drape
