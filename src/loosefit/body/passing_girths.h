#pragma once
#include <array>
#include <optional>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// Girths of a body that has to pass an opening to get into a garment [m]. What the body does not
/// tell is absent; of a limb that ends before its hand or foot it is 0, for nothing has to pass.
struct PassingGirths {
  std::optional<double> head;  ///< widest tape across the axis from the head's joint to the crown
  /// Round the knuckles without the thumb, left and right (ISO 8559-1 hand girth).
  std::array<std::optional<double>, 2> hand;
  /// Round heel and instep, left and right: the tape in the plane of the ankle and the heel's tip.
  std::array<std::optional<double>, 2> foot;
  std::optional<double> chest, hip;  ///< Body::measured
};

/// Takes them on the body in its posture. Nothing is thrown: a section that does not close is a
/// girth that is absent.
PassingGirths passing_girths(const Body& body);

}  // namespace loosefit::body
