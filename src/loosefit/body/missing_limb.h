#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// A part of a person that a scan does not have: from some place of a limb outwards, or the head.
struct MissingLimb {
  Segment first = Segment::hand;  ///< innermost part of which more than half is missing
  int side = 0;                   ///< +1 the wearer's left, -1 right, 0 the head
  Vec3 end = Vec3::Zero();        ///< where the scan ends, on the limb's own line [m]
  double beyond = 0;              ///< length of the model's limb beyond the end [m]
  bool above_wrist = false;       ///< an arm that ends there, by more than a centimetre
  std::string where;              ///< the end in words: "0.11 m below the elbow"
  std::vector<int> vertices;      ///< of the model's smoothed surface that lie beyond the end

  std::string name() const;  ///< "left forearm and hand", "head"
  bool of_leg() const {
    return first == Segment::thigh || first == Segment::shank || first == Segment::foot;
  }
};

/// A foot of a scan that ends before its toes.
struct ShortFoot {
  int side = 0;   ///< +1 the wearer's left, -1 right
  double by = 0;  ///< length of the model's foot before the end of the scan's [m]
};

}  // namespace loosefit::body
