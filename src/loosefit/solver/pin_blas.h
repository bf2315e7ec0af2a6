#pragma once

namespace loosefit::solver {

/// OpenBLAS reads its settings while it is loaded, before main: starts the program over, once, with
/// one thread (a second only slows our small fronts down and would make sums depend on the machine)
/// and with the kernels named that suit this processor. `arguments`: argv of main.
void pin_blas(char** arguments);

}  // namespace loosefit::solver
