#pragma once

namespace loosefit::kinds {

/// What an opening of a garment was made for.
enum class OpeningUse {
  unknown,   ///< an unusual cut: it is only asked that it stays where it was put on
  limb,      ///< of a tube for a limb (`round`): stocking, arm band
  tube,      ///< of a tube for whatever goes through both its ends
  neck,      ///< of a garment that hangs on the shoulders
  cape_hem,  ///< of a cape or poncho, arms within or out below it
  left_arm,  ///< cuff or armhole
  right_arm,
  left_leg,
  right_leg,
  waist,  ///< of what hangs on the hips
  upper,  ///< of a tube round the trunk: waist of a skirt, or top of a strapless dress
  hem     ///< round trunk or both legs
};

}  // namespace loosefit::kinds
