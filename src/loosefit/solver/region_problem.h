#pragma once
#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/residual_region.h"
#include "loosefit/solver/tangent_matrix.h"

namespace loosefit::solver {

/// Newton's problem of one region, with all particles outside held where they are. The energies
/// must have been given the active set (ParticleSystem::set_active_set).
class RegionProblem : public NewtonProblem {
 public:
  RegionProblem(const ParticleSystem& system, const PrecisionTuning& tuning)
      : system_(system), linear_(tuning) {}

  /// Takes another region. tangent: lends its pattern and memory until the next call, and is left
  /// with a matrix of no use. order: elimination order of all particles.
  void set_region(ResidualRegion region, TangentMatrix& tangent, const std::vector<int>& order);
  const particles::ActiveSet& active_set() const { return active_set_; }

  double evaluate(const particles::VectorField& x, particles::VectorField& g) override;
  void restrict(particles::VectorField& force) const override;
  void assemble(const particles::VectorField& x, particles::HessianKind kind) override;
  bool factorise(double shift) override;
  void solve(const particles::VectorField& g, particles::VectorField& dx) override;
  double max_step(const particles::VectorField& x, const particles::VectorField& dx) override;

 private:
  const ParticleSystem& system_;
  TangentMatrix* tangent_ = nullptr;
  ResidualRegion region_;
  particles::ActiveSet active_set_;
  RestrictedBlocks blocks_;
  particles::BlockMatrix matrix_;  ///< of the region alone
  std::vector<double> shift_;      ///< shift times mass [kg/s²], of the region
  std::vector<char> held_;         ///< of the region
  NewtonSystem linear_;
};

}  // namespace loosefit::solver
