#pragma once
#include "loosefit/kinds/named_values.h"

namespace loosefit::kinds {

/// Heights above the floor at which a leg is measured, as shares of the crotch's height: where the
/// rings of the body model lie on a woman of 1.68 m and a stout one of 1.65 m, within 0.03.
inline constexpr double kThighLevel = 0.92, kKneeLevel = 0.58, kCalfLevel = 0.445,
                        kAnkleLevel = 0.145;

/// Legs of a wearer of whom only trunk and crotch are known: girths as shares of the hip's, means
/// of people of the body model.
inline constexpr double kThighOfHip = 0.54, kKneeOfHip = 0.335, kCalfOfHip = 0.335,
                        kAnkleOfHip = 0.175;

/// Girth of the leg at a height above the floor [m], between the levels in proportion.
double leg_girth_at(const NamedValues& measures, double height);

inline constexpr double kFrontShare = 0.48;  ///< of girths, the rest is the back's
/// The girth of the garment at the hip [m].
double hip_girth(const NamedValues& measures, const NamedValues& fit);

/// Height of the waist edge of the pieces, where the waistband is sewn on [m]: the band lies with
/// its middle on the waist.
double waist_edge_height(const NamedValues& measures, const NamedValues& fit);
/// Height of the hem above the floor [m].
double hem_height(const NamedValues& measures, const NamedValues& fit);

/// How narrow the waist of the pieces can be cut: the seams take in a few centimetres each, and
/// what is wider than the waistband is gathered into it. As a mobility of the waist [–].
double least_waist(const NamedValues& measures, const NamedValues& fit);

}  // namespace loosefit::kinds
