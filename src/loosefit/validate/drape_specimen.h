#pragma once
#include "loosefit/validate/drape_coefficient.h"
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// A drape tester's geometry: a horizontal disc under a concentric circular specimen [m].
struct DrapeTester {
  double disc_radius = 0.09, specimen_radius = 0.15;  ///< Cusick 1965, ISO 9073-9
};

/// The circular specimen, sewn of the part over the disc and two half rings so that a line of
/// vertices lies on the disc's rim; the centre is at the origin of the pattern. What lies on the
/// disc is built in (Garment::triangle_built_in).
Specimen cut_drape_specimen(const DrapeTester& tester, double edge_length,
                            const fabric::Material& material);

/// A start with `folds` folds: outside the disc every radial line leans down by a mean of `lean`
/// [rad], swinging by `swing` [rad] from fold to fold.
std::function<Vec3(const Vec2&)> folded_start(const DrapeTester& tester, int folds,
                                              double lean = 0.6, double swing = 0.35);

/// What a draped specimen looks like.
struct DrapeReading {
  double coefficient = 0;  ///< [–]
  double energy = 0;       ///< [J], flat on the disc = 0
  Folds folds;
};
/// Disc and specimen areas are those of the flat mesh, so a flat specimen reads 1 on any mesh.
DrapeReading read_drape(const Bench& bench, const DrapeTester& tester);

/// Vertices on the disc and its rim: the cloth is clamped there.
std::vector<int> on_disc(const Specimen& specimen, const DrapeTester& tester);

}  // namespace loosefit::validate
