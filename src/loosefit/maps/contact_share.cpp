#include "loosefit/maps/contact_share.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/maps/gap.h"

namespace loosefit::maps {

ContactShare contact_share_of_pressed_area(const std::vector<Triangle>& triangles,
                                           const std::vector<Vec3>& x,
                                           const PressureField& pressure,
                                           const body::PosedBody& body,
                                           const fabric::Material& material) {
  constexpr int kIntervals = 6;  // 28 places a triangle
  const double reach = 0.5 * material.thickness + 2 * contact_tolerance(material);
  struct Sum {
    double pressed = 0, places = 0, triangle = 0;
  };
  std::vector<Sum> of(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t t) {
    const Triangle& corner = triangles[t];
    Vec3 pressed;
    for (int k = 0; k < 3; ++k) pressed[k] = pressure.contact[corner[k]] > 0;
    if (pressed.isZero()) return;
    bool touching = false;
    const double area = geometry::triangle_area(x[corner[0]], x[corner[1]], x[corner[2]]);
    for (int i = 0; i <= kIntervals; ++i)
      for (int j = 0; i + j <= kIntervals; ++j) {
        const Vec3 b = Vec3(i, j, kIntervals - i - j) / kIntervals;
        const int zeros = (i == 0) + (j == 0) + (i + j == kIntervals);
        // Composite trapezoidal rule: corners, edges and inner places of the lattice.
        const double share = zeros == 2 ? 1 : zeros == 1 ? 3 : 6;
        const double weight = area * share / (3 * kIntervals * kIntervals) * b.dot(pressed);
        of[t].pressed += weight;
        const double distance =
            body.tree()
                .query(b[0] * x[corner[0]] + b[1] * x[corner[1]] + b[2] * x[corner[2]], reach)
                .distance;
        if (!touches(gap_of(distance, material), material)) continue;
        of[t].places += weight;
        touching = true;
      }
    if (touching) of[t].triangle = of[t].pressed;
  });
  Sum sum;
  for (const Sum& s : of)
    sum.pressed += s.pressed, sum.places += s.places, sum.triangle += s.triangle;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!(sum.pressed > 0)) return {kNan, kNan};
  return {sum.places / sum.pressed, sum.triangle / sum.pressed};
}

}  // namespace loosefit::maps
