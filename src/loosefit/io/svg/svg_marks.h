#pragma once
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"
#include "loosefit/io/pieces/left_out.h"
#include "loosefit/io/svg/svg_document.h"

namespace loosefit::io {

/// The pieces of a drawing and where they lie, for what belongs to them.
struct SvgPlaces {
  std::vector<int> groups;                  ///< per piece: the group that is its own; −1
  std::vector<std::vector<Vec2>> outlines;  ///< per piece [m]

  /// Index of the piece in whose own group something stands, or in which or next to which it lies
  /// (within 3 cm); −1. \param at [m]; none: its place is not known
  int piece_of(const std::vector<int>& round, const std::optional<Vec2>& at) const;
};

/// Gives grain lines, fold lines and notches to the pieces that they lie in or beside; tells those
/// that belong to none. \param unit of the drawing [m]
void give_marks(const SvgDocument& document, double unit, const std::vector<const SvgShape*>& marks,
                const SvgPlaces& places, std::vector<CountedPiece>& pieces, LeftOut& left);

/// Reads how often pieces are cut: of attributes, titles, labels and texts of a piece, then of the
/// groups round it, the first one that says so. Tells texts that speak of a fold where no line
/// marks one, and those that may count and are not understood or belong to no piece. \param shapes
/// per piece; null: it is made of several
void give_counts(const SvgDocument& document, double unit,
                 const std::vector<const SvgShape*>& shapes, const SvgPlaces& places,
                 std::vector<CountedPiece>& pieces, LeftOut& left);

}  // namespace loosefit::io
