#include "method.h"

namespace loosefit::bakeoff {
namespace {

/// The program's own Newton.
class Default : public Method {
 public:
  explicit Default(const ParticleSystem& system) : newton_(system) {}
  Newton::Outcome iterate(VectorField& x, const VectorField& target, double dt) override {
    return newton_.iterate(x, target, dt);
  }
  void begin_step(const VectorField& x, double dt) override { newton_.begin_step(x, dt); }
  const VectorField& gradient(const VectorField& x) override { return newton_.gradient(x); }
  const SolverWork& work() const override { return newton_.work(); }

 private:
  Newton newton_;
};

template <class MakeRule>
auto factored(const FactoredOptions& options, MakeRule make_rule) {
  return [=](const ParticleSystem& system) { return make_factored(system, options, make_rule()); };
}

}  // namespace

std::vector<Candidate> candidates() {
  using Kind = MatrixUse::Kind;
  const auto either = Kind::exact_or_projected;
  const MatrixUse once{Kind::projected, 1, true}, laplacian{Kind::isotropic, 1, true};
  const auto use = [](MatrixUse matrix, bool curved = false) {
    return FactoredOptions{matrix, curved, 0.02};
  };
  return {
      {"default", "exact Hessian while definite, projected otherwise, factorised every iteration",
       3, [](const ParticleSystem& s) { return std::make_unique<Default>(s); }},
      {"projected", "projected Hessian, factorised every iteration", 3,
       factored(use({Kind::projected, 1, false}), make_plain)},
      {"reused-5", "a factor serves five iterations as it is", 5,
       factored(use({either, 5, false}), make_plain)},
      {"inexact-5", "a factor serves five iterations as preconditioner of CG on the exact Hessian",
       5, factored(use({either, 5, false}), [] { return make_inexact(0.1, 30); })},
      {"lbfgs-reused-5", "a factor serves five iterations, L-BFGS of six corrections", 5,
       factored(use({either, 5, false}), [] { return make_lbfgs(6); })},
      {"lbfgs-prefactored", "projected Hessian of the start for ever, L-BFGS of ten", 10,
       factored(use(once), [] { return make_lbfgs(10); })},
      {"lbfgs-isotropic", "Laplacian-like matrix of the start for ever, L-BFGS of ten", 10,
       factored(use(laplacian), [] { return make_lbfgs(10); })},
      {"anderson-isotropic", "local-global alternation with that matrix, Anderson of five", 10,
       factored(use(laplacian), [] { return make_anderson(5); })},
      {"conjugate-isotropic", "nonlinear conjugate gradients with that matrix", 10,
       factored(use(laplacian), make_conjugate)},
      {"curved", "as default, along second-order paths", 3,
       factored(use({either, 1, false}, true), make_plain)},
  };
}

}  // namespace loosefit::bakeoff
