#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/open_seams.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// Panels round a body, before they are sewn.
struct ArrangedPanels {
  std::vector<Vec3> x;  ///< vertices of open.garment [m]
  /// Per panel of open.garment: unit normal of its outside; zero of one that is rolled round a
  /// limb, whose triangles have normals of their own.
  std::vector<Vec3> outside;
  std::vector<char> of_trunk;  ///< per panel
  /// Vertices at which a wearer would hold the garment up: those of seams between panels with
  /// armholes, above these; of a cape, of seams beside its neck.
  std::vector<int> shoulders;
  /// Some of them are worn on one limb by themselves, which nothing holds up while they are sewn.
  bool on_limbs = false;
  bool under_soles = false;  ///< some go between the soles and the floor (goes_under_soles)
};

/// Arranges the panels of a garment round this body, whatever body and posture their placement was
/// made for. The placement says how panels lie to each other: before, behind and beside. Levels of
/// the body say where the whole goes:
///
/// * shoulders: the highest point of the panels with armholes comes to the line from neck to
/// shoulder;
/// * else the crotch, where there are legs; else the upper opening of a tube, to the waist, to the
///   level where it is as wide as the body, or to the chest if it was made for that;
/// * a height that agrees within 3 cm, or a waist between waist and hips, is left as placed;
/// * panels of an arm (panel_roles) go with the arm, bent as it is: along its line, their armhole
///   next to that of the trunk;
/// * panels of legs are sheared to go along the legs, and squeezed to end above the feet;
/// * what is wider than the way between the hands is squeezed to lie between them, what is narrower
///   than the body below its crotch is stretched to lie round it;
/// * the neck of a cape comes to the neck, over the arms;
/// * pieces that are worn on one limb go with it (limb_pieces.h);
/// * a tube in one piece is rolled round the trunk, a leg in one piece is laid round the outside of
///   body and leg (wrapped_leg.h);
/// * bands in one piece, sewn to themselves, are rings round what they are sewn to (band_ring.h);
/// * then every other panel moves along its outside normal until it is clear of the body.
///
/// Round a body without joints panels are only moved outwards, by up to 0.3 m. \throws
/// GeometryError when the pattern lacks a panel.
ArrangedPanels arrange_panels(const garment::Garment& sewn, const garment::OpenSeams& open,
                              const pattern::Pattern& pattern, const body::PosedBody& body);

}  // namespace loosefit::drape
