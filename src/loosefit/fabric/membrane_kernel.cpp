#include "loosefit/fabric/membrane_kernel.h"

#include <cmath>

namespace loosefit::fabric {

LOOSEFIT_VECTORISED
void membrane_strain(const MembraneTile& tile, const TrianglePoints& x, MembraneStrain& out) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < particles::kTile; ++i) {
      // The gradients of the shape functions add up to zero.
      const double a = x[1][c][i] - x[0][c][i], b = x[2][c][i] - x[0][c][i];
      out.u[c][i] = tile.ru[1][i] * a + tile.ru[2][i] * b;
      out.v[c][i] = tile.rv[1][i] * a + tile.rv[2][i] * b;
    }
  const auto &u = out.u, &v = out.v;
  for (int i = 0; i < particles::kTile; ++i) {
    out.strain[0][i] = 0.5 * (u[0][i] * u[0][i] + u[1][i] * u[1][i] + u[2][i] * u[2][i] - 1);
    out.strain[1][i] = 0.5 * (v[0][i] * v[0][i] + v[1][i] * v[1][i] + v[2][i] * v[2][i] - 1);
    out.strain[2][i] = u[0][i] * v[0][i] + u[1][i] * v[1][i] + u[2][i] * v[2][i];
  }
}

LOOSEFIT_VECTORISED
void membrane_gradient(const MembraneTile& tile, const MembraneStrain& s, const PlaneRows& stress,
                       std::array<particles::TileRow, 9>& out) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < particles::kTile; ++i) {
      const double w = tile.weight[i];
      const double pu = w * (stress[0][i] * s.u[c][i] + stress[2][i] * s.v[c][i]);
      const double pv = w * (stress[2][i] * s.u[c][i] + stress[1][i] * s.v[c][i]);
      for (int a = 0; a < 3; ++a) out[3 * a + c][i] = tile.ru[a][i] * pu + tile.rv[a][i] * pv;
    }
}

LOOSEFIT_VECTORISED
void membrane_blocks(const MembraneTile& tile, const MembraneStrain& s, const PlaneRows& stress,
                     const PlaneTangent& c, double compression,
                     std::array<particles::TileRow, 54>& out) {
  // Geometric stiffness: w rᵃᵀ stress rᵇ on the diagonal of block (a, b).
  PlaneRows g;
  for (int i = 0; i < particles::kTile; ++i) {
    const double mean = 0.5 * (stress[0][i] + stress[1][i]),
                 half = 0.5 * (stress[0][i] - stress[1][i]), off = stress[2][i];
    const double radius = std::sqrt(half * half + off * off);
    // Positive part of a 2 × 2: (high + low)/2 on average, (high − low)/2 along (half, off).
    const double high = mean + radius, low = mean - radius;
    const double high_kept = high > 0 ? high : compression * high;
    const double low_kept = low > 0 ? low : compression * low;
    const double spread = 0.5 * (high_kept - low_kept) / (radius > 0 ? radius : 1.0);
    const double middle = 0.5 * (high_kept + low_kept);
    g[0][i] = middle + spread * half;
    g[1][i] = middle - spread * half;
    g[2][i] = spread * off;
  }
  // Blocks (1,1), (2,2), (2,1) are products of u and v:
  //   uuᵀ (C_uu a₁b₁ + C_ss a₂b₂) + vvᵀ (C_vv a₂b₂ + C_ss a₁b₁)
  // + uvᵀ (C_uv a₁b₂ + C_ss a₂b₁) + vuᵀ (C_uv a₂b₁ + C_ss a₁b₂),  a = (ru, rv) of the corner.
  constexpr int kOf[3][2] = {{1, 1}, {2, 2}, {2, 1}};
  constexpr int kPlace[3] = {18, 45, 36};
  for (int k = 0; k < 3; ++k) {
    const int a = kOf[k][0], b = kOf[k][1];
    particles::TileRow uu, vv, uv, vu, geometric;
    for (int i = 0; i < particles::kTile; ++i) {
      const double w = tile.weight[i];
      const double a1b1 = w * tile.ru[a][i] * tile.ru[b][i],
                   a2b2 = w * tile.rv[a][i] * tile.rv[b][i],
                   a1b2 = w * tile.ru[a][i] * tile.rv[b][i],
                   a2b1 = w * tile.rv[a][i] * tile.ru[b][i];
      uu[i] = c[0][i] * a1b1 + c[3][i] * a2b2;
      vv[i] = c[1][i] * a2b2 + c[3][i] * a1b1;
      uv[i] = c[2][i] * a1b2 + c[3][i] * a2b1;
      vu[i] = c[2][i] * a2b1 + c[3][i] * a1b2;
      geometric[i] = g[0][i] * a1b1 + g[1][i] * a2b2 + g[2][i] * (a1b2 + a2b1);
    }
    for (int q = 0; q < 3; ++q)
      for (int p = 0; p < 3; ++p)
        for (int i = 0; i < particles::kTile; ++i)
          out[kPlace[k] + 3 * q + p][i] = (uu[i] * s.u[p][i] + vu[i] * s.v[p][i]) * s.u[q][i] +
                                          (uv[i] * s.u[p][i] + vv[i] * s.v[p][i]) * s.v[q][i] +
                                          (p == q ? geometric[i] : 0.0);
  }
  // A translation changes nothing: the blocks of a row add up to zero.
  for (int q = 0; q < 3; ++q)
    for (int p = 0; p < 3; ++p) {
      const int pq = 3 * q + p, qp = 3 * p + q;
      for (int i = 0; i < particles::kTile; ++i) {
        out[9 + pq][i] = -(out[18 + pq][i] + out[36 + qp][i]);
        out[27 + pq][i] = -(out[36 + pq][i] + out[45 + pq][i]);
      }
    }
  for (int q = 0; q < 3; ++q)
    for (int p = 0; p < 3; ++p) {
      const int pq = 3 * q + p;
      for (int i = 0; i < particles::kTile; ++i) out[pq][i] = -(out[9 + pq][i] + out[27 + pq][i]);
    }
}

}  // namespace loosefit::fabric
