#include "loosefit/body/missing_limb.h"

namespace loosefit::body {

std::string MissingLimb::name() const {
  const std::string of = side > 0 ? "left " : side < 0 ? "right " : "";
  switch (first) {
    case Segment::upper_arm:
      return of + "arm";
    case Segment::forearm:
      return of + "forearm and hand";
    case Segment::hand:
      return of + "hand";
    case Segment::thigh:
      return of + "leg";
    case Segment::shank:
      return of + "shank and foot";
    case Segment::foot:
      return of + "foot";
    default:
      return "head";
  }
}

}  // namespace loosefit::body
