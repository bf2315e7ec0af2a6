#pragma once
#include <cmath>

#include "loosefit/particles/energy.h"
#include "loosefit/particles/vector_sums.h"

namespace loosefit::bakeoff {

using loosefit::dot;

inline double norm(const VectorField& a) { return std::sqrt(dot(a, a)); }

/// to += factor · a
inline void add(double factor, const VectorField& a, VectorField& to) {
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += factor * a[i];
}

inline VectorField difference(const VectorField& a, const VectorField& b) {
  VectorField d = a;
  add(-1, b, d);
  return d;
}

}  // namespace loosefit::bakeoff
