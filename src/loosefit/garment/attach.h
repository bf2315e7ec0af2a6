#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Adds the attachments to masses, rigidities, bands, padding and rigid boards of a sewn garment of
/// this material. Mass and centre of mass are kept exactly; the rigidity of flexible boards and
/// cables is weighted by the covered share of a triangle. What lies beyond the panel's edge is
/// carried by that edge. \throws InvalidInput naming the attachment: panel unknown, point outside
/// the panel (with the nearest point inside), size, mass or stiffness out of range, material
/// unknown, two rigid boards over each other.
void attach(Garment& garment, const pattern::Pattern& pattern,
            const std::vector<Attachment>& attachments, const fabric::Material& material);

}  // namespace loosefit::garment
