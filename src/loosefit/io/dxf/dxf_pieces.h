#pragma once
#include <string>
#include <vector>

#include "loosefit/io/dxf/dxf_document.h"
#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// A block that has an outline, with what its texts say.
struct DxfPiece {
  std::string name;  ///< "Piece Name"; else of the block, without the size
  std::string size;  ///< "Size"; may be empty
  std::string category, fabric, annotation, quantity;  ///< as the file has them
  std::vector<std::string> texts;                      ///< without a key: "CUT 2"
  const DxfBlock* block = nullptr;
};

/// A pattern: its pieces in all sizes, and what the texts of the style say.
struct DxfStyle {
  std::string name, sample_size, units;
  std::string maker;  ///< "Author" and "Product", the program that wrote the file
  std::vector<DxfPiece> pieces;
  std::vector<std::string> sizes;  ///< in the order of the file; pieces without one are not counted
};

/// Finds pieces and texts (ASTM D6673, "key: value" in any letter case). Keeps pointers into the
/// document.
DxfStyle find_pieces(const DxfDocument& document);

/// The text that says that the piece is cut from another cloth than the garment's, as linings,
/// interlinings and fusibles are: 'Fabric "LINING"', "Tela de forro", "BODY LINING". Empty where
/// none says so, where another part of that text names the garment's cloth ("Self, Lining"; parts
/// end at , ; + & / and words for "and", in an annotation at numbers too), and where the fabric
/// is the garment's own by a word for it that is not one of any cloth. An annotation has to say
/// nothing else.
std::string of_other_cloth(const DxfPiece& piece);

/// Whether a text of this key is read by find_pieces.
bool is_known_text(const std::string& text);

}  // namespace loosefit::io
