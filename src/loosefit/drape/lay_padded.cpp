#include "loosefit/drape/lay_padded.h"

#include <algorithm>
#include <set>

#include "loosefit/dress/no_room.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {
namespace {

/// Tries, between wearer and sheets [m]: the wearer is as thick as what is under it already.
constexpr double kClearances[] = {0.012, 0.010, 0.014, 0.008, 0.020};

/// What limbs a kind has openings for; empty where its pattern tells (pattern files).
std::set<kinds::OpeningUse> limbs_of(const kinds::GarmentKind& kind) {
  using Use = kinds::OpeningUse;
  std::set<Use> limbs;
  for (const kinds::KindOpening& opening : kind.openings)
    for (const Use limb : {Use::left_arm, Use::right_arm, Use::left_leg, Use::right_leg})
      if (opening.use == limb) limbs.insert(limb);
  return limbs;
}

}  // namespace

bool dress_other_limbs(const kinds::GarmentKind& one, const kinds::GarmentKind& other) {
  const auto a = limbs_of(one), b = limbs_of(other);
  return !a.empty() && !b.empty() &&
         std::ranges::none_of(a, [&](const auto limb) { return b.contains(limb); });
}

std::vector<Vec3> lay_padded(const garment::Garment& garment, const dress::LayRound& lay,
                             const body::PosedBody& wearer) {
  dress::NoRoom last("");
  for (const double clearance : kClearances) try {
      // The neckline is straight, since garments may be laid over this one.
      std::vector<Vec3> x = lay(garment, wearer, {.clearance = clearance, .straight_neck = true});
      if (geometry::self_intersections(x, garment.triangles).empty()) return x;
      last =
          dress::NoRoom("the garment cannot be laid over what is under it without cutting itself");
    } catch (const dress::NoRoom& error) {
      last = error;
    }
  throw last;
}

}  // namespace loosefit::drape
