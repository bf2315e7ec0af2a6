#include "loosefit/fabric/plane_law.h"

namespace loosefit::fabric {

LOOSEFIT_VECTORISED
void add_quadratic(const PlaneTangent& c, const PlaneRows& strain, const PlaneRows& start,
                   double share, PlaneResponse& out) {
  for (int i = 0; i < particles::kTile; ++i) {
    const double d0 = strain[0][i] - start[0][i], d1 = strain[1][i] - start[1][i],
                 d2 = strain[2][i] - start[2][i];
    const double s0 = share * (c[0][i] * d0 + c[2][i] * d1);
    const double s1 = share * (c[2][i] * d0 + c[1][i] * d1);
    const double s2 = share * (c[3][i] * d2);
    out.energy[i] += 0.5 * (s0 * d0 + s1 * d1 + s2 * d2);
    out.stress[0][i] += s0;
    out.stress[1][i] += s1;
    out.stress[2][i] += s2;
  }
}

}  // namespace loosefit::fabric
