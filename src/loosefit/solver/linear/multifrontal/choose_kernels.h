#pragma once

namespace loosefit::solver::dense {

/// Lets OpenBLAS compute on one thread and with the kernels that suit this processor; does so once,
/// at the first call, whichever thread makes it. Call it before the first dense kernel.
void choose_kernels();

}  // namespace loosefit::solver::dense
