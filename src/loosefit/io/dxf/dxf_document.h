#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::io {

/// One thing that is drawn or written, in the units of the file.
struct DxfEntity {
  std::string kind;          ///< "LINE", "POLYLINE", "TEXT", …
  int layer = -1;            ///< its number; -1 when the layer's name is none
  int line = 0;              ///< of the file
  std::vector<Vec2> points;  ///< of lines and curves; the place of points and texts
  bool closed = false;       ///< the last point joins the first, which is not repeated
  std::string text;          ///< of texts; name of the block of an INSERT
  std::string hidden;        ///< why nobody sees it: "its layer is frozen"; empty: one does
};

/// A block: a piece of a pattern in one size.
struct DxfBlock {
  std::string name;
  int line = 0;
  std::vector<DxfEntity> entities;
  std::vector<DxfEntity> hidden;  ///< lines that may be cloth and that nobody sees; texts, corners,
                                  ///< notches, grain and mirror lines are entities all the same
};

/// What a DXF file draws. Blocks are kept by their place in the file, since names repeat.
struct DxfDocument {
  std::vector<DxfBlock> blocks;
  std::vector<DxfEntity> entities;  ///< outside of blocks
  std::optional<int> insunits;      ///< $INSUNITS of the header: 1 inch, 4 mm, 5 cm, 6 m
  std::optional<bool> metric;       ///< $MEASUREMENT of the header: 0 English, 1 metric
};

/// Reads sections HEADER, TABLES (layers that are off or frozen), BLOCKS and ENTITIES of a DXF text
/// file; all others are passed over. Points are taken from LINE, POLYLINE, LWPOLYLINE (with
/// bulges), ARC, CIRCLE, ELLIPSE and SPLINE (sampled every 2 degrees or 1/64 of a knot span), POINT
/// and TEXT; other kinds have none. Texts that are not UTF-8 are taken as Latin 1. `file` only
/// appears in messages. \throws InvalidInput naming line and entity: text that is no DXF, numbers
/// that are none, a
///         section, block or polyline without an end, a drawing that is scaled or seen from below.
/// Source: Autodesk, DXF Reference (group codes of the entities).
DxfDocument parse_dxf(const std::string& text, const std::string& file);

}  // namespace loosefit::io
