#pragma once
#include "loosefit/fabric/hinge_kernel.h"

namespace loosefit::fabric {

/// Rows of the blocks (0,0) (1,0) (1,1) … (3,3) of a hinge, column by column.
using HingeBlocks = std::array<particles::TileRow, 90>;

/// stiffness ∇θ∇θᵀ + moment ∇²θ.
///
/// With d_i = (δx_i − its foot on the edge moved along)/h_i, h_i the height of triangle i, and
/// e = (δx1 − δx0)/ℓ, in the directions n_i (normal), t_i (in the triangle, from the edge to the
/// free corner) and u (the edge):
///
///   δθ  = − Σ_i d_i·n_i
///   δ²θ = Σ_i [ 2 (d_i·t_i)(d_i·n_i) + 2 (d_i·u)(e·n_i) + (e·t_i)(e·n_i) ]
void hinge_blocks(const HingePoints& x, const particles::TileRow& stiffness,
                  const particles::TileRow& moment, HingeBlocks& out);

/// The same without its negative part in (d_1, d_2, e): for `stiffness` ≥ 0 a positive
/// semi-definite matrix for any angle and moment, the exact one where the moment is zero.
///
/// In d_± = (d_1 ± d_2)/√2 along and across, N the mean normal, T = N × u, c = cos θ/2 and
/// s = sin θ/2 the form falls into four of two variables each, with one positive eigenvalue:
///   (d₊ₙ, d₊ₜ): [2 stiffness, m; m, 0]        (d₋ₙ, d₋ₜ): [0, m; m, 0]
///   (e_N, d₊ᵤ): [−2 m s c, √2 m c; ·, 0]      (e_T, d₋ᵤ): [2 m s c, √2 m s; ·, 0]
/// The dimensionless d and e make the elementary forms independent of the shape of the triangles.
/// Compare Wu and Kim 2023, who take the eigenvectors in the plain coordinates.
void hinge_definite_blocks(const HingePoints& x, const particles::TileRow& stiffness,
                           const particles::TileRow& moment, HingeBlocks& out);

}  // namespace loosefit::fabric
