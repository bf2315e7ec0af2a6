#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body_path.h"

namespace loosefit::drape {

/// What a wearer does once the garment is on, so that it comes to lie where wearers have it
/// (phases/wear_in.h).
struct Movement {
  std::string name = {};  ///< for the report
  /// The body goes from where it stands (0) to the far end (1) and back. Empty: it stands still.
  body::BodyPath way = {};
  /// Pull on the hem of each garment that hangs on the shoulders, down along the trunk, in weights
  /// of that garment [–]: on the way back where there is one, else as the body stands; then it is
  /// let go.
  double hem_pull = 0;
  /// Small movements in all directions, during which friction holds but this share of what it holds
  /// at rest [–].
  double friction_share = 1;
};

using Movements = std::vector<Movement>;

}  // namespace loosefit::drape
