#pragma once
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// Whether the equilibrium at bench.x is stable: the exact second derivative of the potential, held
/// vertices left out, is positive definite (a Cholesky factor exists).
bool is_stable(Bench& bench);

/// The load factor at which `stable(factor)` turns from true to false, by bisection between `low`
/// (stable) and `high` (not stable) to a relative width of `tolerance`; NaN when the ends are not
/// so. \throws what `stable` throws.
double critical_factor(const std::function<bool(double)>& stable, double low, double high,
                       double tolerance = 1e-3);

}  // namespace loosefit::validate
