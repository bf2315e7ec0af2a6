#pragma once
#include "loosefit/body/posed_body.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::drape {

/// A closed surface that fills the cleft between the thighs below the crotch where it is narrower
/// than cloth needs (8 mm): flesh gives way there, rigid skin would hold the seat of trousers like
/// a vice. The convex hull of the skin on both sides; empty where there is no such cleft, or no
/// crotch is known.
geometry::TriangleMesh cleft_cover(const body::PosedBody& body);

}  // namespace loosefit::drape
