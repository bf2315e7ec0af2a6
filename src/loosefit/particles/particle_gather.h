#pragma once
#include <vector>

#include "loosefit/particles/active_set.h"
#include "loosefit/particles/energy.h"

namespace loosefit::particles {

/// Adds the forces at the corners of elements to their particles on all threads; every particle
/// adds its own in the order of the elements, so the bits do not depend on the threads.
class ParticleGather {
 public:
  /// `particle[c]`: where corner c (all elements one after the other) sends its force; −1: nowhere.
  explicit ParticleGather(const std::vector<int>& particle = {});
  /// g[particle[c]] += force[c].
  void add(const std::vector<Vec3>& force, VectorField& g) const;
  /// The same for the particles of the active set alone; for all if that is null.
  void add(const std::vector<Vec3>& force, VectorField& g, const ActiveSet* active_set) const;

 private:
  void add_to(int particle, const std::vector<Vec3>& force, VectorField& g) const;
  std::vector<int> start_{0};  ///< per particle
  std::vector<int> corner_;
};

}  // namespace loosefit::particles
