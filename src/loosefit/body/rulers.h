#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::body {

/// Vertex chain of a ruler: "bust_circ", "waist_circ", "upperarm_length", …
/// (docs/theory/body_model.md 3.1). Limb rulers lie on the left. \throws InvalidInput for an
/// unknown name.
const std::vector<int>& ruler(const std::string& name);

/// Mean of the chain's vertices.
Vec3 ruler_centre(const std::vector<Vec3>& vertices, const std::string& name);

}  // namespace loosefit::body
