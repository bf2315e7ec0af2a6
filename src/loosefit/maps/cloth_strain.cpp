#include "loosefit/maps/cloth_strain.h"

#include <cmath>

#include "loosefit/maps/strain.h"

namespace loosefit::maps {

std::vector<fabric::MembraneEnergy::State> membrane_states(const garment::Garment& garment,
                                                           const std::vector<Vec3>& positions,
                                                           const fabric::Material& material) {
  return fabric::MembraneEnergy(garment.triangles, garment.triangle_uv,
                                garment.triangle_membrane_factor, material, false,
                                garment.triangle_added_bending)
      .states(positions);
}

std::vector<ClothStrain> cloth_strains(const garment::Garment& garment,
                                       const std::vector<Vec3>& positions,
                                       const fabric::Material& material) {
  const auto states = membrane_states(garment, positions, material);
  std::vector<ClothStrain> strains(states.size());
  for (std::size_t t = 0; t < states.size(); ++t) {
    ClothStrain& s = strains[t];
    s.shape = s.yarns = garment_gradient(garment, static_cast<int>(t), positions);
    s.wavelength = 2 * std::sqrt(geometry::flat_area(garment.triangle_uv[t]) / std::sqrt(3.0));
    for (int c = 0; c < 2; ++c) {
      const double seen = s.shape.col(c).norm();
      const double yarn = std::sqrt(seen * seen + 2 * states[t].crimp[c]);
      if (!(states[t].crimp[c] > 0)) continue;
      s.crimp[c] = 1 - seen / yarn;
      if (seen > 0) s.yarns.col(c) *= yarn / seen;
    }
  }
  return strains;
}

double crimp_angle(const Vec2& crimp) { return std::sqrt(2 * crimp.sum()); }

double crimp_amplitude(double crimp, double wavelength) {
  return wavelength / kPi * std::sqrt(crimp);
}

}  // namespace loosefit::maps
