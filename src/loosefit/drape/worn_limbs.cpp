#include "loosefit/drape/worn_limbs.h"

namespace loosefit {

std::vector<LimbNumbers> limbs_through_openings(const std::vector<Triangle>& triangles,
                                                const std::vector<Vec3>& x, const Body& body) {
  const LimbLines lines = limb_lines(body);
  std::vector<LimbNumbers> numbers;
  if (lines[kHead].empty()) return numbers;
  for (const std::vector<int>& loop : boundary_loops(triangles))
    numbers.push_back(limbs_through(loop, x, lines));
  return numbers;
}

}  // namespace loosefit
