#pragma once
#include <string>

#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// What can be done in this scenario where its garments find no room between arms and trunk, in
/// whatever posture: keys that its garments have. A draft has garment.fit, or garment.size in its
/// place; a pattern file has neither, but may hold sizes, and lies as it is placed.
std::string no_room_advice(const scenario::Scenario& scenario);

}  // namespace loosefit::pipeline
