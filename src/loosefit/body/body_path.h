#pragma once
#include <functional>

#include "loosefit/body/posed_body.h"

namespace loosefit::body {

/// Body at a share of the way from one posture (0) to another (1), for dressing from the dressing
/// posture to the wanted one. All bodies of one path share their topology.
using BodyPath = std::function<PosedBody(double share)>;

}  // namespace loosefit::body
