#include "loosefit/solver/region_problem.h"

#include <utility>

namespace loosefit::solver {

void RegionProblem::set_region(ResidualRegion region, TangentMatrix& tangent,
                               const std::vector<int>& order) {
  region_ = std::move(region);
  tangent_ = &tangent;
  active_set_.particles = region_.particles;
  active_set_.inside.assign(region_.index.size(), 0);
  for (int i : region_.particles) active_set_.inside[i] = 1;
  held_.clear();
  if (!system_.held.empty())
    for (int i : region_.particles) held_.push_back(system_.held[i]);
  blocks_.of_pattern = 0;
  // An order that leaves little fill for all particles does so for some of them.
  std::vector<int> part;
  for (int i : order)
    if (region_.index[i] >= 0) part.push_back(region_.index[i]);
  linear_.set_order(part);
}

double RegionProblem::evaluate(const particles::VectorField& x, particles::VectorField& g) {
  return system_.potential_and_gradient(x, g);
}

void RegionProblem::restrict(particles::VectorField& force) const {
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!active_set_.inside[i]) force[i].setZero();
}

void RegionProblem::assemble(const particles::VectorField& x, particles::HessianKind kind) {
  tangent_->assemble(x, kind, active_set_);
  restrict_to(region_, tangent_->matrix(), matrix_, blocks_);
}

bool RegionProblem::factorise(double shift) {
  shift_.clear();
  for (int i : region_.particles) shift_.push_back(shift * system_.mass[i]);
  return linear_.factorise(matrix_, shift_, held_);
}

void RegionProblem::solve(const particles::VectorField& g, particles::VectorField& dx) {
  particles::VectorField force, step;
  for (int i : region_.particles) force.push_back(g[i]);
  linear_.solve(force, step);
  dx.assign(g.size(), Vec3::Zero());
  for (std::size_t k = 0; k < step.size(); ++k) dx[region_.particles[k]] = step[k];
}

double RegionProblem::max_step(const particles::VectorField& x, const particles::VectorField& dx) {
  return system_.max_step(x, dx);
}

}  // namespace loosefit::solver
