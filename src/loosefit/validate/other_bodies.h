#pragma once
#include "loosefit/body/body_path.h"

// People that the parametric model cannot be asked for, made from two of its bodies or from one.
namespace loosefit::validate {

/// The right half of one body and the left half of the other, both of one person in two postures
/// that differ in the arms alone: so that one arm may be raised. Blended over 8 cm at the middle.
body::Body halves(const body::Body& left, const body::Body& right);

/// The body with shoulders that slope by `more` [rad] more: the shoulders turned down about the
/// sides of the neck, the arms carried along, the trunk below the armpits less and less, none at
/// the waist. `measured` of the slope follows. \pre upright; landmarks hps_L, acromion_L
body::Body with_shoulder_slope(body::Body body, double more);

/// The same of every body of a way; no way stays none.
body::BodyPath sloped_way(const body::BodyPath& way, double more);

}  // namespace loosefit::validate
