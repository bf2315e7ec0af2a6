#pragma once
#include <string>
#include <vector>

#include "loosefit/io/svg/svg_page.h"
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
  std::string quantity;           ///< an attribute that counts it (quantity.h); may be empty
  std::vector<std::string> said;  ///< its title and description
  std::string unseen;             ///< why a viewer shows nothing of it; empty: it does
};

/// A text of a drawing.
struct SvgText {
  std::string words;
  std::optional<Vec2> at;   ///< where it begins; none: along a path
  std::vector<int> groups;  ///< as SvgShape::groups
  int line = 0;
};

struct SvgGroup {
  std::string id, label;
  bool layer = false;         ///< a layer of Inkscape
  SvgAffine place;            ///< of what is in it
  std::string quantity = {};  ///< as those of SvgShape
  std::vector<std::string> said = {};
};

/// What an SVG file draws.
struct SvgDocument : SvgPage {
  std::vector<SvgShape> shapes;
  std::vector<SvgText> texts;
  std::vector<SvgGroup> groups;
  bool freesewing = false;          ///< FreeSewing wrote it
  std::vector<std::string> unused;  ///< what is not read, by name, with the reason
};

/// Shapes of path, rect, circle, ellipse, line, polyline, polygon and use (of one of these, of a
/// group or of a symbol), with the transforms of all groups round them. What attributes, styles or
/// style sheets hide (display, visibility; io/svg/svg_style.h) and what nothing uses of definitions
/// and symbols is left out and named; clip paths, masks and markers are passed over.
/// `file` only appears in messages. \throws InvalidInput with the line.
SvgDocument parse_svg(const std::string& text, const std::string& file);

}  // namespace loosefit::io
