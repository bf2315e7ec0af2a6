#pragma once
#include <functional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// Moves a flat panel along the normal of its outside until it lies `clear` [m] beyond all of the
/// body that lies before it, seen along the normal.
/// \param frame unit axes of the panel's plane, then the normal of its outside
/// \param counts which vertices of the skin are looked at
/// \param x vertices of open.garment [m]
void clear_panel(const garment::OpenSeams& open, int panel, const Mat3& frame, double clear,
                 const body::PosedBody& body, const std::function<bool(std::size_t)>& counts,
                 std::vector<Vec3>& x);

}  // namespace loosefit::drape
