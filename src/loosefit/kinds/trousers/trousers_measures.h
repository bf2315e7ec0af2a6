#pragma once
#include <vector>

#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/named_values.h"

namespace loosefit::kinds {

// `measures` and `fit` of these functions are those of the kind (trousers.cpp), girths and heights
// in metres, fits as mobilities [–]. Each \throws std::out_of_range for a name that it needs and
// that is missing; nothing else is checked.

/// Heights above the floor at which a leg is measured, as shares of the crotch's height [–]: where
/// the rings of the body model lie on a woman of 1.68 m and a stout one of 1.65 m, within 0.03.
inline constexpr double kThighLevel = 0.92, kKneeLevel = 0.58, kCalfLevel = 0.445,
                        kAnkleLevel = 0.145;

/// Legs of a wearer of whom only trunk and crotch are known: girths as shares of the hip's [–],
/// means of people of the body model.
inline constexpr double kThighOfHip = 0.54, kKneeOfHip = 0.335, kCalfOfHip = 0.335,
                        kAnkleOfHip = 0.175;

/// Girth of the body's leg [m] at a height above the floor [m]: that of its stations where they are
/// known, else as measured at thigh, knee, calf
/// and ankle, or their share of the hip; in proportion between these levels, as at the last one
/// beyond.
double leg_girth_at(const BodyMeasures& measures, double height);

/// Of the girths of hip, waist and leg the front has this share [–], the back the rest.
inline constexpr double kFrontShare = 0.48;
/// The girth of the garment at the hip [m].
double hip_girth(const BodyMeasures& measures, const NamedValues& fit);

/// What is asked for between crotch and hem: the mobilities of thigh, knee, calf and hem that `fit`
/// has and that the leg reaches, downwards from the crotch [m]. Without a thigh they begin at the
/// knee.
std::vector<AskedMobility> leg_eases(const BodyMeasures& measures, const NamedValues& fit);
/// Whether the leg has the ease between two asked ones at a place so far down from the crotch. Where
/// thigh or calf is not asked for, nothing is asked beside it, and the seams run as they do by
/// themselves.
bool is_ease_asked(const BodyMeasures& measures, const NamedValues& fit, double along);

/// Height of the waist edge of the pieces, where the waistband is sewn on [m]: the band lies with
/// its middle on the waist.
double waist_edge_height(const BodyMeasures& measures, const NamedValues& fit);
/// Height of the hem above the floor [m].
double hem_height(const BodyMeasures& measures, const NamedValues& fit);

/// How narrow the waist of the pieces can be cut, as a mobility of the waist [–]: above the hip the
/// seams take in 34 mm of each front and in proportion, 37 mm, of each back. What is then wider
/// than the waistband is gathered into it.
double least_waist(const BodyMeasures& measures, const NamedValues& fit);
/// The waist of the pieces where nobody asks for one, as a mobility [–]: least_waist, but no less
/// than 0.02 or fit.hip, whichever is less, above hips that are hardly wider than the waist.
double usual_waist(const BodyMeasures& measures, const NamedValues& fit);

}  // namespace loosefit::kinds
