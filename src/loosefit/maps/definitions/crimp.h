#pragma once
#include <cmath>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Angle between the cloth and the body with the slope of waves below the mesh, in quadrature: the
/// slopes of both are independent of each other [rad].
inline std::vector<double> deviation_with_crimp(const MapInput& in) {
  std::vector<double> square;
  for (const ClothStrain& cloth : cloth_strains(in.garment, in.positions, *in.material))
    square.push_back(std::pow(crimp_angle(cloth.crimp), 2));
  std::vector<double> total = to_vertices(in.garment, square);
  for (std::size_t v = 0; v < total.size(); ++v)
    total[v] = std::hypot(angle_between(in.worn.normals[v], in.worn.partners[v].normal),
                          std::sqrt(total[v]));
  return total;
}

/// Waves of compressed cloth that are finer than the mesh (fabric/crimp_law.h).
inline MapDefinition crimp_map() {
  MapArray crimp{
      .style = {.array = "crimp",
                .title = "Crimp below the mesh",
                .range_high = 0.1,
                .map = "crimp",
                .decimals = 1,
                .percent = true},
      .meaning =
          "Share of the yarns' length that lies in waves finer than the mesh, of weft or "
          "warp, whichever is more: fine wrinkles of compressed cloth that no triangle "
          "shows. A strain sensor there is slack, a board lies on waves.",
      .formula = "1 − |F d| / λ, λ the stretch of the yarn, d = u or v",
      .source = "docs/decisions/0017-cloth-that-buckles-below-the-mesh.md",
      .read =
          ReadCloth([](const ClothStrain& cloth, const Vec2&) { return cloth.crimp.maxCoeff(); }),
      .metrics = {{"crimp", "share of length in waves finer than the mesh", OverFootprint::mean,
                   OverStates::reference}}};
  MapArray angle{
      .style = {.array = "crimp_angle_deg",
                .title = "Slope of waves below the mesh",
                .unit = "deg",
                .range_high = 40,
                .map = "crimp-angle",
                .pictured = false,
                .companion = true},
      .meaning = "Root mean square slope of the waves that the crimp of both yarns makes.",
      .formula = "θ = √(2 (c_weft + c_warp))",
      .source = "docs/decisions/0017-cloth-that-buckles-below-the-mesh.md",
      .read =
          ReadCloth([](const ClothStrain& cloth, const Vec2&) { return crimp_angle(cloth.crimp); }),
      .in_unit = in_degrees};
  MapArray amplitude{
      .style = {.array = "crimp_amplitude_mm",
                .title = "Amplitude of waves below the mesh",
                .unit = "mm",
                .range_high = 3,
                .map = "crimp-amplitude",
                .pictured = false,
                .companion = true},
      .meaning =
          "Amplitude of sine waves one mesh edge long that hide the greater crimp: about so far "
          "does the cloth stand off its triangle.",
      .formula = "(h/π) √c, h the edge of the mesh",
      .source = "docs/decisions/0017-cloth-that-buckles-below-the-mesh.md",
      .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
        return crimp_amplitude(cloth.crimp.maxCoeff(), cloth.wavelength);
      }),
      .in_unit = millimetres};
  MapArray total{
      .style = {.array = "angular_deviation_total_deg",
                .title = "Angular deviation with crimp",
                .unit = "deg",
                .range_high = 40,
                .map = "angular-deviation-total",
                .pictured = false,
                .companion = true},
      .meaning =
          "Angle between the garment's normal and the body's with the slope of the waves "
          "below the mesh: what a point of the cloth turns by, not a board that bridges "
          "the waves.",
      .formula = "√(AD² + θ²), θ² the mean of the triangles round the point",
      .source = "docs/decisions/0017-cloth-that-buckles-below-the-mesh.md",
      .read = ReadField(deviation_with_crimp),
      .in_unit = in_degrees};
  return {.name = "crimp",
          .arrays = {crimp, angle, amplitude, total},
          .by_default = true,
          .needs_material = true};
}

}  // namespace loosefit::maps
