#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "direction_rule.h"
#include "loosefit/solver/descent_method.h"

namespace loosefit::bakeoff {

/// Which matrix is factorised, and how long a factor serves.
struct MatrixUse {
  enum class Kind {
    exact_or_projected,  ///< exact where it is definite, projected otherwise
    projected,
    /// The projected one with each 3 x 3 block B replaced by tr(B) I: positive semi-definite, blind
    /// to how elements turn, and never softer; the constant matrix of projective dynamics.
    isotropic,
  } kind = Kind::exact_or_projected;
  int iterations_per_factor = 1;
  /// The matrix of the first iteration for ever; it is factorised anew only when the pseudo-step
  /// has changed by more than a factor of two.
  bool constant = false;
};

/// Line-searched descent with a direction rule on factors that may be old.
struct FactoredOptions {
  MatrixUse matrix;
  /// Second-order path by differences of the gradient (Transtrum, Sethna 2012).
  bool curved = false;
};
std::unique_ptr<solver::DescentMethod> make_factored(const solver::ParticleSystem& system,
                                                     const FactoredOptions& options,
                                                     std::unique_ptr<DirectionRule> rule);

/// A method of the contest.
struct Candidate {
  std::string name, what;
  int per_step = 3;  ///< iterations between two renewals of friction and contacts, at first
  std::function<std::unique_ptr<solver::DescentMethod>(const solver::ParticleSystem&)> make;
};
std::vector<Candidate> candidates();

}  // namespace loosefit::bakeoff
