#pragma once
#include <string>

#include "loosefit/base/progress.h"

namespace loosefit::validate {

/// One horizontal cantilever of the beam fabric (beam_strip.h).
struct CantileverCase {
  double gravity_number = 0;  ///< Γ = q L³/B; the weight
  double force_number = 0;    ///< α = P L²/B; dead load P per width on the free end
  int elements = 40;          ///< edges along the length
  /// Set to find the length from Γ under ordinary gravity; otherwise L is given and gravity, if
  /// any, follows.
  double length = 0;  ///< [m]
};

/// Where it came to rest, horizontal and vertical distance from the clamp to the free end over L.
struct CantileverShape {
  double w = 0, h = 0;
  double chord_angle() const;  ///< of the line from clamp to end below the horizontal [rad]
  std::string mesh;
};

/// Cuts, clamps and settles it, from the straight start.
CantileverShape settle_cantilever(const CantileverCase& problem, Progress& progress);

/// Edges along the length that resolve both the length and the boundary layer √(B/(q L)) at the
/// clamp: at least 40, and five per layer.
int cantilever_elements(double gravity_number);

}  // namespace loosefit::validate
