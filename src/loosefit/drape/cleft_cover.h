#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::drape {

/// A closed surface that fills the cleft between the thighs below the crotch where it is narrower
/// than cloth needs (6 mm): flesh gives way there, rigid skin would hold the seat of
/// trousers like a vice. The convex hull of the skin on both sides; empty where there is no such
/// cleft, or no crotch is known.
geometry::TriangleMesh cleft_cover(const body::PosedBody& body);

/// Whether an arm is raised by more than 45 degrees from the trunk's axis.
bool raises_an_arm(const body::Body& body);

/// Closed surfaces that fill folds of skin as narrow in the armpits of arms that are raised by more
/// than 45 degrees from the trunk's axis: chest and upper arm fold onto each other there, and cloth
/// would be caught. Beside an arm that hangs cloth lies between arm and trunk. `on_the_way_up`:
/// from 33 degrees on, for arms that are to be raised: cloth that lay in a fold when it is filled
/// would be held in the filling. A hull for every few centimetres along a fold; none where no
/// armpits are known.
std::vector<geometry::TriangleMesh> armpit_covers(const body::PosedBody& body,
                                                  bool on_the_way_up = false);

/// The hull of each ear and of the skin behind it: an ear gives way, a rigid one would catch the
/// edge of a hood. None where no head or shoulders are known.
std::vector<geometry::TriangleMesh> ear_covers(const body::PosedBody& body);

}  // namespace loosefit::drape
