#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/pattern/known_garment.h"

namespace loosefit::pattern {

/// The way the outside of a piece looks: a side is beside trunk, leg or head, an arm that of a
/// sleeve in one piece, which is rolled round it.
enum class Facing { unknown, front, back, left_side, right_side, left_arm, right_arm };

/// Panel to our frame; `upright`: its y points up, along arms to the shoulder.
Mat3 facing_rotation(Facing facing, bool upright);

/// By panel: quarter turns counter-clockwise that set upright what lies otherwise in the drawing.
using QuarterTurns = std::map<int, int>;

/// Which way all pieces of a sewn pattern face.
struct PieceFacings {
  std::vector<Facing> of;         ///< per panel, none unknown where it is sewn to one that is told
  std::vector<char> half_sleeve;  ///< per panel: front or back of a sleeve
  std::vector<std::string> guessed;  ///< panels that only their seams tell
};

/// Pieces of a known garment face as what they are, others as their names and labels say. Halves of
/// a sleeve, which are sewn to each other and not to themselves, face as their name or else the
/// piece of the trunk with their longest seam. Sleeves in one piece that no name tells go along the
/// arm at whose side they are sewn to front and back. What is called left or right alone and sewn
/// to a front and a back, by lengths that differ by less than half, is a side. What is left follows
/// the neighbour with the longest seam. \throws GeometryError when nothing is told to be a front, a
/// back or a leg.
PieceFacings tell_facings(const Pattern& pattern, const KnownGarment& known,
                          const QuarterTurns& turns = {});

/// The other side of a seam between this panel and another one; null for other seams.
const Stitch::Side* other_side(const Stitch& stitch, int panel);

/// Whether it is half of a hood of a garment that is not known: called hood, and left or right.
bool is_named_half_of_hood(const Pattern& pattern, const KnownGarment& known, int panel);

}  // namespace loosefit::pattern
