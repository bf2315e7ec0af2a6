#pragma once
#include <array>
#include <map>
#include <string>

#include "loosefit/drape/drape.h"
#include "loosefit/fabric/material.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// Gaps up to which cloth is told to be near the skin [m].
inline constexpr std::array<double, 7> kNearGaps = {0.0005, 0.001, 0.002, 0.003,
                                                    0.005,  0.010, 0.020};

/// How a garment presses on its wearer, in a few numbers that tell a loose garment from a tight
/// one: cloth that hangs presses with a few times its weight at most, since friction and slopes
/// turn the weight into normal force; a tube that is too narrow presses with many.
struct BodyLoad {
  double normal_force = 0;  ///< total normal force of the skin on the garment [N]
  double weight = 0;        ///< of the garment with what is attached to it [N]
  /// normal_force by the limb under the cloth [N]: every name of limb_names().
  std::map<std::string, double> of_limb;
  /// Part of normal_force where cloth lies between an arm and the trunk (or a leg), which press it
  /// from both sides [N]: not held there by the cut of the garment.
  double between_arm_and_trunk = 0;
  /// free_force() by limb [N]: every name of limb_names().
  std::map<std::string, double> free_of_limb;
  /// Share of the flat area whose gap (maps/gap.h) is at most kNearGaps [–].
  std::array<double, kNearGaps.size()> near_share{};

  /// What is not squeezed between an arm and the trunk [N].
  double free_force() const { return normal_force - between_arm_and_trunk; }
  /// NaN for a garment without weight.
  double force_over_weight() const;
};

/// "trunk", "neck", "legs", "upper_arm_L", … in this order. The shoulders belong to the trunk, the
/// head to the neck, the hands to the forearms.
const std::vector<std::string>& limb_names();
std::string limb_of(body::Region region);

/// Cloth counts as pressed from both sides where skin that looks the other way is nearer than two
/// layers and what folds of skin keep apart (body::kSkinGap), or the mean edge of the mesh if that
/// is longer: triangles do not fold into a gap narrower than their edges, they are propped in it.
/// `least_edge` [m] counts where the mean edge is shorter, to compare with a coarser mesh.
/// \throws InvalidInput when the drape does not know its normal forces, or when sizes differ.
BodyLoad body_load(const garment::Garment& garment, const drape::Drape& drape,
                   const WornGarment& worn, const body::PosedBody& body,
                   const fabric::Material& material, double gravity = kGravity,
                   double least_edge = 0);

}  // namespace loosefit::maps
