#pragma once

namespace loosefit::solver {

/// Eliminates the first p rows of a dense symmetric front of p + r rows. `f`: its first p columns,
/// column major, lower triangle; becomes their Cholesky factor. `border`: r × r, lower triangle;
/// has what they pass on subtracted. Large fronts are cut into blocks of a fixed size, which are
/// worked on side by side; the bits do not depend on the number of threads. False when the leading
/// block is not positive definite.
template <class Real>
bool eliminate_front(Real* f, int p, int r, Real* border);

/// Blocks of so many rows and columns along the diagonal of either array are read and written
/// whole, the part above the diagonal included.
int diagonal_block(int p, int r);

}  // namespace loosefit::solver
