#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit {

/// The part of the body that pictures show: a dress form. The head is cut off above the neck, and
/// below the garment's hem the body ends inside the cloth, for faces and anatomy are not the
/// subject and nobody is shown undressed. Arms and hands stay. A body without joints (a scan that
/// gives none) is cut at the hem only.
TriangleMesh mannequin(const Body& body, const Garment& garment,
                       const std::vector<Vec3>& positions);

/// The part of a surface where `keep` (per vertex) is ≥ 0; triangles are split where it crosses
/// zero. `rim` receives the new edges as pairs of vertices of the result.
TriangleMesh clipped(const TriangleMesh& mesh, const std::vector<double>& keep,
                     std::vector<std::array<int, 2>>* rim = nullptr);

}  // namespace loosefit
