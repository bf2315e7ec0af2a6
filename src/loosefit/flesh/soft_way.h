#pragma once
#include <map>
#include <memory>
#include <vector>

#include "loosefit/flesh/soft_body.h"

namespace loosefit::flesh {

/// A person on the way from one posture to another. Flesh is led to stops on the way
/// (SoftBody::in), at most 0.5 rad apart, and gives way in between as much as between the two next
/// to it: for movements, on whose way nothing is measured, and which ask for many postures close
/// together. Skin may overlap there by what that is off.
class SoftWay {
 public:
  SoftWay(std::shared_ptr<SoftBody> person, const body::Posture& from, const body::Posture& to);

  /// The person at a share of the way, 0 at `from`, 1 at `to`. \throws as SoftBody::in.
  body::PosedBody at(double share);

 private:
  /// What flesh has moved the skin by at a stop, at every vertex [m].
  const std::vector<Vec3>& moved(int stop);
  body::Posture posture(double share) const;

  std::shared_ptr<SoftBody> person_;
  body::Posture from_, to_;
  int stops_;
  std::map<int, std::vector<Vec3>> moved_;
};

}  // namespace loosefit::flesh
