#pragma once
#include <vector>

#include "loosefit/maps/skin_partner.h"

namespace loosefit::maps {

/// Angle of E = R R_refᵀ: how far a sensor that was calibrated at R_ref reads wrong at R, both
/// relative to the body (docs/theory/sensor_metrics.md 3.3) [rad]. The same whatever tangent the
/// body frame has, as long as it is carried with the skin.
double calibrated_error(const Mat3& now, const Mat3& reference);

/// The same turn with its signs: the rotation vector of R_refᵀ R in the sensor's own axes, across
/// it, along it and outwards, as they stood at R_ref [rad]. Its length is the calibrated error.
Vec3 calibrated_turn(const Mat3& now, const Mat3& reference);

/// A set of errors summed up.
struct ErrorSummary {
  double rms = 0;
  double p95 = 0;  ///< least error that 95 % of the set do not exceed: of few, the greatest
};
/// \throws InvalidInput for an empty set.
ErrorSummary summarise(const std::vector<double>& errors);

/// Calibrated orientation error (COE) of every garment vertex over several states against the
/// reference, in which the reference itself should not be counted [rad]. The body frame is that of
/// the material partner (maps/skin_partner.h); NaN where the cloth has no frame. \throws
/// InvalidInput for no states, or another body or garment.
std::vector<ErrorSummary> vertex_orientation_errors(const garment::Garment& garment,
                                                    const DressedState& reference,
                                                    const std::vector<DressedState>& states,
                                                    const Vec2& direction = Vec2(0, 1));

}  // namespace loosefit::maps
