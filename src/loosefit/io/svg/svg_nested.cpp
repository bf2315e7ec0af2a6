#include "loosefit/io/svg/svg_nested.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/io/svg/svg_labels.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kWholePage = 0.95;  // of its width and height
constexpr double kInHole = 1e-3;  // a hole lies in a piece with a point that is so deep in it [m]
// Sides of squares by which the scale of a print is checked [m]: whole centimetres and inches.
constexpr double kTestSides[] = {0.025, 0.0254, 0.03, 0.04, 0.05, 0.0508, 0.0762, 0.1, 0.1016, 0.2};
constexpr double kSameSide = 3e-4;     // as drawn [m]
constexpr double kShareOfTest = 0.15;  // of the largest piece, at most
constexpr double kTextBeside = 0.03;   // of a text from the line that it names [m]

bool is_rectangle(const SvgLine& run) {
  return run.shape->kind == "rect" || (run.line.points.size() == 4 && run.line.nodes.size() <= 5);
}

/// Whether a rectangle covers several other lines. Nearly as large are only other sizes of it,
/// which lie in each other.
bool covers_others(const SvgDocument& document, const std::vector<SvgLine>& closed, std::size_t i) {
  int others = 0, nearly_as_large = 0;
  for (std::size_t j = 0; j < closed.size() && others + nearly_as_large < 2; ++j) {
    if (j == i || closed[j].area >= closed[i].area || closed[j].shape == closed[i].shape ||
        is_called_hole(document, *closed[j].shape) ||
        words_of_shape(*closed[j].shape).seam != words_of_shape(*closed[i].shape).seam ||
        !lies_inside(closed[j].line.points, closed[i].line.points))
      continue;
    if (closed[j].area > kShareOfPiece * closed[i].area)
      nearly_as_large = 1;
    else
      ++others;
  }
  return others + nearly_as_large >= 2;
}

/// A small square without a name that is as large as those by which prints are checked, or with a
/// text in it that says so; not with one that counts it.
bool is_test_square(const SvgDocument& document, double unit, const SvgLine& line, double largest) {
  const std::string name = own_name(line.shape->label, line.shape->id);
  if (line.area > kShareOfTest * largest || !line.shape->quantity.empty() || !name.empty())
    return false;
  const Vec2 size = box_of(line.line.points).sizes();
  if (std::abs(size.x() - size.y()) > kSameSide) return false;
  bool square = std::abs(size.x() * size.y() - line.area) < 2 * kSameSide * size.x();
  for (const SvgText& text : document.texts) {
    if (!text.at || !pattern::inside_polygon(line.line.points, in_metres({*text.at}, unit)[0]))
      continue;
    if (find_quantity(text.words) || names_cloth(pattern::words_of(text.words))) return false;
    const std::string words = in_words(text.words);
    for (const char* is :
         {" test ", " scale ", " check ", " control ", " calibration ", " square "})
      if (words.find(is) != std::string::npos) return square;
  }
  return square && std::any_of(std::begin(kTestSides), std::end(kTestSides),
                               [&](double side) { return std::abs(size.x() - side) < kSameSide; });
}

/// "Opening" and "neckline" stand at edges as well.
bool speaks_of_cutting(const std::string& text) {
  const std::string words = in_words(text);
  return words.find("hole ") != std::string::npos || words.find("loch ") != std::string::npos ||
         words.find(" cutout ") != std::string::npos;
}

/// A part of it lies in the other line.
bool reaches_into(const std::vector<Vec2>& hole, const std::vector<Vec2>& outer) {
  return std::any_of(hole.begin(), hole.end(), [&](const Vec2& p) {
    return pattern::inside_polygon(outer, p) &&
           (pattern::closest_on_polygon(outer, p) - p).norm() > kInHole;
  });
}

}  // namespace

std::vector<SvgLine> without_frames(const SvgDocument& document, std::vector<SvgLine> closed,
                                    double unit, LeftOut& left) {
  const Vec2 page = unit * (document.high - document.low);
  double largest = 0;
  for (const SvgLine& line : closed) largest = std::max(largest, line.area);
  std::vector<std::string> why(closed.size());
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (!is_rectangle(closed[i])) continue;
    const pattern::PieceWords words = words_of_shape(*closed[i].shape);
    if (names_cloth(words)) continue;
    const bool in_a_piece = names_cloth(words_of_group(document, *closed[i].shape));
    const Vec2 size = box_of(closed[i].line.points).sizes();
    if (page.minCoeff() > 0 && size.x() > kWholePage * page.x() && size.y() > kWholePage * page.y())
      why[i] = "taken for a frame, since it covers the page";
    else if (!in_a_piece && covers_others(document, closed, i))
      why[i] = "taken for a frame, since it covers several other outlines";
  }
  const auto in_a_line = [&](const SvgLine& line) {
    for (std::size_t j = 0; j < closed.size(); ++j)
      if (why[j].empty() && closed[j].area > line.area &&
          lies_inside(line.line.points, closed[j].line.points))
        return true;
    return false;
  };
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (why[i].empty() && is_rectangle(closed[i]) &&
        !names_cloth(words_of_group(document, *closed[i].shape)) &&
        is_test_square(document, unit, closed[i], largest) && !in_a_line(closed[i]))
      why[i] = "taken for a test square by its size";
  std::vector<SvgLine> kept;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (why[i].empty()) {
      kept.push_back(std::move(closed[i]));
      continue;
    }
    const SvgShape& shape = *closed[i].shape;
    const Vec2 size = box_of(closed[i].line.points).sizes();
    left.count("frames, legends and test squares", called_line(shape));
    left.warnings.push_back(
        fmt::format("rectangle {} of {:.4g} x {:.4g} mm: left out, {}; called after a piece "
                    "(front, back, tunic, gusset) it is one",
                    called_line(shape), 1e3 * size.x(), 1e3 * size.y(), why[i]));
  }
  return kept;
}

std::vector<int> lines_round(const SvgDocument& document, const std::vector<SvgLine>& closed) {
  std::vector<int> within(closed.size(), -1);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const auto round = [&](std::size_t j, bool partly) {
      return i != j && closed[j].area >= kSmallestPiece &&
             (closed[i].area < closed[j].area || (closed[i].area == closed[j].area && i > j)) &&
             (partly ? reaches_into(closed[i].line.points, closed[j].line.points)
                     : lies_inside(closed[i].line.points, closed[j].line.points));
    };
    for (std::size_t j = 0; j < closed.size() && within[i] < 0; ++j)
      if (round(j, false)) within[i] = static_cast<int>(j);
    if (within[i] >= 0 || !is_called_hole(document, *closed[i].shape)) continue;
    for (std::size_t j = 0; j < closed.size() && within[i] < 0; ++j)
      if (round(j, true)) within[i] = static_cast<int>(j);
  }
  return within;
}

std::vector<std::string> holes_by_text(const SvgDocument& document, double unit,
                                       const std::vector<SvgLine>& closed,
                                       const std::vector<int>& within, LeftOut& left) {
  std::vector<std::string> names(closed.size());
  for (const SvgText& text : document.texts) {
    if (!pattern::words_of(text.words).hole || !text.at) continue;
    const Vec2 at = in_metres({*text.at}, unit)[0];
    std::size_t best = closed.size();
    double least = kTextBeside;
    for (std::size_t i = 0; i < closed.size(); ++i) {
      if (within[i] < 0 || closed[i].area > kShareOfPiece * closed[within[i]].area) continue;
      const std::vector<Vec2>& points = closed[i].line.points;
      const double d = pattern::inside_polygon(points, at)
                           ? 0
                           : (pattern::closest_on_polygon(points, at) - at).norm();
      if (d < least) least = d, best = i;
    }
    if (best < closed.size())
      names[best] = trimmed_words(text.words);
    else if (speaks_of_cutting(text.words))
      left.tell("text \"" + printable(trimmed_words(text.words), 60) + "\" at line " +
                std::to_string(text.line) +
                ": it speaks of a hole, but no closed line in a piece lies there: nothing is cut");
  }
  return names;
}

}  // namespace loosefit::io
