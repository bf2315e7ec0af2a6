#pragma once
#include <vector>

#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Adds the attachments to vertex_mass, triangle_added_bending, triangle_membrane_factor and bands
/// of a sewn garment. Mass and centre of mass are kept exactly; rigidity is weighted by the covered
/// share of a triangle. What lies beyond the panel's edge is carried by that edge. \throws
/// InvalidInput naming the attachment: panel unknown, point outside the panel (with the
///         nearest point inside), size, mass or stiffness out of range.
void attach(Garment& garment, const pattern::Pattern& pattern,
            const std::vector<Attachment>& attachments);

}  // namespace loosefit::garment
