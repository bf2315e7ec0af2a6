#include "loosefit/fabric/hinge_kernel.h"

#include <cmath>

#include "loosefit/base/types.h"

namespace loosefit::fabric {
namespace {

/// atan2(y, x), zero at the origin. Rational approximation of Moshier 1989 (Cephes).
inline double arc_tangent(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  const double high = ax > ay ? ax : ay, low = ax > ay ? ay : ax;
  const bool far = low > 0.41421356237309503 * high;  // beyond tan π/8: from π/4
  const double below = far ? low + high : high;
  const double t = (far ? low - high : low) / (below > 0 ? below : 1.0);
  const double z = t * t;
  const double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
                     7.500855792314704667340e1) *
                        z -
                    1.228866684490136173410e2) *
                       z -
                   6.485021904942025371773e1;
  const double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
                     4.328810604912902668951e2) *
                        z +
                    4.853903996359136964868e2) *
                       z +
                   1.945506571482613964425e2;
  constexpr double kRest = 6.123233995736765886130e-17;  // of π/2 in double precision
  double angle = t * (z * (p / q)) + t;
  angle = far ? kPi / 4 + (angle + 0.5 * kRest) : angle;
  angle = ay > ax ? kPi / 2 - (angle - kRest) : angle;
  angle = x < 0 ? kPi - (angle - 2 * kRest) : angle;
  return y < 0 ? -angle : angle;
}

}  // namespace

LOOSEFIT_VECTORISED
void hinge_angles(const HingePoints& x, particles::TileRow& angle) {
  for (int i = 0; i < particles::kTile; ++i) {
    const double e0 = x[1][0][i] - x[0][0][i], e1 = x[1][1][i] - x[0][1][i],
                 e2 = x[1][2][i] - x[0][2][i];
    const double a0 = x[2][0][i] - x[0][0][i], a1 = x[2][1][i] - x[0][1][i],
                 a2 = x[2][2][i] - x[0][2][i];
    const double b0 = x[3][0][i] - x[0][0][i], b1 = x[3][1][i] - x[0][1][i],
                 b2 = x[3][2][i] - x[0][2][i];
    const double n0 = e1 * a2 - e2 * a1, n1 = e2 * a0 - e0 * a2, n2 = e0 * a1 - e1 * a0;
    const double m0 = b1 * e2 - b2 * e1, m1 = b2 * e0 - b0 * e2, m2 = b0 * e1 - b1 * e0;
    const double length = std::sqrt(e0 * e0 + e1 * e1 + e2 * e2);
    // (n × m)·e/|e| = −|e| n·b
    angle[i] = arc_tangent(-length * (n0 * b0 + n1 * b1 + n2 * b2), n0 * m0 + n1 * m1 + n2 * m2);
  }
}

LOOSEFIT_VECTORISED
void hinge_angles(const HingePoints& x, particles::TileRow& angle, HingeGradient& gradient) {
  for (int i = 0; i < particles::kTile; ++i) {
    const double e0 = x[1][0][i] - x[0][0][i], e1 = x[1][1][i] - x[0][1][i],
                 e2 = x[1][2][i] - x[0][2][i];
    const double a0 = x[2][0][i] - x[0][0][i], a1 = x[2][1][i] - x[0][1][i],
                 a2 = x[2][2][i] - x[0][2][i];
    const double b0 = x[3][0][i] - x[0][0][i], b1 = x[3][1][i] - x[0][1][i],
                 b2 = x[3][2][i] - x[0][2][i];
    const double n0 = e1 * a2 - e2 * a1, n1 = e2 * a0 - e0 * a2, n2 = e0 * a1 - e1 * a0;
    const double m0 = b1 * e2 - b2 * e1, m1 = b2 * e0 - b0 * e2, m2 = b0 * e1 - b1 * e0;
    const double square = e0 * e0 + e1 * e1 + e2 * e2, length = std::sqrt(square);
    angle[i] = arc_tangent(-length * (n0 * b0 + n1 * b1 + n2 * b2), n0 * m0 + n1 * m1 + n2 * m2);
    const double p = -length / (n0 * n0 + n1 * n1 + n2 * n2),
                 q = -length / (m0 * m0 + m1 * m1 + m2 * m2);
    gradient[0][i] = p * n0;
    gradient[1][i] = p * n1;
    gradient[2][i] = p * n2;
    gradient[3][i] = q * m0;
    gradient[4][i] = q * m1;
    gradient[5][i] = q * m2;
    gradient[6][i] = (a0 * e0 + a1 * e1 + a2 * e2) / square;
    gradient[7][i] = (b0 * e0 + b1 * e1 + b2 * e2) / square;
  }
}

LOOSEFIT_VECTORISED
void hinge_forces(const HingeGradient& gradient, const particles::TileRow& scale,
                  std::array<particles::TileRow, 12>& out) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < particles::kTile; ++i) {
      const double f2 = scale[i] * gradient[c][i], f3 = scale[i] * gradient[3 + c][i];
      const double f1 = -(gradient[6][i] * f2 + gradient[7][i] * f3);
      out[c][i] = -(f1 + f2 + f3);
      out[3 + c][i] = f1;
      out[6 + c][i] = f2;
      out[9 + c][i] = f3;
    }
}

}  // namespace loosefit::fabric
