#pragma once
#include <memory>
#include <string>

#include "loosefit/validate/beam_strip.h"

namespace loosefit::validate {

/// How the two ends of a hanging loop leave the clamp.
enum class LoopKind {
  ring,   ///< horizontally, to either side
  pear,   ///< downwards, side by side
  heart,  ///< upwards, side by side
};

/// A strip of the beam fabric (beam_strip.h), 100 mm long, with both ends in one clamp and a seam
/// in the middle; gravity is raised step by step from the weightless loop on.
class HangingLoop {
 public:
  HangingLoop(LoopKind kind, int elements);
  /// Settles it at Γ = q L³/B from where it is. Call with rising Γ.
  void settle(double gravity_number, Progress& progress);
  double height() const;      ///< clamp to lowest point, over L
  double half_width() const;  ///< over L
  std::string mesh() const { return mesh_text(strip_.specimen); }

 private:
  LoopKind kind_;
  fabric::Material fabric_;
  ClampedStrip strip_;
  double gap_ = 0;  ///< half the distance between the ends, which the references do not have [m]
  particles::VectorField x_;
};

}  // namespace loosefit::validate
