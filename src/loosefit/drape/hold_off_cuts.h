#pragma once
#include <map>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"

namespace loosefit {

/// What one round found and did.
struct CutRound {
  bool cuts = false;  ///< triangles cut the skin
  bool held = false;  ///< some are held off farther now: the cloth has to be settled again
};

/// Flat triangles can cut a curved skin between their contact points. Finds such cuts with the
/// exact test; a cut triangle gets a lattice of contact points, whose offsets make up for the error
/// of the distance field there, and is held off by what it lacks of clearing the skin, more so each
/// time; so are triangles that are about to cut, when any cuts or with look_ahead. times_cut counts
/// per triangle over the rounds. No farther than the field is smooth. Nothing is changed when
/// nothing cuts, unless look_ahead. half_thickness: offset of an undisturbed contact point of each
/// layer [m].
CutRound hold_off_cuts(ClothModel& model, const ContactBody& body, const std::vector<Vec3>& x,
                       const std::vector<double>& half_thickness, bool look_ahead,
                       std::map<int, int>& times_cut);

}  // namespace loosefit
