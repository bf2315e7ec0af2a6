#pragma once
#include <set>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// What refine_contact changed.
struct ContactRefinement {
  int triangles = 0;          ///< that got their lattice of contact points
  int places = 0;             ///< further points, at places nearest to the skin
  double largest_change = 0;  ///< of a field error, where the cloth touches [m]
};

/// Lets the contact of the cloth at x see the skin itself, from both sides:
///
/// * flat triangles near the skin get a lattice of contact points (contact/contact_lattice.h),
///   since a curved skin reaches into them between vertices and edge midpoints;
/// * a cell of such a lattice gets a further point where the skin's corners and edges come nearer
///   than at its nodes;
/// * what the field of distances errs at a contact point near the skin is measured and taken off
///   what it reads there (ContactPoint::field_error).
///
/// So the exact distance is kept at rest, by the smooth field's normal, and every point rests at
/// half the thickness of its fabric. Call it before settling; what slides afterwards sees the
/// error of where it was. `cut`: triangles that still cut the skin at rest; their cells keep the
/// points that they have beside new ones, since more than one corner of the skin may reach into
/// them.
ContactRefinement refine_contact(ClothModel& model, const ContactBody& body,
                                 const std::vector<Vec3>& x, const std::set<int>& cut,
                                 const PenetrationTuning& tuning);

}  // namespace loosefit::drape
