#pragma once
#include <functional>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::dress {

/// How far a garment is laid from the body.
struct LayingRoom {
  double clearance = 0.02;     ///< of sheets and seams from the body, all round [m]
  double least_depth = 0.008;  ///< of a sheet from the surface in the middle, off the seams [m]
  double depth_share = 1;      ///< of a sheet from that surface, against the body and its clearance
  /// Front neckline straight across, so that garments of several sizes can be laid over each other;
  /// otherwise it goes below the chin.
  bool straight_neck = false;
};

/// First positions of a garment of one kind round a body [m]; its sheets may cut themselves.
/// \throws NoRoom when a panel would fold over or the body cannot be dressed in this posture,
/// GeometryError for a pattern or a body that is not fit for it.
using LayRound =
    std::function<std::vector<Vec3>(const garment::Garment&, const body::Body&, const LayingRoom&)>;

/// First positions of a garment that is worn alone [m]: `lay` with the first of several clearances
/// that leaves no intersections of the garment with itself. It encloses the body; it is strained,
/// and settling lets it contract. \throws as LayRound, NoRoom when every clearance has some.
std::vector<Vec3> lay_round(const garment::Garment& garment, const body::Body& body,
                            const LayRound& lay);

}  // namespace loosefit::dress
