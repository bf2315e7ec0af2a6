#pragma once
#include <optional>
#include <string>

#include "loosefit/placement/address.h"

namespace loosefit::placement {

/// A place that a line goes through, in one of three ways: a body landmark or preset by name, an
/// anatomical address, or a place in the pattern.
struct LinePlace {
  std::string landmark;  ///< any of SitePoints::names; empty: one of the others
  std::optional<BodyAddress> anatomy = {};
  std::string panel = {};  ///< with `at`
  Vec2 at = Vec2::Zero();  ///< u (weft), v (warp) in the panel [m]

  /// As parse_place reads it back.
  std::string str() const;
};

/// What a text says: "wrist_L" a landmark or preset, "left forearm [0, 50, 30]" an address as
/// BodyAddress::str writes it, "sleeve_L:0.12,0.30" a panel with u,v [m]. \throws InvalidInput, key
/// "place", for anything else; whether the landmark, the panel or the skin exists is seen when body
/// and garment are known.
LinePlace parse_place(const std::string& text);

}  // namespace loosefit::placement
