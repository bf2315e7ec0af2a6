#include "loosefit/dress/lay_round.h"

#include <string>

#include "loosefit/dress/no_room.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::dress {
namespace {

/// Tries, between body and sheets [m]: wide ones help coarse triangles, narrow ones thick arms.
constexpr double kClearances[] = {0.02, 0.026, 0.034, 0.044, 0.057, 0.014, 0.010};

}  // namespace

std::vector<Vec3> lay_round(const garment::Garment& garment, const body::Body& body,
                            const LayRound& lay) {
  NoRoom last("");
  for (const double clearance : kClearances) try {
      std::vector<Vec3> x = lay(garment, body, {clearance});
      const auto hits = geometry::self_intersections(x, garment.triangles);
      if (hits.empty()) return x;
      last = NoRoom("the garment cannot be laid round this body: " + std::to_string(hits.size()) +
                    " pairs of its triangles cut each other at the start");
    } catch (const NoRoom& error) {
      last = error;
    }
  throw last;
}

}  // namespace loosefit::dress
