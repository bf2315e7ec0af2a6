#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/settling_tuning.h"
#include "loosefit/drape/stop_reason.h"
#include "loosefit/geometry/box.h"

namespace loosefit::drape {

/// Sees cloth that nothing can hold any more: without a floor what has left the body falls for ever
/// and never comes to rest, and on a floor it is worn by nobody. Pieces that are not sewn to each
/// other are looked at one by one, but together where their boxes come near each other, for one may
/// hang on the other.
class FreeFall {
 public:
  /// Keeps references to the garments, the innermost first, whose vertices are numbered through.
  explicit FreeFall(const std::vector<const garment::Garment*>& layers,
                    const FreeFallTuning& tuning = {});

  /// What falls at x; none where all may still be held. Cloth falls when the whole of it
  /// is below the body, or so far to the side of it that it misses it however it turns: the box of
  /// the body, seen from above, is farther from the centroid than any point of the cloth is, by
  /// a margin. Forces within cloth do not move its centroid, so that both are for good.
  std::optional<Stop> falling(const std::vector<Vec3>& x, const geometry::Box3& body) const;

 private:
  bool misses(const std::vector<Vec3>& x, const std::vector<int>& cloth,
              const geometry::Box3& body) const;
  std::vector<std::string> panels_of(const std::vector<int>& pieces) const;

  std::vector<const garment::Garment*> layers_;
  FreeFallTuning tuning_;
  std::vector<std::vector<int>> pieces_;  ///< vertices of each connected piece
};

}  // namespace loosefit::drape
