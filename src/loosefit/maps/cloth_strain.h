#pragma once
#include <vector>

#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/garment/garment.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::maps {

/// How the cloth of one triangle is deformed. Compressed yarns buckle in waves below the mesh
/// (fabric/crimp_law.h): the triangle is then shorter than the yarns in it.
struct ClothStrain {
  /// F of the mesh, from pattern (u weft, v warp) to space.
  geometry::DeformationGradient shape;
  /// The same with columns as long as the yarns, waves drawn straight: what cloth bears.
  geometry::DeformationGradient yarns;
  Vec2 crimp =
      Vec2::Zero();       ///< share of the length of weft and warp that lies in such waves, 0 … 1
  double wavelength = 0;  ///< of the waves, the edge of an equilateral triangle of its area [m]
};

/// Strain, stress and crimp of every triangle, as the drape's membrane sees them. \throws
/// GeometryError for one without flat area.
std::vector<fabric::MembraneEnergy::State> membrane_states(const garment::Garment& garment,
                                                           const std::vector<Vec3>& positions,
                                                           const fabric::Material& material);

/// Of every triangle. \throws as membrane_states.
std::vector<ClothStrain> cloth_strains(const garment::Garment& garment,
                                       const std::vector<Vec3>& positions,
                                       const fabric::Material& material);

/// Root mean square slope of a wave that hides the shares `crimp` of both directions [rad]: the
/// length of a wave of small slope θ exceeds its base by mean(θ²)/2.
double crimp_angle(const Vec2& crimp);
/// Amplitude of a sine wave of length λ [m] that hides the share c of the yarn: (λ/π) √c [m].
double crimp_amplitude(double crimp, double wavelength);

}  // namespace loosefit::maps
