#pragma once
#include <optional>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// Height of the floor on which a person stands or sits [m]: the lowest point of the skin, where
/// that is of a foot and the neck is above both ankles. Nothing for a body without segments or
/// joints, and for one that lies, kneels or hangs.
std::optional<double> floor_under(const Body& body);

}  // namespace loosefit::body
