#pragma once

namespace loosefit::solver {

/// ‖F‖₂/‖W‖₂ below which cloth counts as at rest, unless something else is asked for [–]. The one
/// home of this number: options, certificates and scenarios take it from here.
inline constexpr double kRestTolerance = 1e-3;

/// max‖F_i‖ / mean‖W_i‖ up to which cloth counts as at rest [–]: a tenth of the weight of one
/// particle. A force that ‖F‖ leaves room for may sit on a single one, more of it the finer the
/// mesh is (1e-3 √n).
inline constexpr double kRestLargest = 0.1;

}  // namespace loosefit::solver
