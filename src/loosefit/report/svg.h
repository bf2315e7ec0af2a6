#pragma once
#include <string>

namespace loosefit::report {

/// Parts of inline SVG drawings; lengths in pixels, x to the right, y down.

/// The opening tag of a drawing that shrinks with the page; `label` is read out in its place.
std::string svg_open(double width, double height, const std::string& label);

/// `look`: stroke and other attributes, as SVG text.
std::string svg_line(double x1, double y1, double x2, double y2, const std::string& look);

/// `anchor`: start, middle or end; `content` is SVG already; `more`: further attributes, with a
/// space in front.
std::string svg_text(double x, double y, const std::string& anchor, const std::string& content,
                     const std::string& more = {});

}  // namespace loosefit::report
