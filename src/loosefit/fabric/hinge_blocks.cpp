#include "loosefit/fabric/hinge_blocks.h"

#include <cmath>

namespace loosefit::fabric {
namespace {

using Row3 = std::array<particles::TileRow, 3>;

/// Directions and lengths of a tile of hinges; index 0: triangle with x2, 1: with x3.
struct Frame {
  Row3 u, n[2], t[2];
  particles::TileRow per_length, share[2], per_height[2];
};

/// Where entry (row, column) of block (a, b), a ≥ b, stands in HingeBlocks.
constexpr int place(int a, int b, int row, int column) {
  return 9 * (a * (a + 1) / 2 + b) + 3 * column + row;
}

}  // namespace

LOOSEFIT_VECTORISED
static void hinge_frame(const HingePoints& x, Frame& f) {
  particles::TileRow square;
  for (int i = 0; i < particles::kTile; ++i) {
    const double e0 = x[1][0][i] - x[0][0][i], e1 = x[1][1][i] - x[0][1][i],
                 e2 = x[1][2][i] - x[0][2][i];
    square[i] = e0 * e0 + e1 * e1 + e2 * e2;
    const double per = 1 / std::sqrt(square[i]);
    f.per_length[i] = per;
    f.u[0][i] = per * e0;
    f.u[1][i] = per * e1;
    f.u[2][i] = per * e2;
  }
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < particles::kTile; ++i) {
      const double u0 = f.u[0][i], u1 = f.u[1][i], u2 = f.u[2][i];
      const double a0 = x[2 + k][0][i] - x[0][0][i], a1 = x[2 + k][1][i] - x[0][1][i],
                   a2 = x[2 + k][2][i] - x[0][2][i];
      const double along = a0 * u0 + a1 * u1 + a2 * u2;
      f.share[k][i] = along * f.per_length[i];
      const double h0 = a0 - along * u0, h1 = a1 - along * u1, h2 = a2 - along * u2;
      const double per = 1 / std::sqrt(h0 * h0 + h1 * h1 + h2 * h2);
      f.per_height[k][i] = per;
      const double t0 = per * h0, t1 = per * h1, t2 = per * h2;
      f.t[k][0][i] = t0;
      f.t[k][1][i] = t1;
      f.t[k][2][i] = t2;
      const double side = k == 0 ? 1 : -1;  // n = u × t, for the second triangle t × u
      f.n[k][0][i] = side * (u1 * t2 - u2 * t1);
      f.n[k][1][i] = side * (u2 * t0 - u0 * t2);
      f.n[k][2][i] = side * (u0 * t1 - u1 * t0);
    }
}

/// Blocks with point 0 from the others: a translation changes nothing.
LOOSEFIT_VECTORISED
static void complete(HingeBlocks& out) {
  for (int q = 0; q < 3; ++q)
    for (int p = 0; p < 3; ++p)
      for (int i = 0; i < particles::kTile; ++i) {
        out[place(1, 0, p, q)][i] =
            -(out[place(1, 1, p, q)][i] + out[place(2, 1, q, p)][i] + out[place(3, 1, q, p)][i]);
        out[place(2, 0, p, q)][i] =
            -(out[place(2, 1, p, q)][i] + out[place(2, 2, p, q)][i] + out[place(3, 2, q, p)][i]);
        out[place(3, 0, p, q)][i] =
            -(out[place(3, 1, p, q)][i] + out[place(3, 2, p, q)][i] + out[place(3, 3, p, q)][i]);
      }
  for (int q = 0; q < 3; ++q)
    for (int p = 0; p < 3; ++p)
      for (int i = 0; i < particles::kTile; ++i)
        out[place(0, 0, p, q)][i] =
            -(out[place(1, 0, p, q)][i] + out[place(2, 0, p, q)][i] + out[place(3, 0, p, q)][i]);
}

LOOSEFIT_VECTORISED
void hinge_blocks(const HingePoints& x, const particles::TileRow& stiffness,
                  const particles::TileRow& moment, HingeBlocks& out) {
  Frame f;
  hinge_frame(x, f);
  Row3 g1;  // ∂θ/∂x1
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < particles::kTile; ++i)
      g1[c][i] = f.share[0][i] * f.per_height[0][i] * f.n[0][c][i] +
                 f.share[1][i] * f.per_height[1][i] * f.n[1][c][i];
  for (int q = 0; q < 3; ++q)
    for (int p = 0; p < 3; ++p)
      for (int i = 0; i < particles::kTile; ++i) {
        const double k = stiffness[i], m = moment[i], l = f.per_length[i];
        const double h = f.per_height[0][i], j = f.per_height[1][i];
        const double s = f.share[0][i], r = f.share[1][i];
        const double n = f.n[0][q][i], o = f.n[1][q][i];
        // T = t nᵀ + n tᵀ
        const double t = m * (f.t[0][p][i] * n + f.n[0][p][i] * f.t[0][q][i]);
        const double v = m * (f.t[1][p][i] * o + f.n[1][p][i] * f.t[1][q][i]);
        const double un = m * f.u[p][i] * n, uo = m * f.u[p][i] * o;
        const double nu = m * f.n[0][p][i] * f.u[q][i], ou = m * f.n[1][p][i] * f.u[q][i];
        out[place(2, 2, p, q)][i] = h * h * (k * f.n[0][p][i] * n + t);
        out[place(3, 3, p, q)][i] = j * j * (k * f.n[1][p][i] * o + v);
        out[place(3, 2, p, q)][i] = h * j * k * f.n[1][p][i] * n;
        out[place(2, 1, p, q)][i] = h * (un * l - s * h * t - k * f.n[0][p][i] * g1[q][i]);
        out[place(3, 1, p, q)][i] = j * (uo * l - r * j * v - k * f.n[1][p][i] * g1[q][i]);
        out[place(1, 1, p, q)][i] = k * g1[p][i] * g1[q][i] + (s * s * h * h + 0.5 * l * l) * t +
                                    (r * r * j * j + 0.5 * l * l) * v -
                                    l * (s * h * (un + nu) + r * j * (uo + ou));
      }
  complete(out);
}

LOOSEFIT_VECTORISED
void hinge_definite_blocks(const HingePoints& x, const particles::TileRow& stiffness,
                           const particles::TileRow& moment, HingeBlocks& out) {
  Frame f;
  hinge_frame(x, f);
  // y[r][a]: the matrix is Σ_r y_r y_rᵀ over the points a = 1, 2, 3.
  std::array<std::array<Row3, 3>, 4> y;
  for (int i = 0; i < particles::kTile; ++i) {
    const double k = stiffness[i], m = moment[i];
    const double u[3] = {f.u[0][i], f.u[1][i], f.u[2][i]};
    const double n[3] = {f.n[0][0][i], f.n[0][1][i], f.n[0][2][i]};
    const double o[3] = {f.n[1][0][i], f.n[1][1][i], f.n[1][2][i]};
    const double cosine = n[0] * o[0] + n[1] * o[1] + n[2] * o[2];
    // N along n + o; where that is short, perpendicular to n − o.
    const double sign = cosine > 0 ? 1 : -1;
    const double w[3] = {n[0] + sign * o[0], n[1] + sign * o[1], n[2] + sign * o[2]};
    const double per = 1 / std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    const double a[3] = {per * w[0], per * w[1], per * w[2]};
    const double across[3] = {a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2],
                              a[0] * u[1] - a[1] * u[0]};
    double big_n[3], big_t[3];
    for (int c = 0; c < 3; ++c) {
      big_n[c] = cosine > 0 ? a[c] : across[c];
      big_t[c] = cosine > 0 ? across[c] : -a[c];
    }
    const double c = n[0] * big_n[0] + n[1] * big_n[1] + n[2] * big_n[2];
    const double s = n[0] * big_t[0] + n[1] * big_t[1] + n[2] * big_t[2];

    // Eigenvalue λ > 0 of [p, q; q, 0] and √λ times its unit eigenvector (λ, q)/√(λ² + q²).
    constexpr double kRoot2 = 1.41421356237309515, kHalf = 0.70710678118654757;
    const double ps[4] = {2 * k, 0, -2 * m * s * c, 2 * m * s * c};
    const double qs[4] = {m, m, kRoot2 * m * c, kRoot2 * m * s};
    double first[4], second[4];
    for (int r = 0; r < 4; ++r) {
      const double p = ps[r], q = qs[r];
      const double lambda = 0.5 * (p + std::sqrt(p * p + 4 * q * q));
      const double square = lambda * lambda + q * q;
      const double scale = std::sqrt(lambda / (square > 0 ? square : 1.0));
      first[r] = scale * lambda;
      second[r] = scale * q;
    }
    const double h = kHalf * f.per_height[0][i], j = kHalf * f.per_height[1][i];
    const double hs = -f.share[0][i] * h, js = -f.share[1][i] * j, l = f.per_length[i];
    for (int d = 0; d < 3; ++d) {
      const double t = f.t[0][d][i], v = f.t[1][d][i];
      for (int r = 0; r < 2; ++r) {
        const double here = first[r] * n[d] + second[r] * t;
        const double there = (r == 0 ? 1 : -1) * (first[r] * o[d] + second[r] * v);
        y[r][0][d][i] = hs * here + js * there;
        y[r][1][d][i] = h * here;
        y[r][2][d][i] = j * there;
      }
      const double plus = second[2] * u[d], minus = second[3] * u[d];
      y[2][0][d][i] = l * first[2] * big_n[d] + (hs + js) * plus;
      y[2][1][d][i] = h * plus;
      y[2][2][d][i] = j * plus;
      y[3][0][d][i] = l * first[3] * big_t[d] + (hs - js) * minus;
      y[3][1][d][i] = h * minus;
      y[3][2][d][i] = -j * minus;
    }
  }
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      for (int q = 0; q < 3; ++q)
        for (int p = 0; p < 3; ++p)
          for (int i = 0; i < particles::kTile; ++i)
            out[place(a + 1, b + 1, p, q)][i] =
                y[0][a][p][i] * y[0][b][q][i] + y[1][a][p][i] * y[1][b][q][i] +
                y[2][a][p][i] * y[2][b][q][i] + y[3][a][p][i] * y[3][b][q][i];
  complete(out);
}

}  // namespace loosefit::fabric
