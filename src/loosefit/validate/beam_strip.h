#pragma once
#include <functional>
#include <vector>

#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// The fabric of all beam benchmarks: cotton of 120 g/m² with the bending rigidity of the paper
/// (docs/theory/materials.md 1), B = 4.41e-6 N m, hence a bending length of 15.5 mm. Membrane 2000
/// N/m and shear 1000 N/m without Poisson contraction: the tensions of these tests, at most 0.5
/// N/m, stretch it by less than 0.03 %, while it stays soft enough not to hinder triangles from
/// following a curve (membrane locking grows with K κ² h⁴/B). Bending without Poisson contraction,
/// so that a strip is a beam of rigidity B whatever its width. Thickness 10 µm: the references have
/// none, and layers that meet must not hold each other off. No viscosity.
fabric::Material beam_fabric();

/// A strip [0, length] × [0, width] of the flat pattern, cut in `panels` equal pieces that are sewn
/// end to end, with a piece of the same cloth sewn to each clamped end. The clamp pieces are built
/// in (Garment::triangle_built_in): their vertices, seam included, are to be held, and the strip
/// leaves the clamp line with the slope of the clamp.
struct ClampedStrip {
  Specimen specimen;
  double x0 = 0;                 ///< where it begins [m]
  double length = 0, width = 0;  ///< [m]
  std::vector<int> clamp;        ///< vertices of the clamp at the start
  std::vector<int> end_clamp;    ///< of the clamp at the end, when there is one
  std::vector<int> end;          ///< vertices on the line at the end of the last panel

  /// Share of the length at a flat position: 0 at the clamp, 1 at the end.
  double share(const Vec2& flat) const { return (flat[0] - x0) / length; }
};

enum class Ends {
  free,       ///< clamped at the start only
  clamped,    ///< a clamp piece at either end
  one_clamp,  ///< both ends sewn to one clamp piece, from either side: a tube
};

/// Length of a clamp piece along the strip [m].
double clamp_depth(Ends ends, double edge_length);

/// \throws as assemble does.
ClampedStrip cut_clamped_strip(double length, double width, double edge_length,
                               const fabric::Material& material, Ends ends = Ends::free,
                               int panels = 1);

/// Mean position of the vertices of a line across the strip, each weighing as much as the part of
/// the line that belongs to it [m].
Vec3 mean_of_line(const std::vector<int>& line, const std::vector<Vec2>& flat,
                  const particles::VectorField& x);
/// The same weights; they sum up to 1.
std::vector<double> line_weights(const std::vector<int>& line, const std::vector<Vec2>& flat);

}  // namespace loosefit::validate
