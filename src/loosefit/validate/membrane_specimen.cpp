#include "loosefit/validate/membrane_specimen.h"

#include <algorithm>
#include <cmath>

namespace loosefit::validate {

fabric::Material orthotropic_fabric() {
  fabric::Material m;
  m.stiffness_weft = 300;
  m.stiffness_warp = 700;
  m.poisson = 0.25;
  m.stiffness_shear = 60;
  return m;
}

fabric::Material engineering_fabric() {
  fabric::Material m = orthotropic_fabric();
  m.poisson = 0;
  for (double e : {0.2, 0.4, 0.6}) {
    m.curve_weft.push_back({e, m.stiffness_weft * e});
    m.curve_warp.push_back({e, m.stiffness_warp * e});
  }
  return m;
}

void roughen(Specimen& specimen, double edge) {
  Vec2 low = specimen.vertex_uv.front(), high = low;
  for (const Vec2& p : specimen.vertex_uv) low = low.cwiseMin(p), high = high.cwiseMax(p);
  for (std::size_t i = 0; i < specimen.vertex_uv.size(); ++i) {
    Vec2& p = specimen.vertex_uv[i];
    if (std::min((p - low).minCoeff(), (high - p).minCoeff()) < 1e-9) continue;
    // A quasi-random direction and length per vertex (multiples of two irrational numbers).
    const double n = static_cast<double>(i);
    const double turn = 2 * kPi * std::fmod(n * 0.6180339887498949, 1.0);
    const double reach = 0.25 * edge * std::fmod(n * 0.7548776662466927, 1.0);
    p += reach * Vec2(std::cos(turn), std::sin(turn));
  }
  for (std::size_t t = 0; t < specimen.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      specimen.triangle_uv[t][k] = specimen.vertex_uv[specimen.triangles[t][k]];
}

}  // namespace loosefit::validate
