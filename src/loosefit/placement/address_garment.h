#pragma once
#include <string>
#include <vector>

#include "loosefit/maps/worn_garment.h"

namespace loosefit::placement {

/// A point of the garment by triangle.
struct GarmentPoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
};

/// Where a garment point lies in the pattern [m].
Vec2 pattern_place(const garment::Garment& garment, const GarmentPoint& point);
/// Where it lies in space, or another vertex field there.
Vec3 at(const garment::Garment& garment, const GarmentPoint& point, const std::vector<Vec3>& field);

/// The point of a panel at pattern coordinates [m]; up to 0.1 mm outside counts as its edge, since
/// a mesh cuts the corners of a curved outline. \throws InvalidInput, key "panel" (with a
/// did-you-mean) or "at" (with the nearest place in the panel).
GarmentPoint pattern_point(const garment::Garment& garment, const std::string& panel,
                           const Vec2& place);

/// Farther from the skin than this a garment does not cover it [m].
inline constexpr double kCoverReach = 0.15;

/// Why a point of the garment covers no skin, in words; empty where it does: where it is within
/// kCoverReach of its partner.
std::string off_skin(const garment::Garment& garment, const std::vector<Vec3>& positions,
                     const maps::WornGarment& worn, const GarmentPoint& point);

/// Which place of a worn garment lies over which place of the skin, in both directions. Keeps
/// references to garment, positions and `worn`.
class GarmentOverSkin {
 public:
  GarmentOverSkin(const garment::Garment& garment, const std::vector<Vec3>& positions,
                  body::PosedBody body, const maps::WornGarment& worn);

  /// The skin under a garment point: its partner by the rules of PartnerFinder.
  body::BodyPartner under(const GarmentPoint& point) const;

  /// The garment over a skin point: where its partner comes nearest to it, so that `under` leads
  /// back. Found with partners linear over each triangle, then corrected by what is missed. Among
  /// layers that are equally good (0.5 mm) the innermost one; of triangles that face as the skin
  /// does, if there are any.
  struct Over {
    GarmentPoint point;
    double miss = 0;  ///< its partner to the skin point [m]
    /// Faces as the skin; gap ≤ kCoverReach; miss below 15 mm or, where the cloth bridges a furrow,
    /// below 60 mm: away from free edges, and the ray along the skin's normal meets cloth.
    bool covered = false;
    std::string why_not;  ///< in words when it is not covered
  };
  Over over(const geometry::ClosestPoint& skin) const;

 private:
  GarmentPoint over_by_vertices(const Vec3& target, const Vec3& skin, const Vec3& normal,
                                bool facing) const;
  bool at_free_edge(const GarmentPoint& point) const;
  bool is_below_cloth(const Vec3& skin, const Vec3& normal) const;
  const garment::Garment& garment_;
  const std::vector<Vec3>& positions_;
  body::PosedBody body_;
  const maps::WornGarment& worn_;
  std::vector<std::array<int, 3>> neighbours_;
};

/// Angle of the long axis of the body segment in the pattern at a footprint, as for sensors: from
/// the warp, counter-clockwise [rad]: the pattern direction whose image on the cloth runs along
/// `axis` (unit, in space), mean over the triangles of the panel. NaN where the axis is normal to
/// the cloth or zero.
double angle_in_pattern(const garment::Garment& garment, const std::vector<Vec3>& positions,
                        const std::vector<int>& triangles, const Vec3& axis);

}  // namespace loosefit::placement
