#pragma once
#include "loosefit/kinds/named_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// A sleeveless shirt of two pieces, front and back, and four seams: side_* and shoulder_* (the
/// straps), with the asked girths exactly. Edges hem, side_*, armhole_*, shoulder_*, neck. Placed
/// flat before and behind the body. `measures` and `fit` as the kind names them (tank_top.cpp).
/// \throws InvalidInput for measures that do not make a garment together.
Pattern draft_tank_top(const NamedValues& measures, const NamedValues& fit);

/// The least measures.hps_to_hem that it can be drafted with [m].
double shortest_tank_top(const NamedValues& measures, const NamedValues& fit);

}  // namespace loosefit
