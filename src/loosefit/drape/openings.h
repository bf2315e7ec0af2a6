#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/garment/garment.h"
#include "loosefit/kinds/opening_use.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// A closed edge of a garment that a limb may go through.
struct Opening {
  kinds::OpeningUse use = kinds::OpeningUse::unknown;
  std::vector<int> loop;              ///< vertices in order
  double girth = 0;                   ///< of the flat pieces [m]
  Vec3 placed = Vec3::Zero();         ///< its middle where the pattern places the pieces [m]
  int piece = 0;                      ///< connected piece of cloth; equal for openings of the same
  LimbNumbers round = kRoundNothing;  ///< for a limb: which
  /// For a limb: it goes round it where the pattern places it, too.
  bool placed_round = false;
  bool at_waist = false;  ///< an edge is labelled "lower_interface"
  bool at_chest = false;  ///< an edge is labelled "strapless_top"
  /// All pieces of its cloth are of legs, skirts or waistbands by label or name.
  bool of_legs = false;
  bool of_waistband = false;  ///< of_legs, and its edges are of waistbands by name
  bool is_cut_hole = false;   ///< it is cut into a piece

  /// Labels or names say that it is the upper end of what it belongs to.
  bool is_named_top() const { return at_waist || at_chest || of_waistband; }
};

/// Whether `a`, of two ends of a tube, is the upper one: by what labels and names say (a waistband,
/// the top of a strapless dress), else by where the pattern places it.
bool is_upper_end(const Opening& a, const Opening& b);

/// The openings, in the order of their first vertices. What each was made for is told by the kind
/// of the garment (GarmentKind::openings) or, where that does not know, by how they lie to each
/// other where the pattern places its pieces, whatever wearer that was made for, and by the labels
/// of pieces ("arm", "leg"): a pair beside the middle between a neck and a hem are arms, a pair
/// below a single opening are legs, a second pair below the first are legs too, two in the middle
/// alone are the ends of a tube round the trunk. Of three, the lowest in the middle, a smaller one
/// beside the middle that comes up to the shoulder is the only armhole, where the third comes down
/// beside it. Cloth `of_legs` has no neck and no armholes: holes at its sides between its ends are
/// slits, for nothing. An edge that runs from top to bottom is an open front. A hole cut into a
/// piece is for nothing where the other openings say without it what they are for. Holes that no
/// hand goes through (8 cm) are left out, unless the kind knows what they are for or a pair of them
/// are the ends of sleeves or legs by the labels of their pieces.
std::vector<Opening> garment_openings(const garment::Garment& garment,
                                      const pattern::Pattern& pattern);

/// The same where the wearer tells what pieces of cloth with one or two openings are for: what the
/// upper opening goes round where the pattern is placed on a wearer in rest posture. Of two: the
/// trunk: a skirt or a strapless dress; the neck: a cape or a poncho, unless it is wider than 0.9
/// of the chest or of legs, a skirt that was placed for somebody taller; one limb, unless it is too
/// wide for one: a stocking, an arm band, above the neck a head band; anything else, as of a
/// pattern that was placed for another wearer: what goes through both ends. Of one that goes round
/// one limb: a sock, a mitten, a hat. A narrow piece beside the middle of the body that goes round
/// nothing is for the arm or leg of that side, as its label says, else for the nearer one; one
/// above the neck is for the head. Labels of edges come before. A hole cut into a piece is left out
/// here too, unless a piece with a single edge says nothing without it or is too wide for a limb.
std::vector<Opening> garment_openings(const garment::Garment& garment,
                                      const pattern::Pattern& pattern, const body::PosedBody& body);

/// Whether cloth goes between the soles and the floor, by its openings as the wearer tells them: a
/// piece for one leg with a single edge, as a sock, or one for more of the body that is closed
/// below its edges where the pattern places the feet, as tights.
bool goes_under_soles(const garment::Garment& garment, const pattern::Pattern& pattern,
                      const std::vector<Opening>& openings);

/// Whether it is the edge of a jacket that is open in front: of `all` openings, the longest one of
/// unknown use of a piece with armholes and no neck.
bool is_open_front(const Opening& edge, const std::vector<Opening>& all);

/// The connected piece of cloth to which each vertex belongs, by one of its vertices.
std::vector<int> pieces_of_cloth(const garment::Garment& garment);

/// Chest girth of a wearer [m]: as measured, else by its usual share of the stature.
double chest_girth(const body::Body& body, const RestLevels& levels);

/// Of the chest's girth, tubes that were not made for the chest.
inline constexpr double kForTheWaist = 0.9;

/// Vertices where the pattern places the pieces, seams at the mean of their sides [m]. Empty when
/// the pattern lacks a piece.
std::vector<Vec3> placed_by_pattern(const garment::Garment& garment,
                                    const pattern::Pattern& pattern);

/// Vertices on all edges of the garment with this GarmentCode label.
std::vector<int> labelled_vertices(const garment::Garment& garment, const pattern::Pattern& pattern,
                                   const std::string& label);

}  // namespace loosefit::drape
