#pragma once
#include <vector>

#include "loosefit/fabric/stress_curve.h"

namespace loosefit::support {

/// The measured wool of docs/theory/materials.md 4, w = 0.15 kg/m²: second Piola-Kirchhoff stress
/// [N/m] against Green strain.
inline const std::vector<fabric::CurvePoint>& wool_weft_green() {
  static const std::vector<fabric::CurvePoint> kPoints = {
      {0.0041, 1.49},  {0.0204, 24.5},  {0.0408, 67.3},   {0.0612, 184.0},
      {0.0816, 365.7}, {0.1020, 759.1}, {0.1142, 1052.2},
  };
  return kPoints;
}
inline const std::vector<fabric::CurvePoint>& wool_warp_green() {
  static const std::vector<fabric::CurvePoint> kPoints = {
      {0.00049, 8.00},   {0.00243, 41.9},   {0.00486, 119.4},  {0.00729, 416.9},
      {0.00972, 1069.3}, {0.01215, 2133.3}, {0.01361, 2998.0},
  };
  return kPoints;
}
inline const std::vector<fabric::CurvePoint>& wool_shear() {
  static const std::vector<fabric::CurvePoint> kPoints = {
      {0.01, 1.0},  {0.03, 5.0},  {0.05, 13.0}, {0.07, 20.5},
      {0.10, 33.0}, {0.12, 44.5}, {0.14, 60.0},
  };
  return kPoints;
}

inline fabric::Material wool_sample() {
  fabric::Material m;
  m.areal_density = 0.15;
  m.poisson = 0;
  for (const fabric::CurvePoint& p : wool_weft_green())
    m.curve_weft.push_back(fabric::force_of_green(p.strain, p.force));
  for (const fabric::CurvePoint& p : wool_warp_green())
    m.curve_warp.push_back(fabric::force_of_green(p.strain, p.force));
  m.curve_shear = wool_shear();
  return m;
}

}  // namespace loosefit::support
