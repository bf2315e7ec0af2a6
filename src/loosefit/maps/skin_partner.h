#pragma once
#include <vector>

#include "loosefit/body/body_frame.h"
#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// One garment on one wearer in one state (posture, donning); only referred to.
struct DressedState {
  const std::vector<Vec3>& positions;  ///< per garment vertex [m]
  body::PosedBody body;
  const WornGarment& worn;
};

/// \throws InvalidInput unless the state has a position and a partner for every garment vertex.
void require_fit(const garment::Garment& garment, const DressedState& state);

/// Skin partner of every garment vertex: the closest body point in the reference state, which then
/// moves with the skin (docs/theory/sensor_metrics.md 1, correspondence 3).
std::vector<body::SkinPoint> skin_partners(const DressedState& reference);

/// How a point of the cloth has moved relative to its partner on the skin, in the frame that the
/// partner carries [m] (docs/theory/sensor_metrics.md 7).
struct Slip {
  double around = 0;  ///< along s of the frame; NaN like `along`
  double along = 0;   ///< along the segment's long axis, to its near end; NaN where none is known
  double distance = 0;
};

/// Where a point of the cloth lies against its partner p on the skin, in the frame F that p
/// carries: Fᵀ(x − p) [m].
Vec3 offset_on_skin(const body::SkinPoint& partner, const body::Body& body, const Vec3& position);

/// Slip from the change of that offset since the reference, or a mean of such: its tangential part.
/// A rigid motion of body and garment gives zero. It is read in the tangent plane at the partner:
/// sliding by an angle θ round a cylinder of radius r reads r sin θ (1 % short at 20 mm round an
/// arm of 82 mm radius).
Slip slip_of(const Vec3& change_of_offset, bool has_direction);

/// Slip of every garment vertex now against the reference. \throws InvalidInput when the bodies are
/// not the same wearer's or the positions do not fit the garment.
std::vector<Slip> vertex_slips(const garment::Garment& garment, const DressedState& reference,
                               const DressedState& now);

}  // namespace loosefit::maps
