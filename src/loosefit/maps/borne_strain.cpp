#include "loosefit/maps/borne_strain.h"

#include <cmath>

#include "loosefit/fabric/strain_patch.h"
#include "loosefit/maps/strain.h"

namespace loosefit::maps {

std::vector<geometry::DeformationGradient> borne_gradients(const garment::Garment& garment,
                                                           const std::vector<Vec3>& positions) {
  const std::size_t count = garment.triangles.size();
  std::vector<geometry::DeformationGradient> gradients(count);
  std::vector<double> factor = garment.triangle_membrane_factor, weight(count);
  factor.resize(count, 1.0);
  for (std::size_t t = 0; t < count; ++t) {
    gradients[t] = garment_gradient(garment, static_cast<int>(t), positions);
    weight[t] = factor[t] * geometry::flat_area(garment.triangle_uv[t]);
  }
  const auto squares = [&](std::size_t t) -> Vec2 {
    return gradients[t].colwise().squaredNorm().transpose();
  };
  const fabric::StrainPatches patches =
      fabric::strain_patches(garment.triangles, garment.triangle_uv, factor, weight);
  std::vector<Vec2> mean(patches.patches.size(), Vec2::Zero());
  for (std::size_t p = 0; p < mean.size(); ++p) {
    const fabric::StrainPatch& patch = patches.patches[p];
    double sum = 0;
    for (int k = patch.first; k < patch.first + patch.count; ++k) {
      const int t = patches.triangle[k];
      if (!(weight[t] > 0)) continue;
      mean[p] += weight[t] * squares(t);
      sum += weight[t];
    }
    mean[p] /= sum;
  }
  std::vector<geometry::DeformationGradient> borne = gradients;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec2 own = squares(t);
    Vec2 of_corners = Vec2::Zero();
    for (int p : patches.at_corner[t]) of_corners += (p < 0 ? own : mean[p]) / 3;
    for (int c = 0; c < 2; ++c)
      if (own[c] > 0) borne[t].col(c) *= std::sqrt(of_corners[c] / own[c]);
  }
  return borne;
}

}  // namespace loosefit::maps
