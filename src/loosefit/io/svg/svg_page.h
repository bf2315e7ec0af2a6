#pragma once
#include <string>

#include "loosefit/base/types.h"
#include "loosefit/io/pieces/file_units.h"
#include "loosefit/io/xml_tree.h"

namespace loosefit::io {

/// The page of an SVG file and the lengths on it.
struct SvgPage {
  PageUnit unit;                                 ///< of the drawing
  double per_inch = 96;                          ///< pixels of the program that wrote the file
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< [units]; equal: not said

  /// An attribute that is a length, in units of the drawing; a percentage is one of the page.
  /// `file` only appears in messages. \throws InvalidInput for what is no length of at most 1e7.
  double length(const XmlElement& element, const std::string& key, const std::string& file,
                double fallback = 0) const;
};

/// Width and height with viewBox (W3C SVG 1.1, 7.7 and 7.10) say the unit; without a length there,
/// the pixel of the program: 1/90 inch in Sodipodi and Inkscape up to 0.91 (release notes of 0.92),
/// 1/96 from 0.92 on, 1/72 in Adobe Illustrator; millimetres in FreeSewing.
/// \param text  of the file, for the program's note \throws InvalidInput with the line.
SvgPage page_of(const XmlElement& root, const std::string& text, const std::string& file);

}  // namespace loosefit::io
