#pragma once

namespace loosefit {

/// Largest resident memory of this process so far [MB = 10⁶ bytes]; 0 where it cannot be asked.
double peak_memory_mb();
/// Memory of the machine [MB = 10⁶ bytes]; 0 where it cannot be asked.
double physical_memory_mb();

}  // namespace loosefit
