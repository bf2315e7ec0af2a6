#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// How a strain is drawn and told: fixed, so that pictures of different garments and people can be
/// compared; 2 decimals of a per cent.
inline MapArrayStyle strain_style(const char* array, const char* title, const char* picture) {
  return {.array = array,
          .title = title,
          .range_low = -0.05,
          .range_high = 0.05,
          .map = picture,
          .diverging = true,
          .decimals = 2,
          .percent = true};
}

/// Yarn strain: what a lead or a strain sensor along the yarns feels (maps/strain.h).
inline MapDefinition strain_map() {
  MapArray warp{
      .style = strain_style("strain_warp", "Strain along warp", "strain-warp"),
      .meaning =
          "Engineering strain along the grain: what a lead or a strain sensor sewn along the "
          "warp feels. Above zero the yarns are stretched. Compressed yarns buckle in fine waves: "
          "the map crimp shows these, and here the yarn keeps its own small compression. Free of "
          "the mesh's edge directions. Under a sensor it is read along the sensor's own "
          "direction.",
      .formula =
          "|F v| − 1, F = ∂x/∂(u, v) from pattern (weft u, warp v) to space, waves drawn straight",
      .source = "docs/theory/sensor_metrics.md 6",
      .read = ReadCloth([](const ClothStrain& cloth, const Vec2& along) {
        return strain_along(cloth.yarns, along);
      }),
      .along_sensor = true,
      .metrics = {{"strain", "strain along the sensor", OverFootprint::mean, OverStates::reference},
                  {"strain_swing", "range of the strain over postures", OverFootprint::mean,
                   OverStates::swing}}};
  MapArray weft{.style = strain_style("strain_weft", "Strain along weft", "strain-weft"),
                .meaning =
                    "Engineering strain across the grain: what a lead along the weft feels, with "
                    "the same sign.",
                .formula = "|F u| − 1",
                .source = "docs/theory/sensor_metrics.md 6",
                .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
                  return triangle_strain(cloth.yarns).weft;
                })};
  return {.name = "strain", .arrays = {warp, weft}, .by_default = true, .needs_material = true};
}

/// Strains in directions that the cloth chooses, not the sensor, and the paper's one; made wherever
/// yarn strain is.
inline MapDefinition principal_strain_map() {
  MapArray vertical{
      .style = strain_style("strain_vertical", "Vertical strain", "strain"),
      .meaning =
          "The paper's form of the strain along warp: elongation of the mesh edges round a point, "
          "weighted by cos² of their angle to the grain, so that some shear is mixed in. Above "
          "zero the cloth is stretched along the grain, which hangs vertically in the body of a "
          "shirt and runs along the arm in a sleeve.",
      .formula =
          "ε = Σ w (|x_j − x_i| − L) / L / Σ w, w = cos²(edge, grain), L in the flat pattern",
      .source = "Harms, Amft and Tröster 2012, section 2.2",
      .read =
          ReadField([](const MapInput& in) { return vertical_strain(in.garment, in.positions); })};
  MapArray max{.style = strain_style("strain_max", "Greatest principal strain", "strain-max"),
               .meaning =
                   "The greatest strain of any direction, whichever that is at the place. In woven "
                   "cloth it is mostly shear: yarns that keep their length and turn by φ against "
                   "each other read about tan(φ/2) at 45° to them, 6 % at 7°, while a lead along "
                   "either yarn is not stretched at all.",
               .formula = "larger singular value of F, minus 1",
               .source = "docs/theory/sensor_metrics.md 6",
               .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
                 return triangle_strain(cloth.yarns).max;
               })};
  MapArray min{.style = strain_style("strain_min", "Least principal strain", "strain-min"),
               .meaning =
                   "The least strain of any direction; below zero the cloth is sheared: turned "
                   "yarns read about −tan(φ/2). Fine waves are drawn straight (map crimp).",
               .formula = "smaller singular value of F, minus 1",
               .source = "docs/theory/sensor_metrics.md 6",
               .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
                 return triangle_strain(cloth.yarns).min;
               })};
  MapArray slack{
      .style = {.array = "slack",
                .title = "Share of slack cloth",
                .map = "slack",
                .pictured = false,
                .companion = true},
      .meaning =
          "Share of the triangles round a point that are shortened by more than 0.5 % in some "
          "direction: cloth that is buckled within an element, on which no strain sensor reads.",
      .formula = "mean of [smaller singular value of F < 0.995] by flat area, waves as they are",
      .source = "docs/theory/sensor_metrics.md 6",
      .read = ReadCloth([](const ClothStrain& cloth, const Vec2&) {
        return slack_of(triangle_strain(cloth.shape));
      }),
      .metrics = {{"slack", "share of the footprint that is buckled", OverFootprint::mean,
                   OverStates::greatest}}};
  max.style.pictured = min.style.pictured = false;
  min.style.companion = true;
  return {.name = "principal-strain",
          .arrays = {vertical, max, min, slack},
          .by_default = true,
          .needs_material = true,
          .made_with = "strain"};
}

}  // namespace loosefit::maps
