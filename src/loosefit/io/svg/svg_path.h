#pragma once
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::io {

/// A run of lines and cubic curves as SVG draws it, in the units of the file, y down.
struct SvgRun {
  struct Segment {
    Vec2 first, second;  ///< control points of a curve
    Vec2 to;
    bool curve = false;
  };
  Vec2 start;
  std::vector<Segment> segments;
  bool closed = false;  ///< by a command, whatever lies between the ends

  Vec2 end() const { return segments.empty() ? start : segments.back().to; }
  void line_to(const Vec2& to) { segments.push_back({to, to, to, false}); }
  void curve_to(const Vec2& a, const Vec2& b, const Vec2& to) {
    segments.push_back({a, b, to, true});
  }
};

using SvgAffine = Eigen::Transform<double, 2, Eigen::Affine>;

/// Data of a path: M L H V C S Q T A Z, absolute and relative (W3C SVG 1.1, 8.3 and F.6).
/// Quadratic curves and arcs become cubic ones, arcs in parts of at most 30 degrees (1e-8 of their
/// radius). \throws InvalidInput what is no path data, with the character at which it stops being
/// some; file and line are for the message.
std::vector<SvgRun> parse_svg_path(const std::string& data, const std::string& file, int line);

/// matrix, translate, scale, rotate, skewX, skewY in a row (W3C SVG 1.1, 7.6). \throws InvalidInput
SvgAffine parse_svg_transform(const std::string& text, const std::string& file, int line);

/// Numbers with white space or commas between them. \throws InvalidInput
std::vector<double> parse_svg_numbers(const std::string& text, const std::string& file, int line,
                                      const std::string& key);

/// The runs of an ellipse and of a rectangle with round corners.
SvgRun svg_ellipse(const Vec2& centre, const Vec2& radii);
SvgRun svg_rectangle(const Vec2& corner, const Vec2& size, Vec2 radii);

SvgRun transformed(SvgRun run, const SvgAffine& by);

/// A run as points.
struct SampledRun {
  std::vector<Vec2> points;  ///< the first one is not repeated at the end of a closed run
  std::vector<Vec2> nodes;   ///< ends of segments
  bool closed = false;
};
/// Chords stay within `tolerance` of the curves, roughly; at most 400 a curve.
SampledRun sampled(const SvgRun& run, double tolerance);

}  // namespace loosefit::io
