#pragma once
#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Adds what pulls along a cable to Garment::bands: parts of about its length over an edge of the
/// mesh, at least one, each over the triangles of the panel that it covers in its width. A mesh
/// resolves no band narrower than half an edge: such a one is spread over that. A part off the
/// panel's mesh (a path along a curved outline) adds nothing. \pre checked (check_attachment.h)
void lay_band(Garment& garment, int panel, const Cable& cable);

}  // namespace loosefit::garment
