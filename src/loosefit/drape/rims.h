#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/openings.h"
#include "loosefit/fabric/material.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// Elongation at which the toughest wovens tear [–]: of apparel wovens 10 to 35 % are published
/// (docs/theory/materials.md 8; recalled). Knits tear later; theirs is no safe yes.
inline constexpr double kTears = 0.35;

/// Strain that cloth bears [–], by its valid strain and its stretch, 0 where they are not stated:
/// kTears, or what is stated where that is more. The end of a measured curve is where a test
/// ended, not where the cloth tore. 0 where nothing is stated.
double borne_strain(double valid, double stretch);

/// The curve that decides how far an opening lets a body pass: the edge of the cloth. Of an edge
/// that is softer than the garment's fabric, as an elastic waistband, it is the seam by which that
/// gathers the fabric, for it gives until the fabric lies flat; of a hood it is the neckline.
struct Rim {
  Opening opening;
  std::string name;  ///< "the neck", "the left cuff", "the waist"
  /// Its pieces in the flat pattern: vertices of an edge, and the way from one to the other along
  /// (weft, warp) [m].
  struct Part {
    int from, to;
    Vec2 way;
  };
  std::vector<Part> parts;

  /// Length as cut [m].
  double cut() const;
  /// Length with the warp and the weft elongated by so much and sheared by so much [rad], each part
  /// to the side that makes it longer [m]: with a = (1 + weft) |u| and b = (1 + warp) |v| of a part
  /// Σ √(a² + b² + 2 a b sin shear).
  double stretched(double warp, double weft, double shear) const;
  /// As far as the material is known to give (Material::gives_warp, gives_weft, valid_shear) [m].
  double opened(const fabric::Material& material) const;
  /// As far as the material bears (borne_strain) [m].
  double borne(const fabric::Material& material) const;
  /// Whether the material states how far it gives in the directions that the rim runs in.
  bool is_stated(const fabric::Material& material) const;
  /// Length at x [m].
  double length(const std::vector<Vec3>& x) const;
};

/// The rims of all openings of a garment, in the order of garment_openings, for this wearer.
std::vector<Rim> garment_rims(const garment::Garment& garment, const pattern::Pattern& pattern,
                              const body::PosedBody& body);

/// Rims that are longer at x than the material bears, as sentences: the cloth would tear there, or
/// nobody would get into it.
std::vector<std::string> overstretched_rims(const std::vector<Rim>& rims,
                                            const std::vector<Vec3>& x,
                                            const fabric::Material& material);

}  // namespace loosefit::drape
