#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/body/regions.h"

namespace loosefit::placement {

/// Part of a panel where no sensor may be sewn: a pocket, a zip, a wash label.
struct KeepOutZone {
  std::string name;
  std::string panel;
  enum class Shape { rectangle, disc } shape = Shape::rectangle;
  Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< rectangle: opposite corners [m]
  Vec2 centre = Vec2::Zero();                       ///< disc [m]
  double radius = 0;

  /// Distance of a place of that panel to the zone [m]; zero inside.
  double distance(const Vec2& at) const;
};

/// Everything that is kept free.
struct KeepOut {
  std::vector<KeepOutZone> zones;
  std::vector<body::Region> regions;  ///< of the body, under the garment
  bool empty() const { return zones.empty() && regions.empty(); }
};

/// Adds what a text says: "front:0.02,0.10,0.10,0.22" a rectangle by two opposite corners u,v of a
/// panel, "front:0.05,0.15,0.03" a disc by centre and radius [m], "abdomen" a region of the body.
/// \throws InvalidInput for anything else; an unknown region with a did-you-mean. Whether the panel
/// exists is seen when the garment is known.
void add_keep_out(const std::string& text, KeepOut& keep_out);

/// \throws InvalidInput for a zone on a panel that is not one of these, with a did-you-mean.
void check_keep_out(const KeepOut& keep_out, const std::vector<std::string>& panels);

}  // namespace loosefit::placement
