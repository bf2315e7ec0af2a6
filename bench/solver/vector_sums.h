#pragma once
#include <cmath>

#include "loosefit/particles/energy.h"
#include "loosefit/particles/vector_sums.h"

namespace loosefit::bakeoff {

using loosefit::particles::dot;

inline double norm(const particles::VectorField& a) { return std::sqrt(particles::dot(a, a)); }

/// to += factor · a
inline void add(double factor, const particles::VectorField& a, particles::VectorField& to) {
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += factor * a[i];
}

inline particles::VectorField difference(const particles::VectorField& a,
                                         const particles::VectorField& b) {
  particles::VectorField d = a;
  add(-1, b, d);
  return d;
}

}  // namespace loosefit::bakeoff
