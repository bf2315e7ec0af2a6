#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::validate {

/// Area [m²] of the vertical projection (the shadow from straight above) of a triangulated surface:
/// the union of its projected triangles, whatever overlaps. Lines `spacing` [m] apart are cut with
/// every triangle and the union of the cuts is measured exactly, so the only error is that of the
/// midpoint rule across the lines: below (spacing / size)² of the area for a smooth outline.
double shadow_area(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles,
                   double spacing = 2.5e-4);

/// Cusick's drape coefficient (Cusick 1965; ISO 9073-9): (A_shadow − A_disc)/(A_specimen − A_disc)
/// of a specimen hanging over a disc; 1 for a board, 0 for cloth that hangs straight down. Areas in
/// m². \throws InvalidInput unless 0 < disc < specimen.
double drape_coefficient(double shadow, double disc, double specimen);

/// Folds of a draped rim.
struct Folds {
  int count = 0;         ///< harmonic of the rim's distance from the axis with most power, 1 … 20
  double amplitude = 0;  ///< of that harmonic [m]
  double share = 0;      ///< of the power in all harmonics but the mean: 1 = n equal sine folds
};
/// From the rim's points and their angles in the flat specimen [rad, increasing], axis z through
/// the origin. The harmonics are those of a trapezoidal sum over the angle.
Folds count_folds(const std::vector<Vec3>& rim, const std::vector<double>& angle);

}  // namespace loosefit::validate
