#include "loosefit/fabric/patch_kernel.h"

namespace loosefit::fabric {

LOOSEFIT_VECTORISED
static void multiply(const std::array<PlaneRows, 9>& s,
                     const std::array<particles::TileRow, 9>& theta, PlaneRows& out) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < particles::kTile; ++i)
      out[c][i] = ((s[0][c][i] * theta[0][i] + s[1][c][i] * theta[1][i]) +
                   (s[2][c][i] * theta[2][i] + s[3][c][i] * theta[3][i])) +
                  ((s[4][c][i] * theta[4][i] + s[5][c][i] * theta[5][i]) +
                   (s[6][c][i] * theta[6][i] + s[7][c][i] * theta[7][i])) +
                  s[8][c][i] * theta[8][i];
}

void patch_curvature(const PatchTile& tile, const double* angle, PlaneRows& curvature) {
  std::array<particles::TileRow, 9> theta;
  for (int k = 0; k < 9; ++k)
    for (int i = 0; i < particles::kTile; ++i) theta[k][i] = angle[tile.hinge[k][i]];
  multiply(tile.s, theta, curvature);
}

LOOSEFIT_VECTORISED
void patch_moments(const PatchTile& tile, const PlaneRows& stress,
                   std::array<particles::TileRow, 9>& out) {
  for (int k = 0; k < 9; ++k)
    for (int i = 0; i < particles::kTile; ++i)
      out[k][i] = tile.s[k][0][i] * stress[0][i] + tile.s[k][1][i] * stress[1][i] +
                  tile.s[k][2][i] * stress[2][i];
}

}  // namespace loosefit::fabric
