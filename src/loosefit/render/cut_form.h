#pragma once
#include <optional>
#include <vector>

#include "loosefit/render/clipped_surface.h"

namespace loosefit::render {

/// A closed surface that is cut piece by piece and closed again.
class CutForm {
 public:
  explicit CutForm(geometry::TriangleMesh surface);

  /// Leaves where keep(vertex of the first surface, place) ≥ 0 and puts a lid that faces `lid` on
  /// every opening.
  template <class Keep>
  void cut(const Keep& keep, const Vec3& lid) {
    std::vector<double> at(origin_.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = keep(origin_[i], mesh_.vertices[i]);
    cut_at(at, lid);
  }
  const geometry::TriangleMesh& mesh() const { return mesh_; }

 private:
  void cut_at(const std::vector<double>& keep, const Vec3& lid);

  geometry::TriangleMesh mesh_;
  std::vector<int> origin_;
};

}  // namespace loosefit::render
