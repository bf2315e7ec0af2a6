#pragma once

namespace loosefit::solver {

/// ‖F‖₂/‖W‖₂ below which cloth counts as at rest, unless something else is asked for [–]. The one
/// home of this number: options, certificates and scenarios take it from here.
inline constexpr double kRestTolerance = 1e-3;

/// max‖F_i‖ / mean‖W_i‖ up to which cloth counts as at rest [–]: a tenth of the weight of one
/// particle. A force that ‖F‖ leaves room for may sit on a single one, more of it the finer the
/// mesh is (1e-3 √n).
inline constexpr double kRestLargest = 0.1;

/// How near to rest a drape is to end, and how near it has come.
enum class RestGrade {
  /// The forces balance to kRestTolerance and kRestLargest.
  a,
  /// They balance to kRestToleranceB and kRestLargestB, and what is left to go is less than maps can mean by the
  /// estimate of the next Newton step: kLeftToMove, kLeftToTurn.
  b,
};

inline const char* name(RestGrade grade) { return grade == RestGrade::a ? "A" : "B"; }

/// ‖F‖₂/‖W‖₂ of grade B [–].
inline constexpr double kRestToleranceB = 0.02;
/// max‖F_i‖ / mean‖W_i‖ of grade B: as much larger than that of grade A as the tolerance is [–].
inline constexpr double kRestLargestB = kRestLargest * (kRestToleranceB / kRestTolerance);
/// Largest length of the exact Newton step, over particles [m], and largest turn of a normal by it,
/// at the 99th percentile of particles [rad]: a fiftieth of what the mesh and the choice of folds
/// leave open (docs/accuracy.md).
inline constexpr double kLeftToMove = 1e-4, kLeftToTurn = 0.2 * 3.14159265358979323846 / 180;

}  // namespace loosefit::solver
