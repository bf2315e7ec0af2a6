#pragma once

namespace loosefit::solver {

/// ‖F‖₂/‖W‖₂ below which cloth counts as at rest, unless something else is asked for [–]. The one
/// home of this number: options, certificates and scenarios take it from here.
inline constexpr double kRestTolerance = 1e-3;

}  // namespace loosefit::solver
