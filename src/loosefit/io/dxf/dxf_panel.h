#pragma once
#include <string>
#include <vector>

#include "loosefit/io/dxf/dxf_pieces.h"
#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// A piece of a DXF file as a panel, or why it cannot be one.
struct DxfPanel {
  pattern::Panel
      panel;  ///< grain along y, counter-clockwise, edges e1, e2, …, low corner at (·, 0)
  std::vector<pattern::Notch> notches;  ///< of panel 0
  std::string fault;                    ///< empty: the panel is sound
  std::vector<std::string> notes;       ///< what had to be assumed for it
  bool on_sew_line = false;             ///< the outline is where it is sewn, not where it is cut
  bool unfolded = false;                ///< from a half piece
};

/// Outline: the sew line (layer 14) where it is closed and within the boundary (layer 1); else a
/// closed line on layer 8 that lies a seam allowance inside the boundary (Valentina); else the
/// boundary, or its finer copy on layer 84 where that is one. Edges: the lines the outline is drawn
/// with, closed ones cut at their corners. A half piece is unfolded at the mirror line (layer 6).
/// The grain line (layer 7) is turned to y. Notches are on layers 4 and 80 to 83.
/// Layers: ASTM D6673-10. \param metre length of one file unit [m]
DxfPanel make_panel(const DxfPiece& piece, double metre);

/// The piece turned over, x → −x: edges keep their names.
DxfPanel mirrored_piece(const DxfPanel& piece);

}  // namespace loosefit::io
