#pragma once
#include "loosefit/kinds/named_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// A sleeveless shirt of two pieces, front and back, and four seams: side_* and shoulder_* (the
/// straps), with the asked girths exactly. Edges hem, side_*, armhole_*, shoulder_*, neck. Side
/// seams and hem are those of the shirt: round a belly, and the front longer and wider by the
/// body's front_balance and front_fullness, where these are known. Placed flat before and behind
/// the body. `measures` and `fit` as the kind names them (tank_top.cpp). \throws InvalidInput for
/// measures that do not make a garment together.
pattern::Pattern draft_tank_top(const BodyMeasures& measures, const NamedValues& fit);

/// How much room a chest leaves for the straps, which stand on the shoulder inside the underarm.
struct StrapRoom {
  double width = 1;        ///< most that fit.strap_width can be [–]
  double place = 1;        ///< most that fit.strap_place can be with that strap_width [–]
  double least_chest = 0;  ///< least fit.chest with room for any strap [–]
};
StrapRoom strap_room(const BodyMeasures& measures, const NamedValues& fit);

/// The least measures.hps_to_hem that it can be drafted with [m].
double shortest_tank_top(const BodyMeasures& measures, const NamedValues& fit);

/// The least measures.front_balance that it can be drafted with [m]: the middle of a front that is
/// shorter than the back still ends as far below the underarm as half the shortest side seam.
double least_front_balance(const BodyMeasures& measures, const NamedValues& fit);

}  // namespace loosefit::kinds
