#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/passing_girths.h"
#include "loosefit/drape/rims.h"

namespace loosefit::drape {

/// Whether somebody gets into a garment as it is cut, without a fastening.
struct PuttingOn {
  std::vector<std::string> too_narrow;  ///< openings that do not let pass what has to, as sentences
  std::vector<std::string> not_judged;  ///< openings of which nobody knows, as sentences

  /// False where an opening is too narrow, nothing where one could not be judged.
  std::optional<bool> possible() const {
    if (!too_narrow.empty()) return false;
    return not_judged.empty() ? std::optional(true) : std::nullopt;
  }
  /// The sentences of both, what is too narrow first.
  std::vector<std::string> reasons() const;
};

/// Compares each rim, as long as the material is known to give, with the girth that passes it:
///
/// * the head through a neck; also the hips where a garment with legs has no other way in;
/// * a hand through a cuff or armhole, heel and instep through the hem of a leg; the same of a tube
///   for one limb;
/// * the hips through the waist of trousers;
/// * a tube round the trunk over the hips from below, or over the chest from above (arms raised one
///   after the other), whichever it lets;
/// * the chest through the hem of a top, unless the hips pass its neck.
///
/// Chest and hips give way by 3 %. Hems of capes, open fronts, holes cut into a piece and slits of
/// skirts and trousers are not asked. Cloth with another opening of unknown use is not judged, nor
/// are cloth without openings and a body without joints.
PuttingOn putting_on(const std::vector<Rim>& rims, const body::PassingGirths& girths,
                     const fabric::Material& material);

}  // namespace loosefit::drape
