#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// A draped cloth in smaller triangles: the same surface, with a partner for every new corner.
///
/// A triangle between the partners of three corners is flat, the skin under it is not: on an edge
/// of length s it runs s²/(8 r) below a skin of radius r, and over a hollow by as much above it.
/// Under 20 mm edges that is 0.2 mm of a trunk on average, 2 to 3 % of the air under a close shirt.
struct FineCloth {
  /// Topology, pattern coordinates and panels; no masses, bands or edge chains.
  garment::Garment garment;
  std::vector<Vec3> positions;
  WornGarment worn;
};

/// Halves every triangle's edges, four triangles for one, until the mean edge of the flat cloth is
/// at most `edge` [m]. Vertices of the cloth keep their numbers. \throws InvalidInput as `relate`.
FineCloth cut_finer(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    const body::PosedBody& body, double edge);

}  // namespace loosefit::maps
