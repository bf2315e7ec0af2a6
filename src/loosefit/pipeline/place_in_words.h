#pragma once
#include <optional>
#include <string>

#include "loosefit/body/regions.h"
#include "loosefit/pattern/pattern.h"
#include "loosefit/placement/address.h"

namespace loosefit::pipeline {

/// A place of the skin as people say it: "the upper back, 3 cm to the wearer's left of the middle,
/// 12 cm below the nape", "the outer side of the left forearm, 7 cm above the wrist". The region
/// alone where the place has no address on this body.
std::string place_on_body(const body::Body& body, body::Region region,
                          const std::optional<placement::BodyAddress>& address);

/// A place of the pattern as a tape finds it: "panel back, 14.2 cm from neck and 9.8 cm from side".
/// The names are those of the edges. A panel that the pattern lacks is named alone.
std::string place_on_panel(const pattern::Pattern& pattern, const std::string& panel,
                           const Vec2& at);

}  // namespace loosefit::pipeline
