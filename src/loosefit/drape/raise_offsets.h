#pragma once
#include <map>
#include <set>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// Triangles of the cloth at x that cut the skin, by the exact test.
std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x);

/// The last resort for triangles that still cut the skin where contact sees it exactly
/// (drape/refine_contact.h), as between folds of skin that leave no room: all their contact points
/// are held off farther than half the thickness, more so each time, up to `farthest` [m] from the
/// skin. times_cut counts per triangle over the rounds.
void raise_offsets_at_penetrations(ClothModel& model, double farthest,
                                   const std::set<int>& penetrating, std::map<int, int>& times_cut,
                                   const PenetrationTuning& tuning);

}  // namespace loosefit::drape
