#pragma once
#include "loosefit/dress/dress.h"

namespace loosefit {

/// How far a shirt is laid from the body.
struct ShirtRoom {
  double clearance = 0.02;     ///< of sheets and seams from the body, all round [m]
  double least_depth = 0.008;  ///< of a sheet from the surface in the middle, off the seams [m]
  double depth_share = 1;      ///< of a sheet from that surface, against the body and its clearance
  /// Front neckline straight across, so that shirts of several sizes can be laid over each other;
  /// otherwise it goes below the chin.
  bool straight_neck = false;
};

/// One try of dress_shirt; the sheets may cut themselves.
/// \throws NoRoom when a panel would fold over, and as dress_shirt.
std::vector<Vec3> lay_shirt(const Garment& shirt, const Body& body, const ShirtRoom& room);

}  // namespace loosefit
