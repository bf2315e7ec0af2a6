#pragma once
#include <optional>
#include <string>

namespace loosefit::io {

/// How often a piece is cut.
struct PieceCount {
  int as_drawn = 1, mirrored = 0;
  std::string said;   ///< the words of the file that say so; empty: none do
  std::string doubt;  ///< how these were read, where they may mean something else; empty: plain
};

/// The value of a key that counts pieces: "2", "1,1" (as drawn, mirrored), "1+1", "2,0" and "2.0"
/// (the number 2), "0" (optional), and all that find_quantity knows. An even number is cut half as
/// drawn and half mirrored. Numbers go up to 1000. None: no count.
std::optional<PieceCount> read_quantity(const std::string& value);

/// A count in a text that says other things as well, by its words: "cut 2", "Qty: 2", "x2", "2x",
/// "2 pcs", "1 pair", "cut two, mirrored", "cut 2 identical" (none mirrored), in English, German,
/// French, Spanish, Italian, Portuguese and Dutch. A count of a lining, an interlining or a fusible
/// is none of the garment's ("cut 2 from lining"). Sizes (2X, 100 x 100 mm) and lengths (2 cm) are
/// no counts. "1 left, 1 right", "1+1" and "left and right" after a word for cutting name both
/// hands, as "1 + mirror" and "1 and 1 reversed" do. \param rest
/// what the text says beside the count, for the name of the piece; may be null
std::optional<PieceCount> find_quantity(const std::string& text, std::string* rest = nullptr);

/// Whether a key, without regard to case, counts pieces: quantity, qty, cut, No. of pieces, …
bool counts_pieces(const std::string& key);

/// Whether a text has words of a count in it that find_quantity does not understand: "cut both",
/// "2 reversed".
bool speaks_of_count(const std::string& text);

}  // namespace loosefit::io
