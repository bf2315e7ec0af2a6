#pragma once
#include <optional>
#include <vector>

#include "loosefit/pattern/sections.h"

namespace loosefit::pattern {

/// What a piece is in a garment that is known by its topology.
enum class PieceRole {
  unknown,
  front,
  back,
  sleeve,
  half_sleeve,
  front_leg,
  back_leg,
  leg,
  front_skirt,
  back_skirt,
  side_skirt,
  hood,
  band
};

/// A piece, told by name and outline.
struct KnownPiece {
  PieceRole role = PieceRole::unknown;
  int side = 0;         ///< of the wearer: +1 left, −1 right, 0 across the middle
  bool upright = true;  ///< y points upwards; otherwise the piece stands on its head
  /// Of trunks: hem, side, armhole, shoulder, neck, shoulder, armhole, side; of raglan shirts hem,
  /// side, raglan, neck, raglan, side. Of sleeves: cuff, underarm, cap, underarm; cuff, underarm,
  /// raglan, neck, raglan, underarm; of halves cap, underarm, cuff, seam on top. Of skirts: hem,
  /// side, waist, side. Of legs: hem and, in the order of the outline, the next ones of hem,
  /// outseam, waist, crotch, inseam or the other way round. Of legs in one piece: hem, inseam,
  /// crotch, waist, crotch, inseam. Of the left half of a hood neck, back, face, of the right one
  /// neck, face, back.
  std::vector<Section> sections;
};

/// Whether all sections of two pieces are as long and bulge as much, by 1 cm.
bool are_alike(const KnownPiece& a, const KnownPiece& b);

// What an outline may be, told by the number, lengths and shapes of its sections; nothing where it
// may not.

/// Eight sections that mirror each other about the first (hem, side, armhole, shoulder, neck, …) or
/// six (hem, side, raglan, neck, …).
std::optional<KnownPiece> as_trunk(const std::vector<Section>& sections);
/// Six sections: cuff, underarm, raglan, neck, raglan, underarm; the neck is the shortest.
std::optional<KnownPiece> as_raglan_sleeve(const std::vector<Section>& sections);
/// Four sections: cuff, underarm, cap, underarm.
std::optional<KnownPiece> as_sleeve(const std::vector<Section>& sections);
/// Four sections with equal sides: hem, side, waist, side; the warp runs up.
std::optional<KnownPiece> as_skirt(const std::vector<Section>& sections);
/// Five sections: hem, outseam, waist, crotch, inseam or the other way round; the crotch is cut out
/// most, the outseam longer than the hem or, of short trousers, steeper.
std::optional<KnownPiece> as_leg(const std::vector<Section>& sections);
/// Six sections: hem, inseam, crotch, waist, crotch, inseam; the crotches are cut out, the inseams
/// the longest pair that are alike.
std::optional<KnownPiece> as_whole_leg(const std::vector<Section>& sections);
/// Three sections: the one over the back of the head bulges most, the neck is the shorter of the
/// others. Sets `side`: on a left half the back comes next after the neck.
std::optional<KnownPiece> as_hood_half(const std::vector<Section>& sections);

/// The two sides and ends of a strip. The first side is the longer one, which a band is sewn on by:
/// one that is cut in a curve is narrower at its free edge. In the order of the outline: side,
/// first end, other side, second end.
struct Strip {
  Section side, first_end, other_side, second_end;
};
/// Four sections, in pairs that are alike, at least 2.5 times as long as wide, with straight ends.
std::optional<Strip> as_strip(const std::vector<Section>& sections);

}  // namespace loosefit::pattern
