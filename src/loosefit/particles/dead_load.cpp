#include "loosefit/particles/dead_load.h"

namespace loosefit::particles {

double DeadLoad::value(const VectorField& x) const {
  double work = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) work += forces_[i].dot(x[i]);
  return -work;
}

void DeadLoad::add_gradient(const VectorField&, VectorField& g) const {
  for (std::size_t i = 0; i < forces_.size(); ++i) g[i] -= forces_[i];
}

}  // namespace loosefit::particles
