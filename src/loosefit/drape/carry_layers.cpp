#include "loosefit/drape/carry_layers.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::drape {

std::vector<MotionMap> carried_layers(const ClothMesh& cloth, const std::vector<Vec3>& x,
                                      std::vector<MotionMap> motion, const CarryTuning& tuning) {
  motion = smoothed_over(cloth.triangles, x, std::move(motion), tuning);
  for (int layer = 1; layer < cloth.layers(); ++layer) {
    geometry::TriangleMesh under;
    under.vertices.assign(x.begin(), x.begin() + cloth.first_vertex[layer]);
    under.triangles.assign(cloth.triangles.begin(),
                           cloth.triangles.begin() + cloth.first_triangle[layer]);
    const geometry::ClosestPointTree tree(under);
    tbb::parallel_for(cloth.first_vertex[layer], cloth.first_vertex[layer + 1], [&](int i) {
      const geometry::ClosestPoint hit = tree.query(x[i]);
      const double distance = (hit.point - x[i]).norm();
      const double share = std::clamp(
          (tuning.layer_apart - distance) / (tuning.layer_apart - tuning.layer_close), 0.0, 1.0);
      if (!(share > 0)) return;
      MotionMap there = MotionMap::Zero();
      for (int k = 0; k < 3; ++k)
        there += hit.barycentric[k] * motion[under.triangles[hit.triangle][k]];
      motion[i] = share * there + (1 - share) * motion[i];
    });
  }
  return motion;
}

}  // namespace loosefit::drape
