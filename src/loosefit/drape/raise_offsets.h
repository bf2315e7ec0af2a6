#pragma once
#include <map>
#include <set>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// Triangles of the cloth at x that cut the skin, by the exact test.
std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x);

/// Holds off the skin what still cuts it although its contact points see the skin exactly
/// (drape/refine_contact.h): the layer is squeezed through, or the skin reaches in between points.
/// All contact points of such a triangle rest farther off by what it lacks of clearing the skin,
/// more so each time; so do those of triangles that are about to cut, or each round would find
/// neighbours. No farther than the field is smooth. times_cut counts per triangle over the rounds.
void raise_offsets_at_penetrations(ClothModel& model, const ContactBody& body,
                                   const std::vector<Vec3>& x, const std::set<int>& penetrating,
                                   std::map<int, int>& times_cut, const PenetrationTuning& tuning);

}  // namespace loosefit::drape
