#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/solver/particle_system.h"

namespace loosefit::bakeoff {

/// A cloth with its contacts at a start; every race gets a new one, with the same bits.
struct World {
  std::shared_ptr<void> owner;  ///< keeps the energies alive
  const solver::ParticleSystem* system = nullptr;
  particles::VectorField x;
};

struct Problem {
  std::string name, what;
  int vertices = 0;
  double first_dt = 0.5;  ///< first pseudo-step [s]
  std::function<World()> make;
};

std::vector<std::string> problem_names();
/// One of problem_names(); dressing takes a while. \throws std::out_of_range
Problem make_problem(const std::string& name);

}  // namespace loosefit::bakeoff
