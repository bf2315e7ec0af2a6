#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Meshes every panel at `edge_length` [m], sews them and adds the attachments.
/// \throws InvalidInput, GeometryError as edge_divisions, sew_panels and attach do.
Garment assemble(const pattern::Pattern& pattern, double edge_length,
                 const fabric::Material& material, const std::vector<Attachment>& attachments = {});

}  // namespace loosefit::garment
