#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::particles {

/// Σ a_i · b_i, in the order of the particles.
inline double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace loosefit::particles
