#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::placement {

/// A place in the pattern with the triangle of the sewn mesh that it lies in.
struct PatternPlace {
  int panel = 0;           ///< index into Garment::panel_names
  Vec2 at = Vec2::Zero();  ///< u weft, v warp [m]
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
};

/// A vertex field at a place, linear over its triangle.
Vec3 at_place(const garment::Garment& garment, const PatternPlace& place,
              const std::vector<Vec3>& field);

/// Finds triangles of a garment by their place in the flat pattern. Keeps a reference to the
/// garment. Panels are looked up on a grid of cells of a few triangles each.
class PatternLocator {
 public:
  explicit PatternLocator(const garment::Garment& garment);
  /// Nothing outside the panel. On a shared edge the lower triangle index counts.
  std::optional<PatternPlace> find(int panel, const Vec2& at) const;
  const garment::Garment& garment() const { return garment_; }

 private:
  struct Grid {
    Vec2 lower = Vec2::Zero();
    int columns = 0, rows = 0;
    std::vector<std::vector<int>> triangles;  ///< per cell, ascending
  };
  const garment::Garment& garment_;
  double cell_ = 0;
  std::vector<Grid> grids_;  ///< per panel
};

/// Places over the whole garment, no two of one panel closer than `spacing` [m] in the flat pattern
/// and no point of a panel farther than `spacing` plus 9 % from one (Poisson-disc set): points of a
/// lattice of spacing / 8 are visited in random order by `seed` and kept where there is room. In
/// panel order; the same for the same garment, spacing and seed.
/// \throws InvalidInput unless spacing is from 1 mm to 1 m.
std::vector<PatternPlace> poisson_places(const PatternLocator& locator, double spacing,
                                         std::uint64_t seed = 1);

/// Outlines of the panels as the mesh has them, seams apart from free edges (hems, openings).
class PanelBorders {
 public:
  explicit PanelBorders(const garment::Garment& garment);
  /// Flat distance [m] to the nearest seam of that panel; infinity without one.
  double to_seam(int panel, const Vec2& at) const { return distance(seams_[panel], at); }
  double to_free_edge(int panel, const Vec2& at) const { return distance(free_[panel], at); }

 private:
  using Segment = std::pair<Vec2, Vec2>;
  static double distance(const std::vector<Segment>& segments, const Vec2& at);
  std::vector<std::vector<Segment>> seams_, free_;  ///< per panel
};

}  // namespace loosefit::placement
