#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/file_units.h"
#include "loosefit/io/svg/svg_path.h"

namespace loosefit::io {

/// A thing that is drawn, in the units of the drawing with all transforms applied, y down.
struct SvgShape {
  std::string kind;         ///< element: "path", "rect", …
  std::string id;           ///< may be empty
  std::string label;        ///< inkscape:label; may be empty
  std::string classes;      ///< as the file has them
  std::string marker;       ///< marker-start, else marker-end
  std::vector<int> groups;  ///< indices into SvgDocument::groups round it, the outermost first
  int line = 0;             ///< of the file
  std::vector<SvgRun> runs;
};

struct SvgGroup {
  std::string id, label;
  bool layer = false;  ///< a layer of Inkscape
  SvgAffine place;     ///< of what is in it
};

/// What an SVG file draws.
struct SvgDocument {
  std::vector<SvgShape> shapes;
  std::vector<SvgGroup> groups;
  PageUnit unit;                                 ///< of the drawing
  bool freesewing = false;                       ///< FreeSewing wrote it
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< of the page; equal: not said
  std::vector<std::string> unused;               ///< what is not read, by name, with the reason
};

/// Shapes of path, rect, circle, ellipse, line, polyline, polygon and use (of one of these, of a
/// group or of a symbol), with the transforms of all groups round them. What attributes, styles or
/// style sheets hide (display, visibility; io/svg/svg_style.h) and what nothing uses of definitions
/// and symbols is left out and named; clip paths, masks and markers are passed over.
/// Unit: width and height with viewBox (W3C SVG 1.1, 7.7 and 7.10); without a length there, the
/// pixel of the program: 1/90 inch in Inkscape up to 0.91, 1/96 from 0.92 on, 1/72 in Adobe
/// Illustrator; millimetres in FreeSewing. `file` only appears in messages.
/// \throws InvalidInput with the line.
SvgDocument parse_svg(const std::string& text, const std::string& file);

}  // namespace loosefit::io
