#include "loosefit/maps/cloth_strain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/types.h"
#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

std::vector<Vec3> stretched(const garment::Garment& patch, double weft, double warp) {
  std::vector<Vec3> x;
  for (const Vec2& uv : patch.vertex_uv) x.emplace_back(weft * uv.x(), warp * uv.y(), 0);
  return x;
}

TEST(ClothStrain, OfStretchedClothIsThatOfItsMesh) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  for (const ClothStrain& s : cloth_strains(patch, stretched(patch, 1.03, 1.2), {})) {
    EXPECT_EQ((s.yarns - s.shape).norm(), 0);
    EXPECT_EQ(s.crimp, Vec2(0, 0));
  }
}

// Pushed together, the yarns keep their length and wave.
TEST(ClothStrain, OfPushedClothIsHiddenInWaves) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  for (const double squeezed : {0.99, 0.9, 0.6})
    for (const ClothStrain& s : cloth_strains(patch, stretched(patch, squeezed, 1), {})) {
      EXPECT_NEAR(s.crimp[0], 1 - squeezed, 3e-3);
      EXPECT_EQ(s.crimp[1], 0);
      EXPECT_NEAR(s.yarns.col(0).norm(), 1, 3e-3);
      EXPECT_NEAR(s.shape.col(0).norm(), squeezed, 1e-12);
    }
}

// The length of a sine wave, by adding up, against the crimp that its slope and amplitude stand
// for.
TEST(Crimp, StandsForTheSlopeAndAmplitudeOfASineWave) {
  const double wavelength = 0.012, amplitude = 0.0008;
  double length = 0, slope = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double s = 2 * kPi * amplitude / wavelength * std::cos(2 * kPi * (i + 0.5) / kSteps);
    length += std::sqrt(1 + s * s) * wavelength / kSteps;
    slope += std::pow(std::atan(s), 2) / kSteps;
  }
  const double crimp = 1 - wavelength / length;
  EXPECT_NEAR(crimp_amplitude(crimp, wavelength), amplitude, 0.05 * amplitude);
  EXPECT_NEAR(crimp_angle({crimp, 0}), std::sqrt(slope), 0.05 * std::sqrt(slope));
}

}  // namespace
}  // namespace loosefit::maps
