#pragma once
#include <string>

namespace loosefit::pattern {

struct Panel;

/// What the name of a piece or of a line says, in English, German, French, Spanish, Italian,
/// Portuguese and Dutch, and in the short codes of apparel programs (FR, BK, SL, …). Several may be
/// said at once: "front_sleeve_L".
struct PieceWords {
  bool front = false, back = false, left = false, right = false;
  bool sleeve = false, leg = false, skirt = false, yoke = false, pocket = false, hood = false;
  bool top = false;     ///< of what is worn on the trunk: bodice, shirt, poncho
  bool centre = false;  ///< a strip between halves
  bool neck = false, armhole = false, cuff = false, waist = false,
       hem = false;                                               ///< of bands, ribs and collars
  bool grain = false, fold = false, notch = false, seam = false;  ///< of lines
  bool hole = false;   ///< an opening cut out of a piece, not a buttonhole
  bool sheet = false;  ///< frame, legend, test square: no part of a garment
};

/// Words begin at a capital letter after a small one and at everything that is no letter.
/// A left or right hand may be a letter before what the piece is, with f or b for front and back
/// between them: "Lback", "rfsleeve".
PieceWords words_of(const std::string& name);

/// What is said of a piece: by its part, where its draft or the side file of its pattern tells that
/// (Panel::part), else by its name; and by its label.
PieceWords words_of(const Panel& panel);

/// Whether a piece of a garment is named, not only a hand or a line.
bool names_a_piece(const PieceWords& words);
/// The same, or a whole garment: a tunic, a poncho.
bool names_cloth(const PieceWords& words);

}  // namespace loosefit::pattern
