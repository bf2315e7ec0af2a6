#pragma once
#include "loosefit/base/error.h"

namespace loosefit::kinds {

/// What a shirt must have to be drafted.
enum class ShirtRule {
  range,           ///< every size and fit is plausible by itself
  sleeve_width,    ///< some cap of the sleeve's girth is as long as the armhole
  shoulder_level,  ///< the shoulder point lies above the underarm
  hem_level,       ///< the hem lies below the underarm
  waist_level,     ///< the waist lies between underarm and hem
  neck,            ///< the shoulder seam has a length
  sleeve_length,   ///< the underarm seam of the sleeve has a length
  torso_outline,   ///< front and back do not cross themselves
  sleeve_outline,  ///< nor do the sleeves
};

/// A shirt that cannot be drafted, with the rule that it breaks and by how much.
class ShirtRefusal : public InvalidInput {
 public:
  ShirtRefusal(const InvalidInput& complaint, ShirtRule rule, double shortfall = 0)
      : InvalidInput(complaint), rule_(rule), shortfall_(shortfall) {}
  ShirtRule rule() const { return rule_; }
  /// What is missing [m]; waist_level: signed, what the waist has to be lowered by.
  double shortfall() const { return shortfall_; }

 private:
  ShirtRule rule_;
  double shortfall_;
};

}  // namespace loosefit::kinds
