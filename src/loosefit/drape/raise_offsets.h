#pragma once
#include <map>
#include <set>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// Triangles of the cloth at x that cut the skin, by the exact test.
std::set<int> penetrating_triangles(const ClothMesh& cloth, const body::PosedBody& body,
                                    const std::vector<Vec3>& x);

/// Flat triangles can cut a curved skin between their contact points. A penetrating triangle gets a
/// lattice of contact points, whose offsets make up for the error of the distance field there, and
/// is held off by what it lacks of clearing the skin, more so each time; so are triangles that are
/// about to cut. No farther than the field is smooth. times_cut counts per triangle over the
/// rounds. half_thickness: offset of an undisturbed contact point of each layer [m]. Whether an
/// offset was raised: the cloth has to be settled again.
bool raise_offsets_at_penetrations(ClothModel& model, const ContactBody& body,
                                   const std::vector<Vec3>& x,
                                   const std::vector<double>& half_thickness,
                                   const std::set<int>& penetrating, std::map<int, int>& times_cut,
                                   const PenetrationTuning& tuning);

}  // namespace loosefit::drape
