#include <limits>

#include "loosefit/solver/newton.h"
#include "method.h"

namespace loosefit::bakeoff {
namespace {

/// The program's Newton with other tuning.
template <class Change>
auto newton(const Change& change) {
  return [=](const solver::ParticleSystem& system) {
    solver::SolverTuning tuning;
    change(tuning);
    return std::make_unique<solver::Newton>(system, tuning);
  };
}

template <class MakeRule>
auto factored(const FactoredOptions& options, MakeRule make_rule) {
  return [=](const solver::ParticleSystem& system) {
    return make_factored(system, options, make_rule());
  };
}

}  // namespace

std::vector<Candidate> candidates() {
  using Kind = MatrixUse::Kind;
  const auto either = Kind::exact_or_projected;
  const MatrixUse once{Kind::projected, 1, true}, laplacian{Kind::isotropic, 1, true};
  const auto use = [](MatrixUse matrix, bool curved = false) {
    return FactoredOptions{matrix, curved};
  };
  return {
      {"default", "the program's own Newton: its choice of matrices, its search, its regions", 3,
       [](const solver::ParticleSystem& s) { return std::make_unique<solver::Newton>(s); }},
      {"projected", "as default, with the projected Hessian alone", 3,
       newton([](solver::SolverTuning& t) {
         for (solver::MatrixTuning* m : {&t.matrix, &t.region.matrix})
           m->exact = m->half_compression = false;
       })},
      {"no-regions", "as default, without steps of regions", 3, newton([](solver::SolverTuning& t) {
         t.region.min_particles = std::numeric_limits<int>::max();
       })},
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
      {"curved", "exact Hessian or projected, along second-order paths", 3,
       factored(use({either, 1, false}, true), make_plain)},
  };
}

}  // namespace loosefit::bakeoff
